// Holds what must be true of every shot: over random breaks and scattered, frozen, spinning, flying
// and unequal balls.
#include "tests/common/physics/soundness.h"
#include "tests/common/physics/still_life.h"

namespace billiards::physics {
namespace {

timeline::ShotRecord expect_sound(const model::TableSpec& table, const Parameters& parameters,
                                  const std::vector<BallStart>& balls) {
    Diagnostics diagnostics;
    const auto record = solved(table, parameters, balls, &diagnostics);
    if (record.timeline.tracks.empty()) return record;
    EXPECT_EQ(first_fault({table, parameters, balls, record, diagnostics}), std::nullopt);
    return record;
}

const model::TableSpec& table_number(int number) {
    return model::table_of(static_cast<model::TableSize>(number % 3));
}

TEST(Invariants, HoldOverRandomBreaks) {
    base::Random random(31);
    std::size_t most_events = 0;
    for (int i = 0; i < 300; ++i) {
        const double speed = random.uniform(6.0, 12.0);
        const double angle = base::radians(random.uniform(-2.0, 2.0));
        const Vec3 spin{random.uniform(-60, 60), random.uniform(-60, 60), random.uniform(-60, 60)};
        const auto& table = table_number(i);
        const auto record =
            expect_sound(table, {}, break_shot(table, speed * unit_vector(angle), spin));
        most_events = std::max(most_events, record.events.size());
    }
    EXPECT_LT(most_events, 400U) << "breaks end within a few hundred events";
}

TEST(Invariants, HoldOverScatteredFrozenAndSpinningBalls) {
    base::Random random(32);
    for (int i = 0; i < 400; ++i) {
        const auto& table = table_number(i);
        expect_sound(table, {}, Scatter(random, table).balls(2 + random.below(15), i % 2 == 0));
    }
}

TEST(Invariants, HoldOverBallsOfUnequalMassAndSize) {
    base::Random random(35);
    for (int i = 0; i < 300; ++i) {
        const auto& table = table_number(i);
        const ScatterKind kind{
            .balls = 2 + random.below(15), .many_move = i % 2 == 0, .are_unequal = true};
        expect_sound(table, {}, Scatter(random, table).balls(kind));
    }
}

TEST(Invariants, HoldOverFlyingBalls) {
    base::Random random(34);
    int left = 0;
    for (int i = 0; i < 400; ++i) {
        const auto& table = table_number(i);
        const ScatterKind kind{.balls = 2 + random.below(10),
                               .many_move = i % 2 == 0,
                               .are_unequal = i % 4 == 0,
                               .many_fly = true};
        const auto record = expect_sound(table, {}, Scatter(random, table).balls(kind));
        left += static_cast<int>(events_of(record, EventKind::OffTable).size());
    }
    EXPECT_GT(left, 10) << "some fly over the rails";
}

TEST(Invariants, HoldInTheClassicPreset) {
    base::Random random(33);
    for (int i = 0; i < 300; ++i) {
        const auto& table = table_number(i);
        expect_sound(table, classic_parameters(),
                     Scatter(random, table).balls(2 + random.below(15), i % 2 == 0));
    }
}

}  // namespace
}  // namespace billiards::physics
