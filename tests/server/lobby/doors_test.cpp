// Holds who gets through the door of a private table, and that nobody else learns of it.
#include "tests/server/support/game_test.h"

#include <gtest/gtest.h>

namespace billiards::server {
namespace {

class DoorsTest : public GameTest {
  protected:
    /// By Ada, who sits at it.
    void open_private(const std::string& passcode = {}) {
        ada = greet("Ada");
        say(ada, client::CreateTable{
                     .name = "Friday", .settings = {}, .is_private = true, .passcode = passcode});
        table = last<told::TableSnapshot>(ada).row.table;
    }
    std::optional<RefusedCode> join(SessionId session, Role role, client::Join shown = {}) {
        shown.table = table;
        shown.role = role;
        say(session, shown);
        return refusal(session);
    }
    protocol::InviteSecret invite(Role role) {
        say(ada, client::MakeInvite{role});
        return last<told::InviteMade>(ada).secret;
    }
    std::size_t listed(SessionId session) {
        say(session, client::ListTables{});
        return last<told::TableList>(session).tables.size();
    }

    SessionId ada;
    protocol::TableId table;
};

TEST_F(DoorsTest, WhoWatchedWhileItWasOpenComesBackToAPrivateTableOnlyWithASecret) {
    ada = greet("Ada");
    say(ada, client::CreateTable{.name = "Friday", .settings = {}, .role = Role::Player});
    table = last<told::TableSnapshot>(ada).row.table;
    const SessionId linus = greet("Linus");
    ASSERT_EQ(join(linus, Role::Spectator), std::nullopt);
    disconnect(linus);
    say(ada, client::ChangeTable{.settings = {}, .is_private = true, .passcode = {}});
    const SessionId back = come_back(token_of(linus));
    EXPECT_EQ(last<told::Welcome>(back).table, std::nullopt);
    EXPECT_EQ(count<told::TableSnapshot>(back), 0U);
    EXPECT_EQ(join(back, Role::Spectator, {.table = {}, .invite = invite(Role::Spectator)}),
              std::nullopt);
}

TEST_F(DoorsTest, WhoWatchedAPrivateTableComesBackWithoutASecret) {
    open_private();
    const SessionId linus = greet("Linus");
    ASSERT_EQ(join(linus, Role::Spectator, {.table = {}, .invite = invite(Role::Spectator)}),
              std::nullopt);
    disconnect(linus);
    EXPECT_EQ(last<told::Welcome>(come_back(token_of(linus))).table, table);
}

TEST_F(DoorsTest, APrivateTableIsInNoListAndForStrangersNotThere) {
    open_private();
    EXPECT_TRUE(last<told::TableSnapshot>(ada).row.is_private);
    EXPECT_EQ(last<told::TableSnapshot>(ada).row.owner, last<told::Welcome>(ada).name);
    const SessionId stranger = greet("Stranger");
    EXPECT_EQ(listed(stranger), 0U);
    EXPECT_EQ(join(stranger, Role::Player), RefusedCode::UnknownTable);
    EXPECT_EQ(join(stranger, Role::Spectator), RefusedCode::UnknownTable);
    EXPECT_EQ(count<told::TableSnapshot>(stranger), 0U);
}

TEST_F(DoorsTest, APasscodeMakesATablePrivateAndOpensIt) {
    ada = greet("Ada");
    say(ada, client::CreateTable{.name = "Friday", .settings = {}, .passcode = "cue"});
    table = last<told::TableSnapshot>(ada).row.table;
    EXPECT_TRUE(last<told::TableSnapshot>(ada).row.has_passcode);
    const SessionId grace = greet("Grace");
    EXPECT_EQ(listed(grace), 0U);
    EXPECT_EQ(join(grace, Role::Player), RefusedCode::WrongSecret);
    EXPECT_EQ(join(grace, Role::Player, {.table = table, .passcode = "queue"}),
              RefusedCode::WrongSecret);
    EXPECT_EQ(join(grace, Role::Player, {.table = table, .passcode = "cue"}), std::nullopt);
    EXPECT_EQ(last<told::TableSnapshot>(grace).your_seats, std::vector{model::Seat::Second});
}

TEST_F(DoorsTest, NoTableIsOpenedWithAPasscodeThatIsNoText) {
    ada = greet("Ada");
    say(ada, client::CreateTable{.name = "Friday", .settings = {}, .passcode = "a\x07"});
    EXPECT_EQ(refusal(ada), RefusedCode::Malformed);
    EXPECT_EQ(lobby->stats().tables, 0U);
}

TEST_F(DoorsTest, APlayInviteSeatsOneAndNoMore) {
    open_private();
    const base::Instant expires = now + limits.invite_kept;
    const client::Join shown{.table = table, .invite = invite(Role::Player)};
    EXPECT_TRUE(last<told::InviteMade>(ada).is_for_playing);
    EXPECT_EQ(last<told::InviteMade>(ada).table, table);
    EXPECT_EQ(last<told::InviteMade>(ada).expires_us, expires.time_since_epoch().count());
    const SessionId grace = greet("Grace");
    EXPECT_EQ(join(grace, Role::Player, shown), std::nullopt);
    EXPECT_EQ(join(greet("Linus"), Role::Player, shown), RefusedCode::WrongSecret);
}

TEST_F(DoorsTest, APlayInviteIsUsedUpByTheSameWriteThatTakesTheSeat) {
    open_private();
    const client::Join shown{.table = table, .invite = invite(Role::Player)};
    const SessionId grace = greet("Grace");
    disk_is_slow = true;
    EXPECT_EQ(join(grace, Role::Player, shown), std::nullopt);
    while (committer.waiting() > 0) {
        committer.complete();
        const StoredTable stored = *committer.table(table);
        EXPECT_EQ(stored.seats[model::Seat::Second].has_value(), stored.invites.empty());
    }
    EXPECT_TRUE(committer.table(table)->invites.empty());
}

TEST_F(DoorsTest, APlayInviteIsNotUsedUpWhereNoSeatIsFree) {
    open_private("cue");
    const client::Join shown{.table = table, .invite = invite(Role::Player)};
    const SessionId grace = greet("Grace");
    EXPECT_EQ(join(grace, Role::Player, {.table = table, .passcode = "cue"}), std::nullopt);
    const SessionId linus = greet("Linus");
    EXPECT_EQ(join(linus, Role::Player, shown), RefusedCode::SeatTaken);
    say(grace, client::Leave{});
    EXPECT_EQ(join(linus, Role::Player, shown), std::nullopt);
}

TEST_F(DoorsTest, AWatchInviteOpensTheStandToManyAndNoSeat) {
    open_private();
    const client::Join shown{.table = table, .invite = invite(Role::Spectator)};
    EXPECT_FALSE(last<told::InviteMade>(ada).is_for_playing);
    for (const char* name : {"Linus", "Barbara"}) {
        const SessionId fan = greet(name);
        EXPECT_EQ(join(fan, Role::Player, shown), RefusedCode::WrongSecret);
        EXPECT_EQ(join(fan, Role::Spectator, shown), std::nullopt);
    }
}

TEST_F(DoorsTest, WhoGuessesSecretsMustWait) {
    open_private("cue");
    const SessionId stranger = greet("Stranger");
    for (int i = 0; i < limits.wrong_secrets_per_min; ++i) {
        EXPECT_EQ(join(stranger, Role::Player, {.table = table, .passcode = "guess"}),
                  RefusedCode::WrongSecret);
    }
    EXPECT_EQ(join(stranger, Role::Player, {.table = table, .passcode = "guess"}),
              RefusedCode::TooMany);
}

TEST_F(DoorsTest, WhoComesBackByTokenNeedsNoSecret) {
    open_private();
    const SessionId grace = greet("Grace");
    const SessionId linus = greet("Linus");
    join(grace, Role::Player, {.table = table, .invite = invite(Role::Player)});
    join(linus, Role::Spectator, {.table = table, .invite = invite(Role::Spectator)});
    for (const SessionId session : {grace, linus}) disconnect(session);
    EXPECT_EQ(last<told::Welcome>(come_back(token_of(grace))).table, table);
    EXPECT_EQ(last<told::Welcome>(come_back(token_of(linus))).table, table);
}

TEST_F(DoorsTest, TheOwnerFindsBackToAPrivateTableWithoutASecret) {
    open_private();
    say(ada, client::Leave{});
    EXPECT_EQ(join(ada, Role::Player), std::nullopt);
}

TEST_F(DoorsTest, InvitesStandOverARestartAndTheUsedOnesDoNot) {
    open_private();
    const client::Join used{.table = table, .invite = invite(Role::Player)};
    const client::Join unused{.table = table, .invite = invite(Role::Player)};
    join(greet("Grace"), Role::Player, used);
    restart();
    EXPECT_EQ(join(greet("Linus"), Role::Spectator, used), RefusedCode::WrongSecret);
    EXPECT_EQ(join(greet("Linus"), Role::Spectator, unused), std::nullopt);
}

}  // namespace
}  // namespace billiards::server
