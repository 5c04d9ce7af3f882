// Gives everyone the server knows: found by id, by the name that all see, or by the secret that
// only they hold.
#pragma once

#include "common/protocol/messages.h"
#include "server/session/token.h"
#include "server/store/match_store.h"
#include "server/table/outbox.h"

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>

namespace billiards::server {

struct Player {
    StoredPlayer stored;
    std::optional<SessionId> session{};         ///< Connected, or about to be welcomed.
    std::optional<protocol::TableId> table{};   ///< Where the player sits or stood last.
    std::optional<protocol::TableId> opened{};  ///< The last table that the player opened.
    bool left_open_door = false;  ///< `table` was not private when the link to it was lost.
};

class Players {
  public:
    Player& add(StoredPlayer stored);
    void remove(PlayerId player);

    std::size_t size() const { return by_id_.size(); }
    /// The one with the lowest id; none where there is nobody.
    const Player* anyone() const { return by_id_.empty() ? nullptr : &by_id_.begin()->second; }
    Player* find(PlayerId player);
    /// Whose current or previous token has this hash.
    Player* find(const TokenHash& hash);
    /// By the whole name as shown. Where a database from before names were unique has several, one
    /// of them.
    Player* find_named(std::string_view name);

    /// `name` with a discriminator such as "#3f21" that no other player of this name has: the first
    /// free one from `draw` on. None where all are taken.
    std::optional<std::string> free_name(const std::string& name, std::uint16_t draw) const;

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
    /// The names stand in by_id_, whose players stay where they are.
    std::multimap<std::string_view, PlayerId> by_name_;
};

}  // namespace billiards::server
