// Takes a number; gives the shot of that number.
#include "tests/common/physics/numbered_case.h"

#include "tests/common/physics/layouts.h"

#include <array>

namespace billiards::physics {

namespace {

constexpr std::uint64_t kKinds = 8;
constexpr std::uint64_t kScattered = 5;
constexpr std::uint64_t kUnequal = 6;
constexpr std::uint64_t kFlying = 7;

std::vector<BallStart> hard_break(base::Random& random, const model::TableSpec& table) {
    const double speed = random.uniform(8.0, 12.0);
    const double angle = base::radians(random.uniform(-1.5, 1.5));
    Vec3 spin{};
    for (int axis = 0; axis < 3; ++axis) spin[axis] = random.uniform(-80.0, 80.0);
    return break_shot(table, speed * unit_vector(angle), spin);
}

std::vector<BallStart> scattered(base::Random& random, const model::TableSpec& table,
                                 std::uint64_t kind) {
    const bool may_differ = kind == kFlying && random.below(2) == 0;
    return Scatter(random, table)
        .balls({.balls = 2 + random.below(model::kMaxBalls - 1),
                .many_move = random.below(2) == 0,
                .are_unequal = kind == kUnequal || may_differ,
                .many_fly = kind == kFlying});
}

Parameters any_parameters(base::Random& random, std::uint64_t kind) {
    // Nothing flies in the original design.
    if (kind != kFlying && random.below(4) == 0) return classic_parameters();
    constexpr std::array kCushions{CushionModel::Han2005, CushionModel::Mathavan2010,
                                   CushionModel::Stronge, CushionModel::Mirror};
    Parameters parameters;
    parameters.cushion = kCushions[random.below(kCushions.size())];
    if (random.below(4) == 0) parameters.ball_ball = BallBallModel::Elastic;
    return parameters;
}

}  // namespace

NumberedCase numbered_case(std::uint64_t number) {
    base::Random random(number);
    const std::uint64_t kind = number % kKinds;
    const auto& table = model::table_of(static_cast<model::TableSize>(random.below(3)));
    if (kind < kScattered) return {table, {}, hard_break(random, table)};
    const Parameters parameters = any_parameters(random, kind);
    return {table, parameters, scattered(random, table, kind)};
}

}  // namespace billiards::physics
