// Takes a table as it was stored; gives it back with its match, waiting for those who sat there.
#include "server/lobby/world.h"
#include "server/table/refold.h"

#include <string>
#include <utility>

namespace billiards::server {
namespace {

using Reason = std::string;

/// A match that is over only shows how it ended: without its journal the table does without it.
base::Result<std::optional<Table::Played>, Reason> last_match_of(const StoredWorld& world,
                                                                 protocol::TableId table) {
    const auto known = world.last_match(table);
    if (!known) return "table " + std::to_string(table.value) + ": " + known.error().detail;
    std::optional<Table::Played> played;
    if (!*known) return played;
    const KnownMatch& last = **known;
    auto refolded = world.refold(last.match);
    if (!refolded && !last.is_over) {
        return "match " + std::to_string(last.match.match.value) + ": " + refolded.error();
    }
    if (!refolded) return played;
    const bool has_ended = refolded->state.stage == match::Stage::Over;
    if (last.is_over && !has_ended) return played;
    played = Table::Played{last.match, std::move(refolded).value()};
    return played;
}

}  // namespace

base::Result<Table::Sitters, std::string> Lobby::World::sitters_of(
    const StoredTable& stored, const std::optional<Table::Played>& played) {
    Table::Sitters sitters;
    const bool runs = played && played->refolded.state.stage != match::Stage::Over;
    for (const model::Seat seat : model::kSeats) {
        const auto id = runs ? std::optional(played->match.players[seat]) : stored.seats[seat];
        if (!id) continue;
        const Player* player = players.find(*id);
        if (player != nullptr) {
            sitters[seat] = Table::Sitter{*id, player->stored.name};
        } else if (runs) {
            return "match " + std::to_string(played->match.match.value) + ": player " +
                   std::to_string(id->value) + " is not known";
        }
    }
    return sitters;
}

base::Result<base::Done, std::string> Lobby::World::restore(base::Instant now,
                                                            const StoredWorld& world,
                                                            const StoredTable& stored) {
    const protocol::TableId id = stored.table;
    const auto settings = protocol::decode_settings(stored.settings);
    if (!settings) return "table " + std::to_string(id.value) + ": " + settings.error().detail;
    const auto played = last_match_of(world, id);
    if (!played) return played.error();
    const auto sitters = sitters_of(stored, *played);
    if (!sitters) return sitters.error();

    Player* owner = players.find(stored.owner);
    const auto [place, added] = tables.try_emplace(
        id, id, stored.name, settings->settings,
        Access(around.limits, stored, owner != nullptr ? owner->stored.name : std::string(), now),
        around, now);
    if (!added) return "table " + std::to_string(id.value) + " is stored twice";
    place->second.restore(now, *sitters, *played);
    if (owner != nullptr) owner->opened = id;
    for (const model::Seat seat : model::kSeats) {
        if (!(*sitters)[seat]) continue;
        Player& sitter = *players.find((*sitters)[seat]->player);
        // A seat that was left may still be stored, where the disk failed; a match leads back.
        const Table* other = sitter.table ? table_of(*sitter.table) : nullptr;
        if (other == nullptr || !other->is_playing()) sitter.table = id;
    }
    refresh_deadline(id);
    return base::Done{};
}

}  // namespace billiards::server
