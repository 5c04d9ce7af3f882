// Uses every control of the panel with mouse and keyboard; gives whether each does what its name
// says.
#include "tests/client/window/shared_window.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

namespace billiards::client {
namespace {

class WindowPanel : public SharedWindow {
  protected:
    double power() const { return window_.seen().at("shot").at("power"); }
    double angle_deg() const { return window_.seen().at("shot").at("angle_deg"); }
    double camera(const char* what) const { return window_.seen().at("camera").at(what); }

    void until_power(double power) {
        window_.until("shows power " + std::to_string(power), [&](const Json& shown) {
            return std::fabs(shown.at("shot").at("power").get<double>() - power) < 1e-9;
        });
    }
    void until_call(const Json& call) {
        window_.until("calls " + call.dump(),
                      [&](const Json& shown) { return shown.at("shot").at("call") == call; });
    }
    void until_camera(const char* what, const std::function<bool(double)>& holds) {
        window_.until(std::string("moves the eye: ") + what,
                      [&](const Json& shown) { return holds(shown.at("camera").at(what)); });
    }
    void set_power(const std::string& power) {
        window_.fill("Power", power);
        window_.tap("Return");
        until_power(std::stod(power));
        window_.until("takes the number", [](const Json& shown) { return !shown.at("typing"); });
    }
};

TEST_F(WindowPanel, RotateCueTurnsTheCueAsFarAsItIsDragged) {
    const double before_deg = angle_deg();
    window_.drag(window_.middle_of("Rotate Cue"), {40, 0});
    EXPECT_NEAR(std::remainder(angle_deg() - before_deg, 360), -4.0, 1e-6);
}

TEST_F(WindowPanel, PowerTakesATypedNumber) {
    set_power("0.35");
    EXPECT_NEAR(power(), 0.35, 1e-9);
}

TEST_F(WindowPanel, PowerTypedBeyondTheCueIsAllOfIt) {
    window_.fill("Power", "7");
    window_.tap("Return");
    until_power(1.0);
    window_.until("takes the number", [](const Json& shown) { return !shown.at("typing"); });
}

TEST_F(WindowPanel, PowerUpAddsAHundredth) {
    set_power("0.5");
    window_.click("Power Up");
    until_power(0.51);
}

TEST_F(WindowPanel, PowerDownTakesAHundredth) {
    set_power("0.5");
    window_.click("Power Down");
    until_power(0.49);
}

TEST_F(WindowPanel, SpinPutsTheTipWhereTheCueBallIsClickedAndCenterPutsItBack) {
    const double radius = window_.seen().at("controls").at("Spin").at(2).get<double>() / 2;
    const int away = static_cast<int>(radius * 0.4);
    window_.click(window_.middle_of("Spin") + Point{away, -away / 2});
    window_.until("takes the spin", [&](const Json& shown) {
        const Json& tip = shown.at("shot").at("tip");
        return std::fabs(tip.at(0).get<double>() + away / radius) < 0.03 &&
               std::fabs(tip.at(1).get<double>() - away / 2 / radius) < 0.03;
    });
    window_.click("Center Spin");
    window_.until("centres the tip", [](const Json& shown) {
        return shown.at("shot").at("tip") == Json({0.0, 0.0});
    });
}

TEST_F(WindowPanel, ElevationRaisesTheCueUpTo85Degrees) {
    const Point middle = window_.middle_of("Elevation");
    const int half = window_.seen().at("controls").at("Elevation").at(2).get<int>() / 2;
    const auto elevation_deg = [](const Json& shown) {
        return shown.at("shot").at("elevation_deg").get<double>();
    };
    window_.click(middle);
    window_.until("raises the cue", [&](const Json& shown) {
        return elevation_deg(shown) > 38 && elevation_deg(shown) < 47;
    });
    window_.drag(middle, {half, 0});
    EXPECT_NEAR(elevation_deg(window_.seen()), 85.0, 1e-4);
    window_.drag(middle, {-half, 0});
    EXPECT_EQ(elevation_deg(window_.seen()), 0.0);
}

TEST_F(WindowPanel, ABallAndThenAPocketThatAreClickedAreTheCall) {
    window_.click(window_.ball(1));
    window_.until("marks the ball", [](const Json& shown) { return shown.at("called_ball") == 1; });
    window_.click(window_.pocket(3));
    until_call({{"ball", 1}, {"pocket", 3}});
    EXPECT_TRUE(window_.seen().at("called_ball").is_null());
}

TEST_F(WindowPanel, WhatMayNotBeSaidOfABreakCannotBeClicked) {
    window_.click("No Call");
    until_call(nullptr);
    for (const char* name : {"Safety", "Push-out"}) {
        window_.click(name);
        const double power = window_.seen().at("shot").at("power");
        window_.click("Power Down");
        window_.until("has felt both clicks", [&](const Json& shown) {
            return shown.at("shot").at("power").get<double>() < power;
        });
        EXPECT_TRUE(window_.seen().at("shot").at("call").is_null()) << name;
    }
}

TEST_F(WindowPanel, NoCallForgetsWhatWasCalled) {
    window_.click(window_.ball(1));
    window_.until("marks the ball", [](const Json& shown) { return shown.at("called_ball") == 1; });
    window_.click(window_.pocket(3));
    window_.until("calls the ball",
                  [](const Json& shown) { return shown.at("shot").at("call").is_object(); });
    window_.click("No Call");
    until_call(nullptr);
}

TEST_F(WindowPanel, RotateOrbitsTheEyeAsItIsDragged) {
    window_.click("Reset Camera");
    until_camera("elevation_deg", [](double deg) { return deg > 35 && deg < 36; });
    const double azimuth_deg = camera("azimuth_deg");
    const double elevation_deg = camera("elevation_deg");
    window_.drag(window_.middle_of("Rotate"), {20, 10});
    EXPECT_NEAR(std::remainder(camera("azimuth_deg") - azimuth_deg, 360), -7.0, 1e-6);
    EXPECT_NEAR(camera("elevation_deg") - elevation_deg, 3.5, 1e-6);
}

TEST_F(WindowPanel, ResetCameraBringsTheFirstViewBack) {
    window_.click("Reset Camera");
    until_camera("elevation_deg", [](double deg) { return deg > 35 && deg < 36; });
    const Json first = window_.seen().at("camera");
    window_.drag(window_.middle_of("Rotate"), {-30, 20});
    window_.click("Zoom In");
    until_camera("distance_m", [&](double m) { return m < first.at("distance_m"); });
    window_.click("Reset Camera");
    window_.until("shows the first view", [&](const Json& shown) {
        const Json& now = shown.at("camera");
        return now.at("azimuth_deg") == first.at("azimuth_deg") &&
               now.at("elevation_deg") == first.at("elevation_deg") &&
               now.at("distance_m") == first.at("distance_m");
    });
}

TEST_F(WindowPanel, ZoomInComesNearerAndZoomOutGoesBack) {
    window_.click("Reset Zoom");
    until_camera("distance_m", [](double m) { return m > 3.5; });
    const double before_m = camera("distance_m");
    window_.click("Zoom In");
    until_camera("distance_m", [&](double m) { return m < 0.95 * before_m; });
    window_.click("Zoom Out");
    until_camera("distance_m", [&](double m) { return std::fabs(m - before_m) < 1e-9; });
}

TEST_F(WindowPanel, ResetZoomShowsTheWholeTable) {
    window_.click("Reset Zoom");
    until_camera("distance_m", [](double m) { return m > 3.5; });
    const double whole_m = camera("distance_m");
    window_.click("Zoom In");
    until_camera("distance_m", [&](double m) { return m < whole_m; });
    window_.click("Reset Zoom");
    until_camera("distance_m", [&](double m) { return m == whole_m; });
}

TEST_F(WindowPanel, FollowBallTurnsAboutTheBallAndCenterOfTableAboutTheMiddle) {
    const auto turns_about = [](const Json& shown, const Json& place) {
        const Json& target = shown.at("camera").at("target_m");
        return target.at(0) == place.at(0) && target.at(1) == place.at(1);
    };
    const std::string followed =
        std::to_string(window_.seen().at("camera").at("followed").get<int>());
    window_.click("Follow Ball");
    window_.until("turns about the ball", [&](const Json& shown) {
        const Json& place = followed == "0"
                                ? shown.at("cue_ball")
                                : shown.at("table").at("match").at("balls").at(followed);
        return shown.at("camera").at("follows") == true && turns_about(shown, place);
    });
    window_.click("Center of Table");
    window_.until("turns about the middle", [&](const Json& shown) {
        return shown.at("camera").at("follows") == false && turns_about(shown, {0.0, 0.0});
    });
}

class FollowedBall : public WindowPanel, public testing::WithParamInterface<int> {};

TEST_P(FollowedBall, IsChosenFromTheList) {
    const std::string name = GetParam() == 0 ? "Cue Ball" : std::to_string(GetParam());
    window_.click("Follow a Ball");
    window_.click("Follow " + name);
    window_.until("follows " + name, [&](const Json& shown) {
        return shown.at("camera").at("followed") == GetParam() &&
               !shown.at("controls").contains("Follow " + name);
    });
}

INSTANTIATE_TEST_SUITE_P(WindowPanel, FollowedBall, testing::Range(0, 16));

TEST_F(WindowPanel, FoldPanelGivesTheWholeWindowToTheTableAndUnfoldsAgain) {
    const double width = window_.seen().at("window").at(0);
    const double unfolded = window_.seen().at("table_width");
    EXPECT_LT(unfolded, width);
    window_.click("Fold Panel");
    window_.until("folds the panel", [&](const Json& shown) {
        return shown.at("folded") == true && shown.at("table_width") == width &&
               !shown.at("controls").contains("Power");
    });
    window_.click("Fold Panel");
    window_.until("unfolds the panel", [&](const Json& shown) {
        return shown.at("folded") == false && shown.at("table_width") == unfolded &&
               shown.at("controls").contains("Power");
    });
}

TEST_F(WindowPanel, InformationSaysWhatFollows) {
    const Json& said = window_.seen().at("information");
    ASSERT_FALSE(said.empty());
    EXPECT_NE(said.back().get<std::string>().find("to break, cue ball in hand"), std::string::npos)
        << said;
    EXPECT_TRUE(window_.seen().at("controls").contains("Information"));
}

}  // namespace
}  // namespace billiards::client
