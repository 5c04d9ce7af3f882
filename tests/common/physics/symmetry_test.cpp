// Holds that neither names nor directions decide how balls part: to the last bit.
#include "tests/common/physics/still_life.h"

#include <numeric>

namespace billiards::physics {
namespace {

timeline::Segment turned(timeline::Segment segment) {
    for (Vec3* v : {&segment.position_m, &segment.velocity_mps, &segment.acceleration_mps2,
                    &segment.spin_radps, &segment.spin_rate_radps2}) {
        v->x = -v->x;
        v->y = -v->y;
    }
    return segment;
}

std::vector<BallStart> turned(std::vector<BallStart> balls) {
    for (BallStart& ball : balls) {
        for (Vec3* v : {&ball.position_m, &ball.velocity_mps, &ball.spin_radps}) {
            v->x = -v->x;
            v->y = -v->y;
        }
    }
    return balls;
}

void expect_half_turn_agrees(const model::TableSpec& table, const std::vector<BallStart>& balls) {
    const auto record = solved(table, {}, balls);
    const auto other = solved(table, {}, turned(balls));
    EXPECT_EQ(record.duration_s, other.duration_s);
    for (const auto& track : record.timeline.tracks) {
        const auto& mirrored = track_of(other, track.ball.number).segments;
        ASSERT_EQ(track.segments.size(), mirrored.size());
        for (std::size_t i = 0; i < mirrored.size(); ++i) {
            ASSERT_EQ(track.segments[i], turned(mirrored[i]));
        }
    }
}

ScatterKind any_kind(int number) {
    return {
        .many_move = number % 2 == 0, .are_unequal = number % 3 == 0, .many_fly = number % 5 == 0};
}

TEST(Symmetry, AHalfTurnOfTheLayoutTurnsTheShotToTheBit) {
    base::Random random(21);
    expect_half_turn_agrees(nine_foot(), break_shot(nine_foot(), {9, 0.1}, {0, 40, 30}));
    for (int i = 0; i < 120; ++i) {
        expect_half_turn_agrees(nine_foot(), Scatter(random, nine_foot()).balls(any_kind(i)));
    }
}

TEST(Symmetry, PermutedNamesGiveThePermutedShotToTheBit) {
    base::Random random(22);
    for (int i = 0; i < 60; ++i) {
        const auto balls = i == 0 ? break_shot(nine_foot(), {9, 0.1})
                                  : Scatter(random, nine_foot()).balls(12, i % 2 == 0);
        std::vector<std::uint8_t> names(balls.size());
        std::iota(names.begin(), names.end(), std::uint8_t{0});
        for (std::size_t k = names.size() - 1; k > 0; --k)
            std::swap(names[k], names[random.below(k + 1)]);
        auto renamed = balls;
        for (std::size_t k = 0; k < balls.size(); ++k) renamed[k].ball.number = names[k];
        const auto record = solved(nine_foot(), {}, balls);
        const auto other = solved(nine_foot(), {}, renamed);
        for (std::size_t k = 0; k < balls.size(); ++k) {
            ASSERT_EQ(track_of(record, static_cast<int>(k)).segments,
                      track_of(other, names[k]).segments);
        }
    }
}

TEST(Symmetry, AStraightBreakStaysItsOwnMirrorImageToTheBit) {
    // Rows of the rack, each from -y to +y: the partners across the long string.
    const auto record = solved(nine_foot(), {}, break_shot(nine_foot(), {10, 0}, {0, 60, 0}));
    int first = 1;
    for (int row = 0; row < 5; ++row) {
        for (int place = 0; place <= row; ++place) {
            const auto& one = track_of(record, first + place).segments;
            const auto& other = track_of(record, first + row - place).segments;
            ASSERT_EQ(one.size(), other.size());
            for (std::size_t i = 0; i < one.size(); ++i) {
                EXPECT_EQ(one[i].start_s, other[i].start_s);
                EXPECT_EQ(one[i].position_m.x, other[i].position_m.x);
                EXPECT_EQ(one[i].position_m.y, -other[i].position_m.y);
                EXPECT_EQ(one[i].velocity_mps.y, -other[i].velocity_mps.y);
                EXPECT_EQ(one[i].spin_radps.z, -other[i].spin_radps.z);
            }
        }
        first += row + 1;
    }
}

TEST(Symmetry, TheSameShotHasTheSameHash) {
    base::Random random(23);
    for (int i = 0; i < 20; ++i) {
        const auto balls = Scatter(random, nine_foot()).balls(14, true);
        const auto record = solved(nine_foot(), {}, balls);
        EXPECT_EQ(record.hash, solved(nine_foot(), {}, balls).hash);
        EXPECT_EQ(record.hash, timeline::hash_of(record));
        auto backwards = balls;
        std::reverse(backwards.begin(), backwards.end());
        EXPECT_EQ(record.hash, solved(nine_foot(), {}, backwards).hash) << "order of the input";
    }
}

}  // namespace
}  // namespace billiards::physics
