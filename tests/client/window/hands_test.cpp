// Uses mouse and keys over the table, before a break; gives whether each does what the help says.
#include "tests/client/window/shared_window.h"

#include <cmath>
#include <numbers>
#include <string>

namespace billiards::client {
namespace {

double degrees_between(double a_deg, double b_deg) {
    return std::remainder(a_deg - b_deg, 360.0);
}

/// From the cue ball to a ball that lies.
double way_deg(const Json& shown, const char* ball) {
    const Json& from = shown.at("cue_ball");
    const Json& to = shown.at("table").at("match").at("balls").at(ball);
    return std::atan2(to.at(1).get<double>() - from.at(1).get<double>(),
                      to.at(0).get<double>() - from.at(0).get<double>()) *
           180.0 / std::numbers::pi;
}

double angle_deg(const Json& shown) {
    return shown.at("shot").at("angle_deg");
}

double power(const Json& shown) {
    return shown.at("shot").at("power");
}

bool is_near(double a, double b) {
    return std::fabs(a - b) < 1e-6;
}

class WindowHands : public SharedWindow {
  protected:
    /// The menu closed, nothing called, and the cue ball in hand behind the head string.
    void SetUp() override {
        until_turn(window_);
        if (window_.seen().at("set_down") == true) start_next_match();
        window_.tap("c");
        window_.click("Reset Camera");
        window_.until("shows the first view", [](const Json& shown) {
            return is_near(shown.at("camera").at("distance_m"), 3.528) &&
                   shown.at("shot").at("call").is_null();
        });
    }

    void start_next_match() {
        window_.tap("Escape");
        window_.click("Concede the match");
        window_.until_there("Leave the table");
        window_.click("Back to the table");
        until_turn(window_);
    }

    Json cue_ball() const { return window_.seen().at("cue_ball"); }

