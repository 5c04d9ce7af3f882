// Takes moments; keeps what each seat has left of its grace.
#include "server/table/absence.h"

#include <algorithm>

namespace billiards::server {

Absence::Absence(base::Duration grace) : grace_(grace) {
    for (const model::Seat seat : model::kSeats) seats_[seat].left = grace;
}

void Absence::count(base::Instant now, model::Seat seat, bool counts) {
    Grace& grace = seats_[seat];
    if (counts == grace.ends.has_value()) return;
    if (counts) {
        grace.ends = now + grace.left;
    } else {
        grace.left = std::max(*grace.ends - now, base::Duration::zero());
        grace.ends.reset();
    }
}

void Absence::give_back(base::Instant now, model::Seat seat) {
    Grace& grace = seats_[seat];
    grace.left = grace_;
    if (grace.ends) grace.ends = now + grace_;
}

bool Absence::is_used_up(base::Instant now, model::Seat seat) const {
    return seats_[seat].ends && *seats_[seat].ends <= now;
}

}  // namespace billiards::server
