// Takes a game's name; gives its rules.
#include "common/rules/ruleset.h"

#include "common/base/check.h"
#include "common/rules/eight_ball.h"

namespace billiards::rules {

const Ruleset& ruleset_of(Game game) {
    static const EightBall eight_ball;
    switch (game) {
        case Game::EightBall:
            return eight_ball;
    }
    CHECK(false);
}

}  // namespace billiards::rules