    void until_cue_ball_moved(const Json& from, double by_m) {
        window_.until("moves the cue ball by " + std::to_string(by_m), [&](const Json& shown) {
            const Json& now = shown.at("cue_ball");
            return is_near(std::hypot(now.at(0).get<double>() - from.at(0).get<double>(),
                                      now.at(1).get<double>() - from.at(1).get<double>()),
                           by_m);
        });
    }
    void set_down() {
        window_.tap("Return");
        window_.until("sets the cue ball down",
                      [](const Json& shown) { return shown.at("set_down") == true; });
        until_turn(window_);
    }
    void tap_to_turn(const std::string& keys, double by_deg) {
        const double before_deg = angle_deg(window_.seen());
        window_.tap(keys);
        window_.until("turns the cue by " + std::to_string(by_deg), [&](const Json& shown) {
            return is_near(degrees_between(angle_deg(shown), before_deg), by_deg);
        });
    }
    void tap_for_power(const std::string& key, double by) {
        const double before = power(window_.seen());
        window_.tap(key);
        window_.until("has more or less power",
                      [&](const Json& shown) { return is_near(power(shown) - before, by); });
    }
    /// Somewhere on the bed, with no ball near.
    Point empty_cloth() const { return window_.ball(1) + Point{0, 60}; }
};

TEST_F(WindowHands, TheMouseOverTheTableAimsAtWhatItPointsAt) {
    window_.move(window_.ball(1));
    EXPECT_NEAR(degrees_between(angle_deg(window_.seen()), way_deg(window_.seen(), "1")), 0, 0.5);
}

TEST_F(WindowHands, CtrlAimsByATenthOfTheWay) {
    window_.move(empty_cloth());
    const double from_deg = angle_deg(window_.seen());
    window_.move(empty_cloth() + Point{120, 0});
    const double whole_deg = degrees_between(angle_deg(window_.seen()), from_deg);
    window_.move(empty_cloth());
    window_.hold("ctrl");
    window_.move(empty_cloth() + Point{120, 0});
    window_.release("ctrl");
    EXPECT_NEAR(degrees_between(angle_deg(window_.seen()), from_deg), whole_deg / 10, 1e-6);
    EXPECT_GT(std::fabs(whole_deg), 1.0);
}

TEST_F(WindowHands, ArrowsMoveTheCueBallInHandByAMillimetreAndWithShiftByTen) {
    const Json start = cue_ball();
    window_.tap("Down");
    until_cue_ball_moved(start, 0.001);
    window_.tap("Up");
    until_cue_ball_moved(start, 0.0);
    window_.tap("shift+Left");
    until_cue_ball_moved(start, 0.010);
    window_.tap("shift+Right");
    until_cue_ball_moved(start, 0.0);
}

TEST_F(WindowHands, TheCueBallInHandIsDraggedAndSetDownWhereItIsLetGo) {
    const Point to = window_.ball(0) + Point{60, 0};
    window_.drag(window_.ball(0), {60, 0});
    window_.until("sets the cue ball down",
                  [](const Json& shown) { return shown.at("set_down") == true; });
    EXPECT_NEAR(window_.ball(0).x, to.x, 2);
    EXPECT_NEAR(window_.ball(0).y, to.y, 2);
}

TEST_F(WindowHands, TheCueBallIsNotSetDownWhereItMayNotLie) {
    window_.drag(window_.ball(0), Point{0, window_.ball(1).y - window_.ball(0).y});
    window_.until("says that it may not lie there", [](const Json& shown) {
        return shown.at("information").back() == "The cue ball may not lie there.";
    });
    EXPECT_EQ(window_.seen().at("set_down"), false);
    start_next_match();
}

TEST_F(WindowHands, ArrowsAimAndSetThePowerOnceTheCueBallIsDown) {
    set_down();
    tap_to_turn("Left", 0.03);
    tap_to_turn("Right", -0.03);
    tap_to_turn("shift+Left", 0.23);
    tap_to_turn("shift+Right", -0.23);
    tap_for_power("Down", -0.01);
    tap_for_power("Up", 0.01);
}

TEST_F(WindowHands, ShiftCountsThatWasLetGoBeforeTheArrow) {
    set_down();
    const double before_deg = angle_deg(window_.seen());
    window_.roll_over("shift", "Left");
    window_.until("turns the cue by a big step", [&](const Json& shown) {
        return is_near(degrees_between(angle_deg(shown), before_deg), 0.23);
    });
}

TEST_F(WindowHands, AnArrowThatIsHeldGoesOn) {
    set_down();
    const double before = power(window_.seen());
    window_.hold("Down");
    window_.until("goes on", [&](const Json& shown) { return power(shown) < before - 0.045; });
    window_.release("Down");
}

TEST_F(WindowHands, TheWheelSetsThePower) {
    window_.move(empty_cloth());
    const double before = power(window_.seen());
    window_.wheel(-2);
    window_.until("has less power",
                  [&](const Json& shown) { return is_near(power(shown), before - 0.02); });
    window_.wheel(2);
    window_.until("has its power again",
                  [&](const Json& shown) { return is_near(power(shown), before); });
}

TEST_F(WindowHands, ShiftAndTheWheelZoom) {
    window_.move(empty_cloth());
    const double before = power(window_.seen());
    const double before_m = window_.seen().at("camera").at("distance_m");
    window_.hold("shift");
    window_.wheel(1);
    window_.until("comes nearer", [&](const Json& shown) {
        return shown.at("camera").at("distance_m") < 0.95 * before_m;
    });
    window_.release("shift");
    EXPECT_EQ(power(window_.seen()), before);
}

TEST_F(WindowHands, HoldingEMovesTheTipAndETwiceCentresIt) {
    window_.move(empty_cloth());
    const double before_deg = angle_deg(window_.seen());
    window_.hold("e");
    window_.move(empty_cloth() + Point{40, -20});
    window_.release("e");
    const Json tip = window_.seen().at("shot").at("tip");
    EXPECT_NEAR(tip.at(0).get<double>(), -0.2, 1e-6);
    EXPECT_NEAR(tip.at(1).get<double>(), 0.1, 1e-6);
    EXPECT_EQ(angle_deg(window_.seen()), before_deg);
    window_.tap("e");
    window_.tap("e");
    window_.until("centres the tip", [](const Json& shown) {
        return shown.at("shot").at("tip") == Json({0.0, 0.0});
    });
}

TEST_F(WindowHands, HoldingBRaisesTheCue) {
    window_.move(empty_cloth());
    window_.hold("b");
    window_.move(empty_cloth() + Point{0, -50});
    EXPECT_NEAR(window_.seen().at("shot").at("elevation_deg").get<double>(), 15.0, 1e-6);
    window_.move(empty_cloth());
    window_.release("b");
    EXPECT_NEAR(window_.seen().at("shot").at("elevation_deg").get<double>(), 0.0, 1e-6);
}

TEST_F(WindowHands, DraggingWithTheRightButtonOrbitsAndDoesNotAim) {
    window_.move(empty_cloth());
    const Json before = window_.seen();
    window_.drag(empty_cloth(), {30, 12}, 3);
    const Json& eye = window_.seen().at("camera");
    EXPECT_NEAR(degrees_between(eye.at("azimuth_deg"), before.at("camera").at("azimuth_deg")),
                -10.5, 1e-6);
    EXPECT_NEAR(eye.at("elevation_deg").get<double>(),
                before.at("camera").at("elevation_deg").get<double>() + 4.2, 1e-6);
    EXPECT_EQ(angle_deg(window_.seen()), angle_deg(before));
}

TEST_F(WindowHands, OLooksFromAbove) {
    window_.tap("o");
    window_.until("looks from above",
                  [](const Json& shown) { return shown.at("camera").at("elevation_deg") > 89.0; });
}

TEST_F(WindowHands, VGoesRoundThroughFourViews) {
    const Json first = window_.seen().at("camera");
    for (int view = 1; view <= 4; ++view) {
        const Json before = window_.seen().at("camera");
        window_.tap("v");
        window_.until("shows another view",
                      [&](const Json& shown) { return shown.at("camera") != before; });
        EXPECT_EQ(window_.seen().at("camera") == first, view == 4) << view;
    }
}

TEST_F(WindowHands, THidesTheAimLineAndShowsItAgain) {
    EXPECT_EQ(window_.seen().at("aim_line"), true);
    window_.tap("t");
    window_.until("hides the line", [](const Json& shown) { return !shown.at("aim_line"); });
    window_.tap("t");
    window_.until("shows the line", [](const Json& shown) { return shown.at("aim_line") == true; });
}

TEST_F(WindowHands, AClickIsOneWhereItHappenedHoweverFastTheHandRushesOn) {
    const double power_before = power(window_.seen());
    window_.click_rushing(window_.ball(1), {0, 120});
    window_.until("has the ball clicked",
                  [](const Json& shown) { return shown.at("called_ball") == 1; });
    EXPECT_EQ(window_.seen().at("table").at("rolling"), false);
    EXPECT_NEAR(power(window_.seen()), power_before, 1e-9);
    EXPECT_EQ(window_.seen().at("shot").at("pulled"), false);
}

TEST_F(WindowHands, CForgetsTheCall) {
    window_.click(window_.ball(1));
    window_.until("marks the ball", [](const Json& shown) { return shown.at("called_ball") == 1; });
    window_.click(window_.pocket(3));
    window_.until("calls the ball",
                  [](const Json& shown) { return shown.at("shot").at("call").is_object(); });
    window_.tap("c");
    window_.until("calls nothing",
                  [](const Json& shown) { return shown.at("shot").at("call").is_null(); });
}

class WindowHandsPull : public WindowHands {
  protected:
    /// Pulls the cue back; the aim stays while it is held.
    void pull() {
        window_.move(empty_cloth());
        before_ = window_.seen();
        window_.press();
        window_.move(empty_cloth() + Point{0, 70});
        EXPECT_EQ(window_.seen().at("shot").at("pulled"), true);
        EXPECT_EQ(angle_deg(window_.seen()), angle_deg(before_));
    }
    void expect_that_nothing_was_shot() {
        window_.until("lets the cue go",
                      [](const Json& shown) { return shown.at("shot").at("pulled") == false; });
        window_.let_go();
        EXPECT_EQ(power(window_.seen()), power(before_));
        EXPECT_EQ(window_.seen().at("menu"), false);
        EXPECT_EQ(window_.seen().at("acting"), before_.at("acting"));
        EXPECT_EQ(window_.seen().at("table").at("match"), before_.at("table").at("match"));
    }

