// Gives everyone the server knows: found by id, or by the secret that only they hold.
#pragma once

#include "common/protocol/messages.h"
#include "server/session/token.h"
#include "server/store/match_store.h"
#include "server/table/outbox.h"

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>

namespace billiards::server {

struct Player {
    StoredPlayer stored;
    std::optional<SessionId> session{};         ///< Connected, or about to be welcomed.
    std::optional<protocol::TableId> table{};   ///< Where the player sits or stood last.
    std::optional<protocol::TableId> opened{};  ///< The last table that the player opened.
};

class Players {
  public:
    Player& add(StoredPlayer stored);
    void remove(PlayerId player);

    std::size_t size() const { return by_id_.size(); }
    Player* find(PlayerId player);
    /// Whose current or previous token has this hash.
    Player* find(const TokenHash& hash);

    /// A new token for the one just used, which stays good until `confirm`. Any other dies.
    void rotate(Player& player, const TokenHash& used, const TokenHash& fresh);
    /// The player has the new token: the previous one dies. False where there was none.
    bool confirm(Player& player);

  private:
    /// The first bytes of a hash only lead to the candidates; the whole of it is compared in
    /// constant time.
    static std::uint64_t lead_of(const TokenHash& hash);
    void index(const Player& player);
    void forget(PlayerId player, const TokenHash& hash);
    void forget_all(const Player& player);

    std::map<PlayerId, Player> by_id_;
    std::multimap<std::uint64_t, PlayerId> by_lead_;
};

}  // namespace billiards::server
