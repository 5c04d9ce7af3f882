// Takes a player's rating and what was played; gives the rating afterwards: Glicko.
#include "server/rating/glicko.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace billiards::server {
namespace {

/// q = ln 10 / 400: ratings are on a scale of powers of ten.
constexpr double kQ = std::numbers::ln10 / 400.0;

/// c^2: how much the deviation's square grows in a day.
constexpr double kGrowth =
    (kMostDeviation * kMostDeviation - kUsualDeviation * kUsualDeviation) / kForgottenAfter_d;

/// g(RD): a game tells less against an opponent about whom less is known.
double weight(double deviation) {
    const double x = kQ * deviation / std::numbers::pi;
    return 1.0 / std::sqrt(1.0 + 3.0 * x * x);
}

/// E(s | r, r_j, RD_j): what was to be expected.
double expected_score(const Rating& player, const Rating& opponent) {
    const double exponent = -weight(opponent.deviation) * (player.rating - opponent.rating) / 400.0;
    return 1.0 / (1.0 + std::pow(10.0, exponent));
}

}  // namespace

Rating rested(Rating before, double days) {
    const double square = before.deviation * before.deviation + kGrowth * std::max(days, 0.0);
    before.deviation = std::min(std::sqrt(square), kMostDeviation);
    return before;
}

Rating rated(Rating before, std::span<const RatedGame> games) {
    double information = 0.0;  // 1 / d^2
    double surprise = 0.0;
    for (const RatedGame& game : games) {
        const double g = weight(game.opponent.deviation);
        const double expected = expected_score(before, game.opponent);
        information += kQ * kQ * g * g * expected * (1.0 - expected);
        surprise += g * (game.score - expected);
    }
    const double precision = 1.0 / (before.deviation * before.deviation) + information;
    return {.rating = before.rating + kQ / precision * surprise,
            .deviation = std::clamp(std::sqrt(1.0 / precision), kLeastDeviation, kMostDeviation)};
}

}  // namespace billiards::server
