// Plays in two windows at one server while a third watches; gives whether all three show the same.
#include "tests/client/window/test_window.h"
#include "tests/tools/test_server.h"

#include <array>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <string>

namespace billiards::client {
namespace {

/// Ada opens a table at a real server, Grace sits down there, Mary watches.
class WindowsTogether : public testing::Test {
  protected:
    WindowsTogether() {
        for (TestWindow* guest : {&grace_, &mary_}) {
            guest->click(fmt::format("Table {}", table_));
            guest->until("comes to the table", is_at_table);
        }
        ada_.click("Start");
        grace_.click("Start");
        for (TestWindow* window : all_) {
            window->until("sees the match begin", [](const Json& shown) {
                return !shown.at("table").at("match").is_null();
            });
        }
    }

    static int opened_by(TestWindow& window) {
        open_table(window);
        return window.seen().at("table").at("id").get<int>();
    }
    static bool is_at_table(const Json& shown) { return !shown.at("table").is_null(); }
    static const Json& match(const TestWindow& window) {
        return window.seen().at("table").at("match");
    }

    /// The player whose turn it is, ready to shoot; whoever has to choose first has chosen.
    TestWindow& shooter() {
        while (true) {
            const Json turn = match(ada_).at("turn");
            const bool is_ada =
                ada_.seen().at("table").at("seats").at(0) == match(ada_).at("to_act");
            TestWindow& player = is_ada ? ada_ : grace_;
            player.until("may act", [](const Json& shown) {
                return may_shoot(shown) || offered(shown).starts_with("Choose ");
            });
            if (may_shoot(player.seen())) return player;
            player.click(offered(player.seen()));
            ada_.until("shows the choice", [&](const Json& shown) {
                return shown.at("table").at("match").at("turn") != turn;
            });
        }
    }

    /// Until every window shows where the balls of this shot came to rest.
    void until_at_rest(int shot) {
        for (TestWindow* window : all_) {
            window->tap("z");
            window->until(fmt::format("shows the end of shot {}", shot), [&](const Json& shown) {
                const Json& table = shown.at("table");
                return table.at("match").at("shots") == shot && table.at("rolling") == false;
            });
        }
    }

    tools::TestServer server_;
    std::string address_ = to_text(server_.address());
    TestWindow ada_{{"--server", address_, "--name", "Ada"}};
    const int table_ = opened_by(ada_);
    TestWindow grace_{{"--server", address_, "--name", "Grace"}};
    TestWindow mary_{{"--server", address_, "--name", "Mary", "--watch"}};
    std::array<TestWindow*, 3> all_{&ada_, &grace_, &mary_};
};

TEST_F(WindowsTogether, ABreakAndFourShotsAreTheSameForBothPlayersAndAWatcher) {
    constexpr std::array kPulls{270, 80, 60, 90, 70};  // Window units: a break, and softer ones.
    int shot = 0;
    for (const int pull : kPulls) {
        TestWindow& player = shooter();
        aim_at_a_ball(player);
        player.press();
        player.move(player.mouse() + Point{0, pull});
        player.let_go();
        until_at_rest(++shot);
        EXPECT_TRUE(ada_.seen().at("table").at("last_hash").is_string());
        for (const TestWindow* other : {&grace_, &mary_}) {
            const Json& table = other->seen().at("table");
            EXPECT_EQ(table.at("last_hash"), ada_.seen().at("table").at("last_hash")) << shot;
            EXPECT_EQ(match(*other), match(ada_)) << shot;
        }
    }
    EXPECT_TRUE(mary_.seen().at("table").at("seats").empty());
}

}  // namespace
}  // namespace billiards::client
