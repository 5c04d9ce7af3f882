// Takes what connections say and what time it is; gives frames to the outbox and writes to the
// committer. The whole server without sockets, files, clocks or randomness of its own.
#pragma once

#include "common/base/time.h"
#include "common/protocol/messages.h"
#include "server/session/address_key.h"
#include "server/session/limits.h"
#include "server/session/token.h"
#include "server/store/archive.h"
#include "server/store/committer.h"
#include "server/table/outbox.h"
#include "server/table/refold.h"
#include "server/table/surroundings.h"

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace billiards::server {

/// What was durable when the server started. Matches are read one by one, when their table is
/// restored: no more than one is in memory twice.
struct StoredWorld {
    std::vector<StoredPlayer> players;
    std::vector<StoredTable> tables;
    MatchStore::HighestIds highest;
    /// The newest match that is kept of those played at the table.
    std::function<StoreResult<std::optional<KnownMatch>>(protocol::TableId)> last_match;
    /// As it stands after its journal; the error says what is wrong with that.
    std::function<base::Result<Refolded, std::string>(const StoredMatch&)> refold;
};

/// Lives on the game thread alone. Every call takes the time; nothing in it waits.
class Lobby {
  public:
    Lobby(const LobbyLimits& limits, Outbox& outbox, Committer& committer, Archive& archive,
          RandomBytes random);
    ~Lobby();

    /// Once, before anything else: players are known again, and every table stands, with whoever
    /// sat there away. A match that was played goes on with the clock given back in full; one that
    /// is over is shown, for those who have not seen its end. A table whose running match does not
    /// refold is left alone, as it is stored, and the reason returned.
    std::vector<std::string> restore(base::Instant now, const StoredWorld& world);

    void connected(base::Instant now, SessionId session, AddressKey from);
    void received(base::Instant now, SessionId session, const protocol::ClientMessage& message);
    /// Bytes that were no message: answered, counted, and in the end disconnected.
    void malformed(base::Instant now, SessionId session, const std::string& detail);
    /// The network dropped what a spectator was told: it is shown its table as it is now.
    void fell_behind(base::Instant now, SessionId session);
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
