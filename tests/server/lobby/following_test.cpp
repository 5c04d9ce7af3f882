// Holds that whoever follows the list of tables knows what is in it, cheaply.
#include "tests/server/support/game_test.h"

#include <gtest/gtest.h>
#include <map>

namespace billiards::server {
namespace {

class FollowingTest : public GameTest {
  protected:
    SessionId follow(const std::string& name) {
        const SessionId session = greet(name);
        say(session, client::FollowTables{});
        return session;
    }
    protocol::TableId open_table(SessionId session, client::CreateTable create = {}) {
        say(session, std::move(create));
        return last<told::TableSnapshot>(session).row.table;
    }
    /// The list as this follower has it.
    std::map<protocol::TableId, told::TableRow> known(SessionId session) {
        std::map<protocol::TableId, told::TableRow> rows;
        for (const Told& one : outbox.told(session)) {
            if (const auto* list = std::get_if<told::TableList>(&one.message)) {
                rows.clear();
                for (const auto& row : list->tables) rows[row.table] = row;
            } else if (const auto* change = std::get_if<told::TableListChange>(&one.message)) {
                for (const auto& row : change->changed) rows[row.table] = row;
                for (const auto& table : change->gone) EXPECT_EQ(rows.erase(table), 1U);
            }
        }
        return rows;
    }
    std::size_t changes(SessionId session) { return count<told::TableListChange>(session); }
};

TEST_F(FollowingTest, ATableThatIsOpenedChangesAndClosesIsTold) {
    limits.empty_table_kept = 2s;
    start();
    const SessionId fan = follow("Fan");
    EXPECT_TRUE(last<told::TableList>(fan).tables.empty());
    const SessionId ada = greet("Ada");
    const auto table = open_table(ada, {.name = "Friday", .settings = {}});
    pass(limits.table_changes_every);
    ASSERT_EQ(known(fan).count(table), 1U);
    EXPECT_EQ(known(fan)[table].name, "Friday");

    const SessionId grace = greet("Grace");
    say(grace, client::Join{.table = table});
    pass(limits.table_changes_every);
    EXPECT_TRUE(known(fan)[table].seats[model::Seat::Second].connected);

    disconnect(ada);
    disconnect(grace);
    pass(limits.empty_table_kept + limits.table_changes_every);
    EXPECT_TRUE(known(fan).empty());
}

TEST_F(FollowingTest, ManyChangesAreToldTogetherAndNotMoreOftenThanTheLimit) {
    const SessionId fan = follow("Fan");
    pass(limits.table_changes_every);
    const SessionId ada = greet("Ada");
    for (int i = 0; i < 3; ++i) {
        open_table(ada);
        say(ada, client::Leave{});
        pass(limits.table_changes_every / 8);
    }
    EXPECT_EQ(changes(fan), 1U);
    pass(limits.table_changes_every);
    EXPECT_EQ(changes(fan), 2U);
    pass(10s);
    EXPECT_EQ(changes(fan), 2U);
}

TEST_F(FollowingTest, NothingIsToldWhereNothingIsDifferentInTheEnd) {
    const SessionId ada = greet("Ada");
    const auto table = open_table(ada);
    const SessionId fan = follow("Fan");
    const SessionId grace = greet("Grace");
    say(grace, client::Join{.table = table});
    say(grace, client::Leave{});
    pass(10s);
    EXPECT_EQ(changes(fan), 0U);
}

TEST_F(FollowingTest, WhoStartsToFollowBetweenTwoChangesMissesNothing) {
    const SessionId first = follow("First");
    const SessionId ada = greet("Ada");
    const auto table = open_table(ada);
    pass(limits.table_changes_every);
    const SessionId grace = greet("Grace");
    say(grace, client::Join{.table = table});
    const SessionId second = follow("Second");
    say(grace, client::Leave{});
    pass(limits.table_changes_every);
    EXPECT_EQ(known(second), known(first));
    EXPECT_FALSE(known(second)[table].seats[model::Seat::Second].taken);
}

TEST_F(FollowingTest, AllFollowersShareOneFrame) {
    const SessionId one = follow("One");
    const SessionId two = follow("Two");
    EXPECT_EQ(outbox.frames<told::TableList>(one), outbox.frames<told::TableList>(two));
    open_table(greet("Ada"));
    pass(limits.table_changes_every);
    ASSERT_EQ(changes(one), 1U);
    EXPECT_EQ(outbox.frames<told::TableListChange>(one), outbox.frames<told::TableListChange>(two));
}

TEST_F(FollowingTest, OnlyTheTablesThatChangedAreTold) {
    for (int i = 0; i < 20; ++i) open_table(greet("Host"));
    const SessionId fan = follow("Fan");
    const auto table = open_table(greet("Ada"));
    pass(limits.table_changes_every);
    const auto change = last<told::TableListChange>(fan);
    ASSERT_EQ(change.changed.size(), 1U);
    EXPECT_EQ(change.changed[0].table, table);
    EXPECT_TRUE(change.gone.empty());
}

TEST_F(FollowingTest, ATableThatBecomesPrivateIsGone) {
    const SessionId ada = greet("Ada");
    const auto table = open_table(ada);
    const SessionId fan = follow("Fan");
    say(ada, client::ChangeTable{.settings = {}, .is_private = true, .passcode = {}});
    pass(limits.table_changes_every);
    EXPECT_TRUE(known(fan).empty());
    say(ada, client::ChangeTable{.settings = {}, .is_private = false, .passcode = {}});
    pass(limits.table_changes_every);
    EXPECT_EQ(known(fan).count(table), 1U);
}

TEST_F(FollowingTest, EndsWithTakingAPlaceAndWithTheConnection) {
    const auto table = open_table(greet("Ada"));
    const SessionId watching = follow("Watching");
    const SessionId gone = follow("Gone");
    say(watching, client::Join{table, Role::Spectator});
    disconnect(gone);
    open_table(greet("Grace"));
    pass(2 * limits.table_changes_every);
    EXPECT_EQ(changes(watching), 0U);
    EXPECT_EQ(changes(gone), 0U);
    say(watching, client::Leave{});
    open_table(greet("Linus"));
    pass(2 * limits.table_changes_every);
    EXPECT_EQ(changes(watching), 0U);
}

TEST_F(FollowingTest, TheListOfAFirstFollowerIsAsItIsNow) {
    const SessionId early = follow("Early");
    disconnect(early);
    const auto table = open_table(greet("Ada"));
    EXPECT_EQ(known(follow("Fan")).count(table), 1U);
}

TEST_F(FollowingTest, NoFrameHasMoreRowsThanItMay) {
    const SessionId fan = follow("Fan");
    for (std::size_t i = 0; i < protocol::kMaxTableRows + 5; ++i) open_table(greet("Host"));
    const std::size_t before = changes(fan);
    pass(limits.table_changes_every);
    EXPECT_EQ(changes(fan), before + 2);
    EXPECT_EQ(known(fan).size(), protocol::kMaxTableRows + 5);
    EXPECT_EQ(last<told::TableList>(follow("Late")).tables.size(), protocol::kMaxTableRows);
}

}  // namespace
}  // namespace billiards::server
