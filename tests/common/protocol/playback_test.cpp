// Shows that a viewer needs nothing but what it was sent: a recorded break is played back here by
// code that includes no engine.
#include "common/protocol/codec.h"
#include "common/timeline/evaluate.h"
#include "tests/common/protocol/golden.h"

#include <algorithm>
#include <gtest/gtest.h>

namespace billiards::protocol {
namespace {

using timeline::BallTrack;
using timeline::ShotRecord;

/// What 32 bits leave of a position on a table.
constexpr double kTolerance_m = 1e-6;

ShotRecord recorded_break() {
    const Golden golden = read_golden(std::filesystem::path(GOLDEN_WIRE_FOLDER) / "1.0.txt");
    const auto message = decode_server(golden.at({"server", "break"}));
    return std::get<server::ShotPlayed>(message.value()).record;
}

const BallTrack& track_of(const ShotRecord& record, model::BallId ball) {
    const auto& tracks = record.timeline.tracks;
    return *std::find_if(tracks.begin(), tracks.end(),
                         [&](const BallTrack& track) { return track.ball == ball; });
}

double distance_m(const BallTrack& a, const BallTrack& b, double time_s) {
    return glm::distance(evaluate(a, time_s).position_m, evaluate(b, time_s).position_m);
}

TEST(Playback, IsOfAWholeBreak) {
    const ShotRecord record = recorded_break();
    EXPECT_EQ(record.timeline.tracks.size(), 16U);
    EXPECT_GT(record.events.size(), 50U);
    EXPECT_GT(record.duration_s, 3.0);
}

TEST(Playback, MovesNoBallByJumps) {
    for (const BallTrack& track : recorded_break().timeline.tracks) {
        for (std::size_t i = 1; i < track.segments.size(); ++i) {
            const auto before = evaluate(track.segments[i - 1], track.segments[i].start_s);
            EXPECT_LE(glm::distance(before.position_m, track.segments[i].position_m), kTolerance_m)
                << "ball " << int{track.ball.number} << " at " << track.segments[i].start_s << " s";
        }
    }
}

TEST(Playback, EndsWhereTheFinalLayoutSays) {
    const ShotRecord record = recorded_break();
    for (const model::PlacedBall& placed : record.final_layout.balls) {
        const model::BallState last = evaluate(track_of(record, placed.ball), record.duration_s);
        EXPECT_LE(glm::distance(base::horizontal(last.position_m), placed.position_m),
                  kTolerance_m);
        EXPECT_EQ(last.velocity_mps, base::Vec3(0));
        EXPECT_EQ(last.motion == model::Motion::Pocketed, placed.place == model::Place::Pocketed);
    }
}

TEST(Playback, ShowsBallsTouchingWhenTheyMeet) {
    const ShotRecord record = recorded_break();
    int contacts = 0;
    for (const model::ShotEvent& event : record.events) {
        if (event.kind != model::EventKind::BallBall) continue;
        const BallTrack& a = track_of(record, event.ball);
        const BallTrack& b = track_of(record, event.other);
        EXPECT_NEAR(distance_m(a, b, event.time_s), a.radius_m + b.radius_m, kTolerance_m);
        ++contacts;
    }
    EXPECT_GT(contacts, 15);
}

TEST(Playback, ShowsNoBallInsideAnother) {
    const ShotRecord record = recorded_break();
    const auto& tracks = record.timeline.tracks;
    for (int frame = 0; frame / 60.0 < record.duration_s; ++frame) {
        const double time_s = frame / 60.0;
        for (auto a = tracks.begin(); a != tracks.end(); ++a) {
            if (!is_on_table(evaluate(*a, time_s).motion)) continue;
            for (auto b = std::next(a); b != tracks.end(); ++b) {
                if (!is_on_table(evaluate(*b, time_s).motion)) continue;
                EXPECT_GE(distance_m(*a, *b, time_s), a->radius_m + b->radius_m - kTolerance_m);
            }
        }
    }
}

}  // namespace
}  // namespace billiards::protocol
