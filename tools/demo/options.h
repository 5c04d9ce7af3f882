// Takes the command line; gives what billiards-demo is to do.
#pragma once

#include "client/net/address.h"
#include "common/base/time.h"
#include "common/protocol/messages.h"

#include <cstdint>
#include <optional>
#include <string>
#include <variant>

namespace billiards::tools {

/// How far a simple player's shots go astray: enough that it does not always run out.
inline constexpr double kUnsteady_deg = 0.4;

/// A whole match: a server, two players and a spectator.
struct DemoOptions {
    std::string server_program;                    ///< Empty: billiards-server beside this program.
    std::optional<client::ServerAddress> connect;  ///< A server that runs already, instead.
    int race_to = 2;
    std::uint64_t seed = 1;
    double think_s = 0.25;
    double unsteady_deg = kUnsteady_deg;
    double limit_s = 300.0;      ///< After which it gives up.
    std::string window_program;  ///< Empty: billiards beside this program.
    std::string pictures;        ///< Folder for pictures of the match; empty: none are drawn.
    std::string keep;            ///< File for the match as a replay; empty: it is forgotten.
};

/// One role, at a server that runs already.
struct RoleOptions {
    client::ServerAddress server;
    protocol::Role role = protocol::Role::Player;
    std::string name;
    std::optional<protocol::TableId> table;  ///< None: a player opens one.
    std::string table_name = "Demonstration";
    std::string token_file;  ///< Keeps the resume token; empty: it is forgotten at the end.
    int race_to = 2;
    double shot_clock_s = 45.0;
    std::uint64_t seed = 1;
    double min_think_s = 0.0;
    double max_think_s = 0.0;
    double unsteady_deg = kUnsteady_deg;
    bool watches_balls_roll = false;
    bool json = false;
};

/// There was nothing to do but to print help, or an error was told: exit with this.
struct ExitCode {
    int value = 0;
};

std::variant<DemoOptions, RoleOptions, ExitCode> parse_options(int argc, const char* const* argv);

}  // namespace billiards::tools
