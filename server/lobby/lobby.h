// Takes what connections say and what time it is; gives frames to the outbox and writes to the
// committer. The whole server without sockets, files, clocks or randomness of its own.
#pragma once

#include "common/base/time.h"
#include "common/protocol/messages.h"
#include "server/store/committer.h"
#include "server/table/outbox.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace billiards::server {

struct LobbyLimits {
    int max_tables = 4000;
    int max_tables_per_session = 1;
    int max_spectators_per_table = 20'000;
    int chat_per_10s = 8;
    int aim_per_s_to_players = 10;
    int aim_per_s_to_spectators = 4;
    int illegal_messages = 20;  ///< Refused for their phase or form, before the session is closed.
    base::Duration empty_table_kept = std::chrono::minutes(10);
};

/// Where secrets and seeds come from: the system's generator in the program, a fixed sequence in
/// tests.
using RandomBytes = std::function<void(std::span<std::uint8_t>)>;

/// What was durable when the server started.
struct StoredWorld {
    std::vector<StoredPlayer> players;
    struct LiveMatch {
        StoredMatch match;
        std::vector<StoredEntry> entries;
    };
    std::vector<LiveMatch> matches;
    MatchStore::HighestIds highest;
};

struct LobbyStats {
    std::size_t sessions = 0;
    std::size_t tables = 0;
    std::size_t matches_running = 0;
    std::uint64_t shots = 0;
    std::uint64_t refusals = 0;
    bool storage_failing = false;  ///< The last commit failed: not ready.
};

/// Lives on the game thread alone. Every call takes the time; nothing in it waits.
class Lobby {
  public:
    Lobby(const LobbyLimits& limits, Outbox& outbox, Committer& committer, RandomBytes random);
    ~Lobby();

    /// Once, before anything else: players are known again, every live match waits for its
    /// players with the clock given back in full. A match whose journal does not refold is left
    /// alone, and its reason returned.
    std::vector<std::string> restore(base::Instant now, const StoredWorld& world);

    void connected(base::Instant now, SessionId session);
    void received(base::Instant now, SessionId session, const protocol::ClientMessage& message);
    /// Bytes that were no message: answered, counted, and in the end disconnected.
    void malformed(base::Instant now, SessionId session, const std::string& detail);
    void disconnected(base::Instant now, SessionId session);

    /// When advance_time should next be called; none: nothing waits for time.
    std::optional<base::Instant> next_deadline() const;
    void advance_time(base::Instant now);

    /// Tells everyone that the server goes down; from here nothing new starts.
    void shut_down(base::Instant now);

    LobbyStats stats() const;

  private:
    struct World;
    std::unique_ptr<World> world_;
};

}  // namespace billiards::server
