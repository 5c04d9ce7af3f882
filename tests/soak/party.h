// Takes a server's address and a seed; gives two players and a spectator at a table of their own,
// who come back by themselves whenever they are thrown out, and what each of them was told.
#pragma once

#include "tests/soak/account.h"
#include "tools/load/load_session.h"

#include <array>
#include <asio/io_context.hpp>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>

namespace billiards::soak {

inline constexpr std::size_t kClients = 3;  ///< First player, spectator, second player.

struct PartyOptions {
    std::uint64_t seed = 0;  ///< Two parties with one seed would send the same shot ids.
    std::array<client::ServerAddress, kClients> addresses;
    int race_to = 1;
    base::Duration max_think{};
    /// Called when a client, by its number, has given a shot's last byte to the system; or null.
    std::function<void(std::size_t client)> shot_sent;
};

/// They play one match and then stay until the object's end.
class Party {
  public:
    Party(asio::io_context& io, PartyOptions options, tools::Recorder& recorder);
    Party(const Party&) = delete;
    Party& operator=(const Party&) = delete;

    /// To be called again and again: lets the next one in, and those again whose link was lost
    /// before they were anybody.
    void tend();

    /// All three have their places now.
    bool is_here() const;
    /// All three know that the match is over, or cannot go on.
    bool is_over() const;
    /// Why one of them cannot go on; none while all can.
    std::optional<std::string> failure() const;
    /// None before the first player has opened it.
    std::optional<protocol::TableId> table() const { return table_; }
    std::array<Account, kClients> accounts() const;
    /// Shots, counted once for each who was told.
    std::size_t tellings() const;
    int links_lost() const;
    /// For people: what each of them is waiting for.
    std::string standing() const;

  private:
    struct Guest {
        std::unique_ptr<tools::LoadSession> session;
        std::map<int, Shot> shots;
        std::optional<protocol::server::MatchOver> over;
    };

    void let_in(std::size_t client);
    tools::PlayerOptions player(std::size_t client) const;
    tools::PlayerEvents events(Guest& guest) const;

    asio::io_context& io_;
    PartyOptions options_;
    tools::Recorder& recorder_;
    std::optional<protocol::TableId> table_;
    std::array<Guest, kClients> guests_;
};

}  // namespace billiards::soak
