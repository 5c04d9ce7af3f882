// Takes a game's name; gives its rules.
#include "common/rules/ruleset.h"

#include "common/base/check.h"
#include "common/rules/eight_ball.h"
#include "common/rules/nine_ball.h"
#include "common/rules/practice.h"
#include "common/rules/straight_pool.h"
#include "common/rules/ten_ball.h"

namespace billiards::rules {

const Ruleset& ruleset_of(Game game) {
    static const EightBall eight_ball;
    static const NineBall nine_ball;
    static const TenBall ten_ball;
    static const StraightPool straight_pool;
    static const Practice practice;
    switch (game) {
        case Game::EightBall:
            return eight_ball;
        case Game::NineBall:
            return nine_ball;
        case Game::TenBall:
            return ten_ball;
        case Game::StraightPool:
            return straight_pool;
        case Game::Practice:
            return practice;
    }
    CHECK(false);
}

}  // namespace billiards::rules
