// Keeps a table of one's own, between two windows; gives whether the one who comes gets in, is
// asked anew and sent away as its owner says.
#include "tests/client/window/two_windows.h"

#include <string>

namespace billiards::client {
namespace {

class WindowsOwner : public TwoWindows {
  protected:
    void open_private_table(const std::string& passcode) {
        open(ada_, "Ada");
        ada_->click("Open a new table");
        ada_->click("Private");
        if (!passcode.empty()) ada_->fill("Passcode", passcode);
        ada_->click("Open the table");
        ada_->until("sits at the private table", is_at_table);
    }
    /// Behind Escape: what its owner decides.
    void go_to_own_table() {
        ada_->tap("Escape");
        ada_->click("Your table");
    }
    std::string invite() {
        ada_->click("Invite a player");
        return ada_
            ->until("has an invite", [](const Json& shown) { return shown.at("copied") != ""; })
            .at("copied");
    }
    void say_passcode(const std::string& passcode) {
        grace_->fill("Number", std::to_string(table()));
        grace_->fill("Passcode", passcode);
        grace_->click("Sit down");
    }
    void until_told(TestWindow& window, const std::string& what) {
        window.until("says: " + what,
                     [&](const Json& shown) { return shown.at("trouble") == what; });
    }
};

TEST_F(WindowsOwner, TheRightPasscodeOpensAPrivateTableAndAWrongOneIsToldSo) {
    open_private_table("apples");
    open(grace_, "Grace");
    grace_->click("A private table");
    say_passcode("pears");
    until_told(*grace_, "This invite or passcode does not open the table, or no longer.");
    EXPECT_FALSE(is_at_table(grace_->seen()));
    say_passcode("apples");
    grace_->until("comes to the table", is_at_table);
}

TEST_F(WindowsOwner, AnInviteIsTypedWhereAnAddressIsUntilItIsRevoked) {
    open_private_table("");
    go_to_own_table();
    const std::string first = invite();
    ada_->click("Revoke all invites");
    ada_->until("has none", [](const Json& shown) { return shown.at("copied") == ""; });
    const std::string second = invite();
    open(grace_, "Grace");
    const auto join_by = [&](const std::string& invite) {
        grace_->click("Back");
        grace_->click("Join");
        grace_->fill("Server", invite);
        grace_->click("Connect");
    };
    join_by(first);
    until_told(*grace_, "This invite or passcode does not open the table, or no longer.");
    join_by(second);
    grace_->until("comes by the invite", is_at_table);
}

TEST_F(WindowsOwner, WhoIsSentAwayIsBackAmongTheTablesAndToldSo) {
    sit_down_together();
    go_to_own_table();
    ada_->click("Send the other player away");
    until_told(*grace_, "The owner of the table has sent you away.");
    EXPECT_FALSE(is_at_table(grace_->seen()));
    grace_->until_there(row_of_table());
}

TEST_F(WindowsOwner, WhoeverWasReadyIsAskedAnewOnceTheTableIsChanged) {
    sit_down_together();
    grace_->click("Start");
    grace_->until("is ready", [](const Json& shown) {
        return shown.at("information").back() == "Waiting until the other player is ready.";
    });
    go_to_own_table();
    ada_->click("9-ball");
    ada_->click("Change the table");
    grace_->until("is asked anew", [](const Json& shown) {
        return shown.at("information").back() == "Press Start when you are ready.";
    });
    ada_->click("Back");
    ada_->click("Back to the table");
    start("Start");
    EXPECT_EQ(grace_->seen().at("table").at("match").at("balls").size(), 9U);
}

TEST_F(WindowsOwner, WhoComesLateToWatchSeesTheMatchAsItIs) {
    start_match();
    TestWindow& player = breaker();
    aim_at_a_ball(player);
    player.tap("space");
    const auto has_played = [](const Json& shown) {
        return shown.at("table").at("match").at("shots") == 1 &&
               shown.at("table").at("rolling") == false;
    };
    player.until("plays the shot",
                 [](const Json& shown) { return shown.at("table").at("rolling"); });
    player.tap("z");
    player.until("has played", has_played);
    std::optional<TestWindow> mary;
    mary.emplace(std::vector<std::string>{"--server", address_, "--name", "Mary", "--table",
                                          std::to_string(table()), "--watch"});
    mary->until("comes to the table", is_playing);
    mary->tap("z");
    mary->until("sees the shot's end", has_played);
    EXPECT_EQ(mary->seen().at("table").at("match"), player.seen().at("table").at("match"));
    EXPECT_TRUE(mary->seen().at("table").at("seats").empty());
}

TEST_F(WindowsOwner, AsMuchAsMayBeSaidIsSentAndTheChatStaysAtItsPlace) {
    sit_down_together();
    ada_->click("Chat");
    const Point place = ada_->middle_of("Chat");
    ada_->fill("Say", "ohohohohohohohohohohohoh");
    ada_->tap("ctrl+a");
    ada_->tap("ctrl+c");
    for (int i = 0; i < 9; ++i) ada_->tap("ctrl+v");
    ada_->tap("Return");
    for (TestWindow* window : {&*ada_, &*grace_}) {
        window->until("reads it", [](const Json& shown) { return shown.at("chat").size() == 1; });
        EXPECT_EQ(window->seen().at("chat").at(0).at(1).get<std::string>().size(), 200U);
        window->until_there("Chat");
        EXPECT_EQ(window->middle_of("Chat"), place);
        EXPECT_EQ(window->seen().at("connected"), true);
    }
    const Json& name = grace_->seen()
                           .at("controls")
                           .at("Mute " + grace_->seen().at("chat").at(0).at(0).get<std::string>());
    EXPECT_GT(name.at(1).get<double>(), 350.0) << "it covers no more than the lower half";
}

}  // namespace
}  // namespace billiards::client
