// Holds what must be true of every shot: over random breaks and scattered, frozen and spinning
// balls.
#include "common/physics/motion.h"
#include "tests/common/physics/still_life.h"

namespace billiards::physics {
namespace {

/// In a pocket's mouth a ball may rest past the nose line.
bool is_in_mouth(const model::TableSpec& table, const Vec2& place) {
    return std::any_of(table.pockets.begin(), table.pockets.end(), [&](const auto& pocket) {
        return glm::distance(place, pocket.center_m) < pocket.radius_m + 0.08;
    });
}

void expect_sound(const model::TableSpec& table, const timeline::ShotRecord& record) {
    EXPECT_EQ(record.hash, timeline::hash_of(record));
    for (const model::PlacedBall& ball : record.final_layout.balls) {
        EXPECT_NE(ball.place, model::Place::OffTable) << "balls on the slate cannot leave";
        const Vec2 excess = glm::abs(ball.position_m) - (table.half_playing_m - kRadius_m);
        const bool is_inside = std::max(excess.x, excess.y) < 1e-9;
        if (ball.place == model::Place::OnTable) {
            EXPECT_TRUE(is_inside || is_in_mouth(table, ball.position_m));
        }
    }
    for (std::size_t i = 1; i < record.events.size(); ++i) {
        ASSERT_LE(record.events[i - 1].time_s, record.events[i].time_s);
    }
    EXPECT_TRUE(record.events.empty() || record.events.back().time_s == record.duration_s);
}

void expect_continuous(const timeline::ShotRecord& record) {
    for (const auto& track : record.timeline.tracks) {
        ASSERT_FALSE(track.segments.empty());
        EXPECT_EQ(track.segments.front().start_s, 0.0);
        for (std::size_t i = 1; i < track.segments.size(); ++i) {
            const auto& next = track.segments[i];
            ASSERT_GT(next.start_s, track.segments[i - 1].start_s);
            const auto end = timeline::evaluate(track.segments[i - 1], next.start_s);
            ASSERT_LT(speed_of(end.position_m - next.position_m), 1e-12);
            if (next.motion == Motion::Rolling) {
                EXPECT_LT(speed_of(slip_mps(
                              {.velocity_mps = next.velocity_mps, .spin_radps = next.spin_radps},
                              kRadius_m)),
                          1e-12);
            }
        }
        const Motion last = track.segments.back().motion;
        EXPECT_TRUE(last == Motion::Resting || last == Motion::Pocketed);
    }
}

void expect_lawful(const Diagnostics& diagnostics) {
    EXPECT_LT(diagnostics.max_energy_rise_j, 1e-12);
    EXPECT_GT(diagnostics.min_gap_m.value_or(0.0), -1e-9);
}

TEST(Invariants, HoldOverRandomBreaks) {
    base::Random random(31);
    std::size_t most_events = 0;
    for (int i = 0; i < 300; ++i) {
        const auto& table = model::table_of(static_cast<model::TableSize>(i % 3));
        const double speed = random.uniform(6.0, 12.0);
        const double angle = base::radians(random.uniform(-2.0, 2.0));
        const Vec3 spin{random.uniform(-60, 60), random.uniform(-60, 60), random.uniform(-60, 60)};
        Diagnostics diagnostics;
        const auto record =
            solved(table, {},
                   break_shot(table, speed * Vec2{base::cosine(angle), base::sine(angle)}, spin),
                   &diagnostics);
        expect_sound(table, record);
        expect_continuous(record);
        expect_lawful(diagnostics);
        most_events = std::max(most_events, record.events.size());
    }
    EXPECT_LT(most_events, 400U) << "breaks end within a few hundred events";
}

TEST(Invariants, HoldOverScatteredFrozenAndSpinningBalls) {
    base::Random random(32);
    for (int i = 0; i < 400; ++i) {
        const auto& table = model::table_of(static_cast<model::TableSize>(i % 3));
        Diagnostics diagnostics;
        const auto record =
            solved(table, {}, Scatter(random, table).balls(2 + random.below(15), i % 2 == 0),
                   &diagnostics);
        expect_sound(table, record);
        expect_continuous(record);
        expect_lawful(diagnostics);
    }
}

TEST(Invariants, HoldOverJumpingBalls) {
    base::Random random(34);
    int left = 0;
    for (int i = 0; i < 400; ++i) {
        const auto& table = model::table_of(static_cast<model::TableSize>(i % 3));
        auto balls = Scatter(random, table).balls(2 + random.below(10), false);
        balls[0].velocity_mps.z = random.uniform(-3.0, 3.0);
        Diagnostics diagnostics;
        const auto record = solved(table, {}, balls, &diagnostics);
        expect_lawful(diagnostics);
        for (const auto& track : record.timeline.tracks) {
            const Motion last = track.segments.back().motion;
            EXPECT_NE(last, Motion::Airborne);
            if (last == Motion::OffTable) ++left;
        }
    }
    EXPECT_GT(left, 10) << "some fly over the rails";
}

TEST(Invariants, HoldInTheClassicPreset) {
    base::Random random(33);
    for (int i = 0; i < 300; ++i) {
        const auto& table = model::table_of(static_cast<model::TableSize>(i % 3));
        Diagnostics diagnostics;
        const auto balls = Scatter(random, table).balls(2 + random.below(15), i % 2 == 0);
        expect_sound(table, solved(table, classic_parameters(), balls, &diagnostics));
        expect_lawful(diagnostics);
    }
}

}  // namespace
}  // namespace billiards::physics
