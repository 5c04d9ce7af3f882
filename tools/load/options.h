// Takes the command line; gives which load to make.
#pragma once

#include "client/net/address.h"

#include <cstdint>
#include <functional>
#include <optional>
#include <string_view>
#include <sys/types.h>
#include <variant>

namespace billiards::tools {

enum class LoadMode : std::uint8_t {
    Play,      ///< Two players a table, and spectators spread over the tables.
    Idle,      ///< Tables that wait for a second player; spectators that do nothing but stay.
    Spectate,  ///< As Play, with every spectator at the first table.
    Slow,      ///< As Play, but the spectators stop reading once they are there.
    Garbage,   ///< Two players a table, and as many senders of nonsense as spectators were asked.
    Flap,      ///< As Play, but everybody drops the connection now and then, and comes back.
    /// As Play, until somebody else kills the server and starts it again: measures how soon
    /// everybody is back.
    Reconnect,
    Stall,  ///< As Play, and then again beside spectators that ask for much and read nothing.
};

std::string_view name_of(LoadMode mode);

struct LoadOptions {
    client::ServerAddress server;
    LoadMode mode = LoadMode::Play;
    int tables = 10;
    int spectators = 0;
    int stalled = 1;        ///< Stall: how many read nothing.
    double seconds = 30.0;  ///< Measured, once everybody is in place; Stall: twice.
    std::uint64_t seed = 1;
    double min_think_s = 2.0;
    double max_think_s = 6.0;
    double aims_per_s = 10.0;   ///< 0: aims are not shown.
    double drop_after_s = 4.0;  ///< Flap: the longest that a connection is kept.
    int connections_per_s = 1000;
    double gather_s = 60.0;          ///< After which it measures with those who are in place.
    std::function<void()> in_place;  ///< Called when the measuring begins; or null.
    std::optional<pid_t> server_pid;
    std::optional<client::ServerAddress> http;
};

/// The options, or the exit code where help was printed or an error told.
std::variant<LoadOptions, int> parse_load_options(int argc, const char* const* argv);

}  // namespace billiards::tools
