// Takes the time and who watches the balls; opens turns, counts their clock down, frees the seats
// of those who stay away, and says when to be called again.
#include "server/table/table.h"

#include <algorithm>

namespace billiards::server {

using model::kSeats;
using model::Seat;

void Table::seen(base::Instant now, SessionId session, std::uint64_t sequence) {
    if (!rolling_ || rolling_->sequence != sequence) return;
    for (const Seat seat : seating_.seats_of(session)) rolling_->seen[seat] = true;
    open_turn_if_all_have_seen(now);
}

void Table::open_turn_if_all_have_seen(base::Instant now, std::optional<SessionId> except) {
    if (!rolling_ || !clock_.is_waiting() || !seating_.is_anyone_connected()) return;
    const bool all = std::all_of(kSeats.begin(), kSeats.end(), [&](Seat seat) {
        return rolling_->seen[seat] || !seating_.is_connected(seat);
    });
    if (all) open_turn(now, except);
}

void Table::open_turn(base::Instant now, std::optional<SessionId> except) {
    rolling_.reset();
    clock_.open(now);
    announce_turn(now, except);
}

std::optional<base::Instant> Table::next_deadline() const {
    std::optional<base::Instant> next = announce_spectators_at_;
    const auto consider = [&](std::optional<base::Instant> when) {
        if (when) next = next ? std::min(*next, *when) : *when;
    };
    consider(gallery_.next_deadline());
    if (is_pending()) return next;
    if (deserted_since_) consider(*deserted_since_ + around_.limits.empty_table_kept);
    if (clock_.is_waiting()) consider(clock_.opens());
    consider(clock_runs_out());
    if (!is_between_matches()) return next;
    for (const Seat seat : kSeats) consider(absence_.ends(seat));
    return next;
}

void Table::advance(base::Instant now) {
    if (announce_spectators_at_ && *announce_spectators_at_ <= now) announce_seats(now);
    show_what_is_due(now);
    if (is_pending()) return;
    free_seats_of_absent(now);
    if (clock_.is_waiting() && clock_.opens() <= now) open_turn(now);
    if (const auto out = clock_runs_out(); out && *out <= now) {
        run(now, {.asker = {}, .seats = {}, .what = {match::Timeout{match_->state.turn}}});
    }
}

void Table::free_seats_of_absent(base::Instant now) {
    if (!is_between_matches()) return;
    bool changed = false;
    for (const Seat seat : kSeats) {
        if (!absence_.is_used_up(now, seat)) continue;
        seating_.vacate(seat);
        changed = true;
    }
    if (changed) seats_changed(now);
}

std::optional<base::Instant> Table::clock_runs_out() const {
    if (!clock_.deadline()) return std::nullopt;
    return *clock_.deadline() + around_.limits.shot_grace;
}

}  // namespace billiards::server
