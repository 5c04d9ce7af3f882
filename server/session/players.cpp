// Takes players and their hashes; keeps the index by which a token finds its player.
#include "server/session/players.h"

#include "common/base/check.h"

#include <cstring>
#include <utility>

namespace billiards::server {

Player& Players::add(StoredPlayer stored) {
    const PlayerId id = stored.player;
    const auto [place, added] = by_id_.emplace(id, Player{.stored = std::move(stored)});
    CHECK(added);
    index(place->second);
    return place->second;
}

void Players::remove(PlayerId player) {
    const auto known = by_id_.find(player);
    CHECK(known != by_id_.end());
    forget_all(known->second);
    by_id_.erase(known);
}

Player* Players::find(PlayerId player) {
    const auto known = by_id_.find(player);
    return known == by_id_.end() ? nullptr : &known->second;
}

Player* Players::find(const TokenHash& hash) {
    const auto [first, last] = by_lead_.equal_range(lead_of(hash));
    for (auto candidate = first; candidate != last; ++candidate) {
        Player& player = by_id_.at(candidate->second);
        if (is_equal(player.stored.token_hash, hash)) return &player;
        const auto& previous = player.stored.previous_token_hash;
        if (previous && is_equal(*previous, hash)) return &player;
    }
    return nullptr;
}

void Players::rotate(Player& player, const TokenHash& used, const TokenHash& fresh) {
    forget_all(player);
    player.stored.token_hash = fresh;
    player.stored.previous_token_hash = used;
    index(player);
}

bool Players::confirm(Player& player) {
    if (!player.stored.previous_token_hash) return false;
    forget_all(player);
    player.stored.previous_token_hash.reset();
    index(player);
    return true;
}

std::uint64_t Players::lead_of(const TokenHash& hash) {
    std::uint64_t lead = 0;
    std::memcpy(&lead, hash.data(), sizeof lead);
    return lead;
}

void Players::index(const Player& player) {
    by_lead_.emplace(lead_of(player.stored.token_hash), player.stored.player);
    const auto& previous = player.stored.previous_token_hash;
    if (previous) by_lead_.emplace(lead_of(*previous), player.stored.player);
}

void Players::forget(PlayerId player, const TokenHash& hash) {
    const auto [first, last] = by_lead_.equal_range(lead_of(hash));
    for (auto candidate = first; candidate != last; ++candidate) {
        if (candidate->second != player) continue;
        by_lead_.erase(candidate);
        return;
    }
    CHECK(false);
}

void Players::forget_all(const Player& player) {
    forget(player.stored.player, player.stored.token_hash);
    const auto& previous = player.stored.previous_token_hash;
    if (previous) forget(player.stored.player, *previous);
}

}  // namespace billiards::server
