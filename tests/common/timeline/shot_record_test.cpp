// Shows that a record's hash notices every part of it.
#include "common/timeline/shot_record.h"

#include <functional>
#include <gtest/gtest.h>

namespace billiards::timeline {
namespace {

ShotRecord small_record() {
    return {.events = {model::ShotEvent::ball_ball(0.5, model::kCueBall, model::BallId{3})},
            .timeline = {{{.ball = model::kCueBall, .radius_m = 0.03, .segments = {Segment{}}}}},
            .final_layout = {{{.ball = model::kCueBall, .position_m = {0.1, 0.2}}}},
            .duration_s = 1.0};
}

TEST(HashOfRecord, IsThatOfAnEqualRecord) {
    EXPECT_EQ(hash_of(small_record()), hash_of(small_record()));
}

TEST(HashOfRecord, NoticesAChangeAnywhere) {
    const std::function<void(ShotRecord&)> changes[] = {
        [](ShotRecord& r) { r.duration_s = 1.0000000000000002; },
        [](ShotRecord& r) { r.events[0].time_s = 0.25; },
        [](ShotRecord& r) { r.events[0].other = model::BallId{4}; },
        [](ShotRecord& r) { r.events[0].held = true; },
        [](ShotRecord& r) { r.events.clear(); },
        [](ShotRecord& r) { r.timeline.tracks[0].segments[0].spin_rate_radps2.z = 1; },
        [](ShotRecord& r) { r.timeline.tracks[0].segments.push_back(Segment{}); },
        [](ShotRecord& r) { r.final_layout.balls[0].place = model::Place::Pocketed; },
        [](ShotRecord& r) { r.final_layout.balls[0].position_m.y = 0.3; },
    };
    for (const auto& change : changes) {
        ShotRecord changed = small_record();
        change(changed);
        EXPECT_NE(hash_of(changed), hash_of(small_record()));
    }
}

}  // namespace
}  // namespace billiards::timeline
