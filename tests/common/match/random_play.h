// Takes settings and a seed; gives a whole match by a chooser at random that mostly aims at what
// may be hit, over the real engine.
#pragma once

#include "common/base/random.h"
#include "common/match/match.h"

#include <cstdint>
#include <optional>
#include <string>

namespace billiards::match {

/// Any settings that let a match end soon: one rack, few points.
Settings short_settings(rules::Game game, base::Random& random);

/// A legal command of the seat that is to act; the match is not over.
Command random_legal_command(const MatchState& match, base::Random& random);

/// No match that its rules decide takes as many; one that does has failed.
inline constexpr int kMostShots = 2000;

struct PlayedMatch {
    int shots = 0;
    std::optional<std::string> fault;  ///< None: it ended, was won, and was sound throughout.
};
PlayedMatch play_match(rules::Game game, std::uint64_t seed);

}  // namespace billiards::match
