// Takes what a client knows; gives the few answers that several rooms ask of it.
#include "client/app/client_state.h"

#include <algorithm>

namespace billiards::client {

std::optional<model::Seat> my_turn(const ClientState& state) {
    if (!state.table || !state.table->match) return std::nullopt;
    const match::MatchState& match = *state.table->match;
    if (match.stage == match::Stage::Over) return std::nullopt;
    const std::vector<model::Seat>& mine = state.table->my_seats;
    const bool waits_for_me = std::find(mine.begin(), mine.end(), match.to_act) != mine.end();
    return waits_for_me ? std::optional(match.to_act) : std::nullopt;
}

std::optional<base::Instant> local_time_of(const ClientState& state, std::int64_t server_time_us) {
    if (!state.clock_offset) return std::nullopt;
    return base::Instant(base::Duration(server_time_us) - *state.clock_offset);
}

}  // namespace billiards::client
