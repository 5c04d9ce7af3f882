// Takes conditions and hands; waits for the window's reports.
#include "tests/client/window/test_window.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <stdexcept>

namespace billiards::client {

namespace {

using Clock = std::chrono::steady_clock;

std::vector<std::string> command(const std::string& display, const std::filesystem::path& folder,
                                 const std::filesystem::path& data,
                                 const std::vector<std::string>& options) {
    // Graphics drivers keep what they have until the end, and call it no leak.
    std::vector<std::string> words{"/usr/bin/env",
                                   "-u",
                                   "WAYLAND_DISPLAY",
                                   "DISPLAY=" + display,
                                   "SDL_VIDEODRIVER=x11",
                                   "LIBGL_ALWAYS_SOFTWARE=1",
                                   "ASAN_OPTIONS=detect_leaks=0",
                                   BILLIARDS_PROGRAM,
                                   "--size",
                                   "1120x700",
                                   "--data",
                                   data.string(),
                                   "--report",
                                   (folder / "report").string()};
    words.insert(words.end(), options.begin(), options.end());
    return words;
}

Point point_of(const Json& place) {
    return {place.at(0).get<int>(), place.at(1).get<int>()};
}

void append(std::vector<std::string>& words, const std::vector<std::string>& more) {
    words.insert(words.end(), more.begin(), more.end());
}

/// What follows "--" may begin with a minus.
std::vector<std::string> pushed(Point way) {
    return {"mousemove_relative", "--", std::to_string(way.x), std::to_string(way.y)};
}

/// X counts left, middle, right from 1; the report left, right, middle from 0.
bool is_held(const Json& shown, int button) {
    const int reported = button == 1 ? 0 : button == 3 ? 1 : 2;
    return std::ranges::count(shown.at("mouse").at("held"), Json(reported)) > 0;
}

}  // namespace

TestWindow::TestWindow(const std::vector<std::string>& options) : TestWindow({}, options) {}

TestWindow::TestWindow(const std::filesystem::path& data, const std::vector<std::string>& options)
    : data_(data.empty() ? folder_.path() / "data" : data),
      report_(folder_.path() / "report"),
      program_(command(display_.name(), folder_.path(), data_, options)) {
    until("shows anything", [](const Json&) { return true; });
    window_ = hand({"search", "--sync", "--onlyvisible", "--name", "gl-billiards"}).back();
}

std::vector<std::string> TestWindow::hand(std::vector<std::string> words) const {
    return display_.hand(words);
}

bool TestWindow::read(Clock::time_point deadline) {
    const auto line = report_.next_line(deadline);
    if (line) seen_ = Json::parse(*line);
    return line.has_value();
}

const Json& TestWindow::until(const std::string& what, const Condition& holds) {
    const auto deadline = Clock::now() + kPatience;
    while (seen_.is_null() || !holds(seen_)) {
        if (!read(deadline)) {
            throw std::runtime_error("The window never " + what + ": " + seen_.dump());
        }
    }
    return seen_;
}

void TestWindow::until_there(const std::string& control) {
    until("has " + control,
          [&](const Json& shown) { return shown.at("controls").contains(control); });
}

/// SDL overlooks that the pointer was put somewhere, and feels the last unit that it is pushed.
std::vector<std::string> TestWindow::way_to(Point to) const {
    return {"mousemove",          "--window",           window_, std::to_string(to.x - 1),
            std::to_string(to.y), "mousemove_relative", "1",     "0"};
}

void TestWindow::move(Point to) {
    hand(way_to(to));
    until("feels the mouse there",
          [&](const Json& shown) { return point_of(shown.at("mouse").at("at")) == to; });
}

void TestWindow::press(int button) {
    hand({"mousedown", std::to_string(button)});
    until("feels the press", [&](const Json& shown) { return is_held(shown, button); });
}

void TestWindow::let_go(int button) {
    hand({"mouseup", std::to_string(button)});
    until("feels it let go", [&](const Json& shown) { return !is_held(shown, button); });
}

void TestWindow::drag(Point from, Point way, int button) {
    move(from);
    press(button);
    move(from + way);
    let_go(button);
}

void TestWindow::click(Point at, int button) {
    move(at);
    hand({"click", std::to_string(button)});
}

void TestWindow::click(const std::string& control) {
    // What has just been opened or folded may still be finding its place; each move sees a frame.
    do {
        until_there(control);
        move(middle_of(control) + Point{1, 0});
        until_there(control);
        move(middle_of(control));
    } while (!seen_.at("controls").contains(control) || mouse() != middle_of(control));
    hand({"click", "1"});
}

void TestWindow::click_rushing(Point at, Point way) {
    std::vector<std::string> words = way_to(at);
    append(words, {"mousedown", "1", "mouseup", "1"});
    append(words, pushed(way));
    hand(words);
}

void TestWindow::pull_rushing(Point from, Point way) {
    std::vector<std::string> words = way_to(from);
    append(words, {"mousedown", "1"});
    append(words, pushed(way));
    append(words, {"mouseup", "1"});
    append(words, pushed(way));
    hand(words);
}

void TestWindow::tap(const std::string& keys) {
    hand({"key", keys});
}

void TestWindow::hold(const std::string& key) {
    hand({"keydown", key});
}

void TestWindow::roll_over(const std::string& first, const std::string& second) {
    hand({"keydown", first, "keydown", second, "keyup", first, "keyup", second});
}

void TestWindow::release(const std::string& key) {
    hand({"keyup", key});
}

void TestWindow::fill(const std::string& control, const std::string& text) {
    click(control);
    until("lets one type", [](const Json& shown) { return shown.at("typing").get<bool>(); });
    tap("ctrl+a");
    hand({"type", text});
}

void TestWindow::wheel(int notches) {
    for (int i = 0; i < std::abs(notches); ++i) hand({"click", notches > 0 ? "4" : "5"});
}

Point TestWindow::mouse() const {
    return point_of(seen_.at("mouse").at("at"));
}

Point TestWindow::middle_of(const std::string& control) const {
    const Json& place = seen_.at("controls").at(control);
    return {static_cast<int>(place.at(0).get<double>() + place.at(2).get<double>() / 2),
            static_cast<int>(place.at(1).get<double>() + place.at(3).get<double>() / 2)};
}

Point TestWindow::ball(int number) const {
    return point_of(seen_.at("table").at("on_screen").at("balls").at(std::to_string(number)));
}

Point TestWindow::pocket(int number) const {
    return point_of(
        seen_.at("table").at("on_screen").at("pockets").at(static_cast<std::size_t>(number)));
}

std::string offered(const Json& shown) {
    for (const auto& [name, place] : shown.at("controls").items()) {
        if (name == "Start" || name.starts_with("Choose ")) return name;
    }
    return "";
}

bool may_shoot(const Json& shown) {
    return shown.at("acting").is_number() && shown.at("cue_ball").is_array() &&
           offered(shown).empty();
}

void sit_down(TestWindow& window) {
    window.click("Two players here");
    until_turn(window);
}

void open_table(TestWindow& window) {
    window.click("Open a new table");
    window.click("Open the table");
    window.until("sits at a new table",
                 [](const Json& shown) { return !shown.at("table").is_null(); });
}

void until_turn(TestWindow& window) {
    const auto& shown = window.seen();
    const auto is_asked = [](const Json& now) { return may_shoot(now) || !offered(now).empty(); };
    while (window.until("waits for a player", is_asked), !may_shoot(shown)) {
        const std::string button = offered(shown);
        window.click(button);
        window.until("takes " + button, [&](const Json& now) {
            return !now.at("controls").contains(button) || may_shoot(now);
        });
    }
}

void aim_at_a_ball(TestWindow& window) {
    for (const auto& [name, place] : window.seen().at("table").at("match").at("balls").items()) {
        if (name != "0") return window.move(window.ball(std::stoi(name)));
    }
}

}  // namespace billiards::client
