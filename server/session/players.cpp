// Takes players and their hashes; keeps the index by which a token finds its player.
#include "server/session/players.h"

#include "common/base/check.h"

#include <algorithm>
#include <cstring>
#include <utility>

namespace billiards::server {
namespace {

std::string discriminator(std::uint16_t number) {
    constexpr std::string_view kDigits = "0123456789abcdef";
    std::string text = "#0000";
    for (std::size_t place = text.size() - 1; place > 0; --place, number >>= 4U) {
        text[place] = kDigits[number & 0xfU];
    }
    return text;
}

}  // namespace

Player& Players::add(StoredPlayer stored) {
    const PlayerId id = stored.player;
    const auto [place, added] = by_id_.emplace(id, Player{.stored = std::move(stored)});
    CHECK(added);
    index(place->second);
    by_name_.emplace(place->second.stored.name, id);
    return place->second;
}

void Players::remove(PlayerId player) {
    const auto known = by_id_.find(player);
    CHECK(known != by_id_.end());
    forget_all(known->second);
    const auto [first, last] = by_name_.equal_range(known->second.stored.name);
    by_name_.erase(
        std::find_if(first, last, [&](const auto& one) { return one.second == player; }));
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

Player* Players::find_named(std::string_view name) {
    const auto known = by_name_.find(name);
    return known == by_name_.end() ? nullptr : &by_id_.at(known->second);
}

std::optional<std::string> Players::free_name(const std::string& name, std::uint16_t draw) const {
    std::uint16_t number = draw;
    do {
        std::string shown = name + discriminator(number);
        if (!by_name_.contains(shown)) return shown;
    } while (++number != draw);
    return std::nullopt;
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
