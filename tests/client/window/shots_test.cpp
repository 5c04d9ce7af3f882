// Shoots in every way that there is; gives whether each is played, and told.
#include "tests/client/window/shared_window.h"

#include <string>

namespace billiards::client {
namespace {

int shots(const Json& shown) {
    return shown.at("table").at("match").at("shots");
}

class WindowShots : public SharedWindow {
  protected:
    /// Somebody may shoot, and the mouse aims at a ball.
    void SetUp() override {
        until_turn(window_);
        aim_at_a_ball(window_);
    }

    void until_rolling() {
        window_.until("shows the balls roll",
                      [](const Json& shown) { return shown.at("table").at("rolling") == true; });
    }
    /// The roll is skipped, and its verdict shown.
    void until_played(int before) {
        until_rolling();
        window_.tap("z");
        window_.until("shows the shot's end", [&](const Json& shown) {
            return shown.at("table").at("rolling") == false && shots(shown) == before + 1;
        });
    }
};

TEST_F(WindowShots, ShootPlaysTheShotAsItIsSetUp) {
    const int before = shots(window_.seen());
    window_.click("Shoot");
    until_played(before);
}

TEST_F(WindowShots, SpacePlaysIt) {
    const int before = shots(window_.seen());
    window_.tap("space");
    until_played(before);
}

TEST_F(WindowShots, SpacePlaysItAtOnceAfterAButtonWasClicked) {
    const int before = shots(window_.seen());
    window_.click("Center Spin");
    window_.tap("space");
    until_played(before);
}

TEST_F(WindowShots, PullingBackAndLettingGoPlaysItAsFarAsItWasPulled) {
    const int before = shots(window_.seen());
    window_.press();
    window_.move(window_.mouse() + Point{0, 96});
    window_.let_go();
    until_rolling();
    EXPECT_NEAR(window_.seen().at("shot").at("power").get<double>(), 0.3, 1e-6);
    until_played(before);
}

TEST_F(WindowShots, APullEndsWhereItWasLetGoHoweverFastTheHandRushesOn) {
    const int before = shots(window_.seen());
    window_.pull_rushing(window_.mouse(), {0, 96});
    until_rolling();
    EXPECT_NEAR(window_.seen().at("shot").at("power").get<double>(), 0.3, 1e-6);
    until_played(before);
}

TEST_F(WindowShots, NobodyShootsWhileTheBallsRoll) {
    const int before = shots(window_.seen());
    window_.tap("space");
    until_rolling();
    EXPECT_TRUE(window_.seen().at("acting").is_null());
    window_.tap("space");
    until_played(before);
    until_turn(window_);
    EXPECT_EQ(shots(window_.seen()), before + 1);
}

TEST_F(WindowShots, InformationSaysWhatHappenedAndWhatFollows) {
    const int before = shots(window_.seen());
    window_.tap("space");
    until_rolling();
    EXPECT_EQ(window_.seen().at("information").back(), "The balls roll.");
    until_played(before);
    const Json& said = window_.seen().at("information");
    ASSERT_GE(said.size(), 2U);
    const std::string happened = said.at(said.size() - 2);
    EXPECT_NE(happened.find("shot"), std::string::npos) << said;
    EXPECT_NE(happened.find("Player "), std::string::npos) << said;
    EXPECT_TRUE(said.back().get<std::string>().starts_with("Player ")) << said;
}

TEST_F(WindowShots, ASafetyIsSaidAndTakenBackOnceTheRackIsBroken) {
    while (window_.seen().at("may_say").empty()) {
        const int before = shots(window_.seen());
        window_.tap("space");
        until_played(before);
        until_turn(window_);
        aim_at_a_ball(window_);
    }
    for (const Json& call : {Json("safety"), Json(nullptr)}) {
        window_.click("Safety");
        window_.until("says it, or takes it back",
                      [&](const Json& shown) { return shown.at("shot").at("call") == call; });
    }
}

}  // namespace
}  // namespace billiards::client
