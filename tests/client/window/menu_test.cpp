// Goes every way that the menu offers; gives whether it leads where it says.
#include "tests/client/window/test_window.h"
#include "tests/tools/test_server.h"

#include <csignal>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <string>
#include <vector>

namespace billiards::client {
namespace {

Json seats(const Json& shown) {
    return shown.at("table").is_null() ? Json(nullptr) : shown.at("table").at("seats");
}

void until_seated(TestWindow& window, std::size_t seats_taken) {
    window.until("sits at a table", [&](const Json& shown) {
        return seats(shown).is_array() && seats(shown).size() == seats_taken;
    });
}

/// Through the menu, to the list of tables of the server that the window was opened with.
void go_to_tables(TestWindow& window, const std::string& way) {
    window.click("Back");
    window.click(way);
    window.click("Connect");
}

TEST(WindowMenu, TwoPlayersHereTakesBothSeats) {
    TestWindow window;
    window.click("Two players here");
    until_seated(window, 2);
    EXPECT_EQ(window.seen().at("menu"), false);
}

TEST(WindowMenu, HostATableOpensAServerAndWaitsForAnother) {
    TestWindow window;
    window.click("Host a table");
    window.fill("Port", "0");
    window.click("Open the table");
    until_seated(window, 1);
    EXPECT_EQ(window.seen().at("information").back(), "Waiting for a second player.");
}

TEST(WindowMenu, AHostIsToldThatAPortIsNoPort) {
    TestWindow window;
    window.click("Host a table");
    window.fill("Port", "65536");
    window.click("Open the table");
    window.until("says so", [](const Json& shown) {
        return shown.at("trouble") == "The port is a number from 0 to 65535.";
    });
}

TEST(WindowMenu, JoinSitsDownAtATableAndWatchLooksOn) {
    const tools::TestServer server;
    const std::vector<std::string> there{"--server", to_text(server.address())};
    TestWindow first(there);
    go_to_tables(first, "Join");
    open_table(first);
    until_seated(first, 1);
    const std::string row = fmt::format("Table {}", first.seen().at("table").at("id").get<int>());
    TestWindow watcher(there);
    go_to_tables(watcher, "Watch");
    watcher.click(row);
    until_seated(watcher, 0);
    TestWindow second(there);
    go_to_tables(second, "Join");
    second.click(row);
    until_seated(second, 1);
    EXPECT_NE(seats(first.seen()), seats(second.seen()));
}

TEST(WindowMenu, AnAddressThatIsNoneIsToldSo) {
    TestWindow window;
    window.click("Join");
    window.fill("Server", "[");
    window.click("Connect");
    window.until("says so", [](const Json& shown) {
        return shown.at("trouble").get<std::string>().find("is no address") != std::string::npos;
    });
}

TEST(WindowMenu, AServerThatIsNotThereIsToldAndTriedAgain) {
    ServerAddress address;
    {
        const tools::TestServer gone;
        address = gone.address();
    }
    TestWindow window({"--server", to_text(address)});
    window.until_there("Try again");
    const std::string said = window.seen().at("information").back();
    EXPECT_NE(said.find(to_text(address)), std::string::npos) << said;
    const support::TemporaryFolder folder;
    support::Process server({BILLIARDS_SERVER_PROGRAM, "--listen", to_text(address), "--data",
                             (folder.path() / "data").string()});
    ASSERT_TRUE(server.read_line_with("listening"));
    window.click("Try again");
    window.until("is connected", [](const Json& shown) { return shown.at("connected") == true; });
}

TEST(WindowMenu, AMatchWaitsForAWindowThatWasKilled) {
    const support::TemporaryFolder folder;
    Json before;
    {
        TestWindow window(folder.path() / "data", {});
        sit_down(window);
        before = window.seen().at("table").at("match");
        window.program().signal(SIGKILL);
        window.program().exit_code();
    }
    TestWindow again(folder.path() / "data", {});
    again.click("Resume your match");
    until_seated(again, 2);
    until_turn(again);
    EXPECT_EQ(again.seen().at("table").at("match"), before);
}

TEST(WindowMenu, ASecondWindowOfAProfileIsToldThatAnotherHasIt) {
    TestWindow first;
    first.click("Two players here");
    until_seated(first, 2);
    TestWindow second(first.data(), {});
    second.click("Two players here");
    second.until("says so", [](const Json& shown) {
        return shown.at("trouble").get<std::string>().find("--profile") != std::string::npos;
    });
}

TEST(WindowMenu, PracticeBeginsAloneWithTheBalls) {
    TestWindow window;
    window.click("Practice");
    until_turn(window);
    window.until_there("Re-rack");
    EXPECT_EQ(window.seen().at("information").back(), "Practice: play any ball anywhere.");
}

TEST(WindowMenu, ABallThatIsDraggedInPracticeGoesBackByUndo) {
    TestWindow window;
    window.click("Practice");
    until_turn(window);
    const Json before = window.seen().at("table").at("match").at("balls");
    window.drag(window.ball(1), {-40, 90});
    const auto is_back = [&](const Json& shown) {
        return shown.at("table").at("match").at("balls") == before;
    };
    window.until("has moved the ball", [&](const Json& shown) { return !is_back(shown); });
    const Json after = window.seen().at("table").at("match").at("balls");
    EXPECT_NE(after.at("1"), before.at("1"));
    EXPECT_EQ(after.at("2"), before.at("2"));
    window.tap("u");
    window.until("has taken it back", is_back);
}

TEST(WindowMenu, QuitEndsTheProgram) {
    TestWindow window;
    window.click("Quit");
    EXPECT_EQ(window.program().exit_code(), 0);
}

TEST(WindowMenu, SigtermEndsTheProgramCleanlyDuringAMatch) {
    TestWindow window;
    sit_down(window);
    window.program().signal(SIGTERM);
    EXPECT_EQ(window.program().exit_code(), 0);
}

}  // namespace
}  // namespace billiards::client
