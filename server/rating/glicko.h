// Takes a player's rating and what was played; gives the rating afterwards: Glicko.
#pragma once

#include <span>

namespace billiards::server {

// M. E. Glickman, "Parameter estimation in large dynamic paired comparison experiments", Applied
// Statistics 48 (1999), 377-394; with a worked example in his "The Glicko system".

inline constexpr double kFirstRating = 1500.0;
inline constexpr double kLeastDeviation = 30.0;   ///< However much is played.
inline constexpr double kMostDeviation = 350.0;   ///< Of somebody about whom nothing is known.
inline constexpr double kUsualDeviation = 50.0;   ///< Of somebody who plays often.
inline constexpr double kForgottenAfter_d = 730;  ///< Days of rest from the usual to the most.

struct Rating {
    double rating = kFirstRating;
    double deviation = kMostDeviation;
    friend bool operator==(const Rating&, const Rating&) = default;
};

/// The opponent as they were before, and how it went.
struct RatedGame {
    Rating opponent;
    double score = 0.0;  ///< 1: won, 0.5: drawn, 0: lost.
};

/// What is known grows old: the deviation grows with the days since the last game; below 0 days
/// counts as none.
Rating rested(Rating before, double days);

/// After the games of one period, all of them against opponents as they were before it.
Rating rated(Rating before, std::span<const RatedGame> games);

}  // namespace billiards::server
