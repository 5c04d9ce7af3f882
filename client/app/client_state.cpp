// Takes what a client knows; gives the few answers that several rooms ask of it.
#include "client/app/client_state.h"

#include <algorithm>
#include <utility>

namespace billiards::client {

ClientState with_link_lost(ClientState state) {
    state.link = LinkState::Lost;
    state.is_table_stale = state.table.has_value();
    return state;
}

ClientState with_muted(ClientState state, const std::string& name) {
    if (name.empty()) return state;
    state = with_unmuted(std::move(state), name);
    if (state.muted.size() >= kMutedKept) state.muted.erase(state.muted.begin());
    state.muted.push_back(name);
    std::erase_if(state.chat, [&](const ChatLine& line) { return line.name == name; });
    return state;
}

ClientState with_unmuted(ClientState state, const std::string& name) {
    std::erase(state.muted, name);
    return state;
}

bool is_muted(const ClientState& state, const std::string& name) {
    return std::find(state.muted.begin(), state.muted.end(), name) != state.muted.end();
}

std::optional<model::Seat> my_turn(const ClientState& state) {
    if (!state.table || !state.table->match || state.is_table_stale) return std::nullopt;
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
