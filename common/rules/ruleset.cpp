// Takes a game's name; gives its rules.
#include "common/rules/ruleset.h"

#include "common/base/check.h"
#include "common/rules/eight_ball.h"
#include "common/rules/nine_ball.h"
#include "common/rules/ten_ball.h"

namespace billiards::rules {

const Ruleset& ruleset_of(Game game) {
    static const EightBall eight_ball;
    static const NineBall nine_ball;
    static const TenBall ten_ball;
    switch (game) {
        case Game::EightBall:
            return eight_ball;
        case Game::NineBall:
            return nine_ball;
        case Game::TenBall:
            return ten_ball;
        case Game::StraightPool:
        case Game::Practice:
            break;  // Not on the wire yet, so that nobody can ask for them.
    }
    CHECK(false);
}

}  // namespace billiards::rules