  private:
    Json before_;
};

TEST_F(WindowHandsPull, IsCancelledByTheRightButton) {
    pull();
    window_.press(3);
    window_.let_go(3);
    expect_that_nothing_was_shot();
}

TEST_F(WindowHandsPull, IsCancelledByEscape) {
    pull();
    window_.tap("Escape");
    expect_that_nothing_was_shot();
}

TEST_F(WindowHands, EscapeOpensTheMenuAndNeverForfeits) {
    const Json match = window_.seen().at("table").at("match");
    window_.tap("Escape");
    window_.until_there("Back to the table");
    EXPECT_EQ(window_.seen().at("table").at("match"), match);
    window_.tap("Escape");
    window_.until("closes the menu", [](const Json& shown) { return !shown.at("menu"); });
    EXPECT_EQ(window_.seen().at("table").at("match"), match);
}

TEST_F(WindowHands, F1ShowsTheHelp) {
    window_.tap("F1");
    window_.until("shows the help", [](const Json& shown) {
        return shown.at("menu") == true && shown.at("controls").contains("Back");
    });
    window_.click("Back");
    window_.click("Back to the table");
    until_turn(window_);
}

TEST_F(WindowHands, F11FillsTheScreenAndComesBack) {
    const Json before = window_.seen().at("window");
    window_.tap("F11");
    window_.until("fills the screen", [](const Json& shown) {
        return shown.at("window") == Json({1280.0, 720.0});
    });
    window_.tap("F11");
    window_.until("comes back", [&](const Json& shown) { return shown.at("window") == before; });
}

}  // namespace
}  // namespace billiards::client
