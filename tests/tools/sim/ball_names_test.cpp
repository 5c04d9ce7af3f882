// Holds how a case's names become ids.
#include "tools/sim/ball_names.h"

#include <gtest/gtest.h>

namespace billiards::tools {
namespace {

TEST(BallNames, CueAndNumbersAreThemselvesAndOthersTakeWhatIsLeft) {
    const BallNames names({"red", "3", "cue", "1", "white"});
    EXPECT_EQ(names.id_of("cue").number, 0);
    EXPECT_EQ(names.id_of("3").number, 3);
    EXPECT_EQ(names.id_of("1").number, 1);
    EXPECT_EQ(names.id_of("red").number, 2);
    EXPECT_EQ(names.id_of("white").number, 4);
    EXPECT_EQ(names.name_of(model::BallId{4}), "white");
}

TEST(BallNames, TwentyTwoFreeNamesFindRoom) {
    std::vector<std::string> many(model::kMaxBalls, "b");
    for (std::size_t i = 0; i < many.size(); ++i) many[i] += std::to_string(i);
    const BallNames names(many);
    EXPECT_EQ(names.id_of("b0").number, 1);
    EXPECT_EQ(names.id_of("b21").number, 0);
}

TEST(BallNames, TranslateTheEnginesSentences) {
    const BallNames names({"cue", "red"});
    EXPECT_EQ(names.translated("ball 0, ball 1"), "balls.cue, balls.red");
    EXPECT_EQ(names.translated("ball 1 position_m.x"), "balls.red position_m.x");
    EXPECT_EQ(names.translated("gravity_mps2"), "gravity_mps2");
}

}  // namespace
}  // namespace billiards::tools
