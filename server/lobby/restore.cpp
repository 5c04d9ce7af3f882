// Takes a match that was live when the server went down; gives it a table that waits for its
// players.
#include "server/lobby/world.h"
#include "server/table/refold.h"

#include <string>
#include <utility>

namespace billiards::server {

base::Result<base::Done, std::string> Lobby::World::restore(base::Instant now,
                                                            const StoredWorld::LiveMatch& live) {
    const protocol::TableId id = live.match.table;
    if (table_of(id) != nullptr) {
        return "table " + std::to_string(id.value) + " has another live match";
    }
    model::PerSeat<std::string> names;
    for (const model::Seat seat : model::kSeats) {
        const Player* player = players.find(live.match.players[seat]);
        if (player == nullptr) {
            return "player " + std::to_string(live.match.players[seat].value) + " is not known";
        }
        names[seat] = player->stored.name;
    }
    const auto refolded = refold_journal(live.match, live.entries);
    if (!refolded) return refolded.error();
    if (refolded->state.stage == match::Stage::Over) return std::string("it is over");

    const auto [place, added] = tables.try_emplace(
        id, id, live.match.table_name, refolded->state.settings,
        Access(around.limits, {live.match.players[model::Seat::First], names[model::Seat::First]}),
        around, now);
    place->second.restore(now, live.match, *refolded, names);
    for (const model::Seat seat : model::kSeats) {
        players.find(live.match.players[seat])->table = id;
    }
    refresh_deadline(id);
    return base::Done{};
}

}  // namespace billiards::server
