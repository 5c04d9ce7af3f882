// Takes a record; gives its digest.
#include "common/timeline/shot_record.h"

#include "common/base/hash.h"

namespace billiards::timeline {

namespace {

void add(base::Hasher& hasher, const base::Vec3& v) {
    hasher.add(v.x);
    hasher.add(v.y);
    hasher.add(v.z);
}

void add(base::Hasher& hasher, const model::ShotEvent& event) {
    hasher.add(event.time_s);
    hasher.add(static_cast<std::uint64_t>(event.kind) | std::uint64_t{event.ball.number} << 8U |
               std::uint64_t{event.other.number} << 16U |
               static_cast<std::uint64_t>(event.to) << 24U |
               std::uint64_t{static_cast<std::uint8_t>(event.direction)} << 32U |
               std::uint64_t{event.held} << 40U | std::uint64_t{event.index} << 48U);
}

void add(base::Hasher& hasher, const Segment& segment) {
    hasher.add(segment.start_s);
    hasher.add(static_cast<std::uint64_t>(segment.motion));
    add(hasher, segment.position_m);
    add(hasher, segment.velocity_mps);
    add(hasher, segment.acceleration_mps2);
    add(hasher, segment.spin_radps);
    add(hasher, segment.spin_rate_radps2);
}

void add(base::Hasher& hasher, const model::PlacedBall& placed) {
    hasher.add(std::uint64_t{placed.ball.number} | static_cast<std::uint64_t>(placed.place) << 8U);
    hasher.add(placed.position_m.x);
    hasher.add(placed.position_m.y);
}

}  // namespace

std::uint64_t hash_of(const ShotRecord& record) {
    base::Hasher hasher;
    hasher.add(record.duration_s);
    hasher.add(std::uint64_t{record.events.size()});
    for (const model::ShotEvent& event : record.events) add(hasher, event);
    for (const BallTrack& track : record.timeline.tracks) {
        hasher.add(std::uint64_t{track.ball.number} | std::uint64_t{track.segments.size()} << 8U);
        hasher.add(track.radius_m);
        for (const Segment& segment : track.segments) add(hasher, segment);
    }
    for (const model::PlacedBall& placed : record.final_layout.balls) add(hasher, placed);
    return hasher.digest();
}

}  // namespace billiards::timeline
