// Takes a number of matches; gives their faults and figures.
#include "tests/long/matches.h"

#include "common/rules/verdict.h"
#include "tests/common/match/random_play.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace billiards {

namespace {

using rules::Game;

constexpr std::pair<Game, const char*> kGames[] = {{Game::EightBall, "eight-ball"},
                                                   {Game::NineBall, "nine-ball"},
                                                   {Game::TenBall, "ten-ball"},
                                                   {Game::StraightPool, "straight pool"},
                                                   {Game::Practice, "practice"}};

bool prove_game(Game game, const char* name, const MatchesOrder& order, std::ostream& out) {
    std::vector<int> shots;
    std::uint64_t faults = 0;
    for (std::uint64_t number = order.first; number < order.first + order.count; ++number) {
        const match::PlayedMatch played = match::play_match(game, number);
        shots.push_back(played.shots);
        if (!played.fault) continue;
        ++faults;
        out << name << " " << number << ", shot " << played.shots << ": " << *played.fault << '\n';
    }
    std::sort(shots.begin(), shots.end());
    const auto at = [&](double share) {
        return shots[static_cast<std::size_t>(share * static_cast<double>(shots.size() - 1))];
    };
    out << name << ": " << order.count << " matches, " << faults << " faults; shots p50 " << at(0.5)
        << ", p99 " << at(0.99) << ", most " << shots.back() << std::endl;
    return faults == 0;
}

}  // namespace

bool prove_matches(const MatchesOrder& order, std::ostream& out) {
    bool sound = true;
    for (const auto& [game, name] : kGames) sound = prove_game(game, name, order, out) && sound;
    return sound;
}

}  // namespace billiards
