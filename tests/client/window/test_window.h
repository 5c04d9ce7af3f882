// Gives a test the program `billiards` in a real window: hands on its mouse and keys, and what it
// reports that it shows.
#pragma once

#include "tests/support/display.h"
#include "tests/support/followed_file.h"
#include "tests/support/process.h"
#include "tests/support/temporary_folder.h"

#include <chrono>
#include <filesystem>
#include <functional>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace billiards::client {

using Json = nlohmann::json;

struct Point {
    int x = 0;  ///< In window units, from the left.
    int y = 0;  ///< From the top.

    friend bool operator==(const Point&, const Point&) = default;
};

constexpr Point operator+(Point a, Point b) {
    return {a.x + b.x, a.y + b.y};
}

class TestWindow {
  public:
    using Condition = std::function<bool(const Json&)>;
    /// Far more than it takes on a loaded machine without a graphics card.
    static constexpr std::chrono::seconds kPatience{60};

    /// Opened with these options besides its own display, data and report; its menu is there.
    explicit TestWindow(const std::vector<std::string>& options = {});
    /// With the data of another one: the same profile.
    TestWindow(const std::filesystem::path& data, const std::vector<std::string>& options);

    /// The newest report that was waited for.
    const Json& seen() const { return seen_; }
    /// Reads reports, from the newest one on, until one holds. Throws std::runtime_error with
    /// `what` where none does in time.
    const Json& until(const std::string& what, const Condition& holds);
    /// Until a control of this name is on the screen.
    void until_there(const std::string& control);

    // Hands. Those that move, press and let go return once a frame has felt them; what a click or a
    // key does is for the test to wait for.

    void move(Point to);
    void press(int button = 1);
    void let_go(int button = 1);
    void drag(Point from, Point way, int button = 1);
    void click(Point at, int button = 1);
    void click(const std::string& control);
    /// A click there while the mouse rushes on, and a pull that way whose hand rushes on as far
    /// again: all of it before a frame has felt any of it, where the machine is slow.
    void click_rushing(Point at, Point way);
    void pull_rushing(Point from, Point way);
    /// Such as "Return" or "shift+Left".
    void tap(const std::string& keys);
    void hold(const std::string& key);
    void release(const std::string& key);
    /// Both down, and up in the same order, as fast as it goes.
    void roll_over(const std::string& first, const std::string& second);
    /// Types over a number; into a text, wherever its cursor is.
    void fill(const std::string& control, const std::string& text);
    /// Notches of the wheel, above zero away from the hand.
    void wheel(int notches);

    /// Where the newest report has the mouse.
    Point mouse() const;
    Point middle_of(const std::string& control) const;
    Point ball(int number) const;
    Point pocket(int number) const;

    support::Process& program() { return program_; }
    std::filesystem::path data() const { return data_; }

  private:
    std::vector<std::string> hand(std::vector<std::string> words) const;
    std::vector<std::string> way_to(Point to) const;
    bool read(std::chrono::steady_clock::time_point deadline);

    support::TemporaryFolder folder_;
    std::filesystem::path data_;
    support::Display display_;
    support::FollowedFile report_;
    support::Process program_;
    std::string window_;  ///< As X numbers it.
    Json seen_;
};

/// Two players in one window, the first about to break with the cue ball in hand.
void sit_down(TestWindow& window);
/// Until somebody may shoot here; chooses what the rules offer, and starts the next match.
void until_turn(TestWindow& window);
bool may_shoot(const Json& shown);
/// Through the list of tables of a server, to a new one there.
void open_table(TestWindow& window);
/// The first button that the rules offer instead of a shot; empty: none.
std::string offered(const Json& shown);
/// With the mouse, at the first object ball that lies.
void aim_at_a_ball(TestWindow& window);

}  // namespace billiards::client
