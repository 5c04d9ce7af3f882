// Takes a game's name; gives its rules.
#include "common/rules/ruleset.h"

#include "common/base/check.h"
#include "common/rules/games.h"

namespace billiards::rules {

const Ruleset& ruleset_of(Game game) {
    switch (game) {
        case Game::EightBall:
            return eight_ball();
        case Game::NineBall:
            return nine_ball();
        case Game::TenBall:
            return ten_ball();
        case Game::StraightPool:
            return straight_pool();
        case Game::Practice:
            return practice();
    }
    CHECK(false);
}

}  // namespace billiards::rules
