// Takes shots; hashes what they led to, in order.
#include "tools/player/match_digest.h"

#include <algorithm>

namespace billiards::tools {

std::uint64_t digest_of(const protocol::server::ShotPlayed& shot) {
    base::Hasher hasher;
    hasher.add(shot.record.hash);
    for (const model::PlacedBall& placed : shot.after.layout.balls) {
        hasher.add(std::uint64_t{placed.ball.number});
        hasher.add(static_cast<std::uint64_t>(placed.place));
        hasher.add(placed.position_m.x);
        hasher.add(placed.position_m.y);
    }
    for (const int racks : shot.after.racks_won.values) {
        hasher.add(static_cast<std::uint64_t>(racks));
    }
    return hasher.digest();
}

bool MatchDigest::add(const protocol::server::ShotPlayed& shot) {
    const int known = shots_ + missed_;
    if (shot.after.shots_played <= known) return false;
    missed_ += shot.after.shots_played - known - 1;
    ++shots_;
    hasher_.add(digest_of(shot));
    return true;
}

void MatchDigest::add(const protocol::server::MatchOver& over) {
    missed_ += std::max(static_cast<int>(over.shots) - shots_ - missed_, 0);
    hasher_.add(over.winner ? static_cast<std::uint64_t>(*over.winner) : model::kSeats.size());
    hasher_.add(std::uint64_t{over.shots});
}

}  // namespace billiards::tools
