// Takes a number of matches; gives whether all of every game ended, won and sound.
#pragma once

#include <cstdint>
#include <ostream>

namespace billiards {

struct MatchesOrder {
    std::uint64_t count = 10'000;
    std::uint64_t first = 0;
};

/// Plays matches of numbers first, first + 1, ... at each game, by a chooser at random over the
/// real engine. Writes every fault with the number of its match, and a line of figures a game.
bool prove_matches(const MatchesOrder& order, std::ostream& out);

}  // namespace billiards
