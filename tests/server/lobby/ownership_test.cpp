// Holds what the owner of a table may do, and that nobody else may.
#include "tests/server/support/game_test.h"

#include <algorithm>
#include <gtest/gtest.h>

namespace billiards::server {
namespace {

class OwnershipTest : public MatchTest {
  protected:
    OwnershipTest() { seat_players(); }
    std::string name_of(SessionId session) { return last<told::Welcome>(session).name; }
    std::optional<RefusedCode> kick(SessionId by, SessionId who) {
        say(by, client::Kick{name_of(who)});
        return refusal(by);
    }
    void start_playing() {
        say(ada, client::Ready{});
        say(grace, client::Ready{});
    }
};

TEST_F(OwnershipTest, NobodyElseMayDecide) {
    for (const SessionId session : {grace, linus}) {
        say(session, client::ChangeTable{});
        EXPECT_EQ(refusal(session), RefusedCode::NotOwner);
        say(session, client::MakeInvite{});
        EXPECT_EQ(refusal(session), RefusedCode::NotOwner);
        say(session, client::RevokeInvites{});
        EXPECT_EQ(refusal(session), RefusedCode::NotOwner);
        EXPECT_EQ(kick(session, ada), RefusedCode::NotOwner);
    }
    EXPECT_EQ(count<told::InviteMade>(grace), 0U);
}

TEST_F(OwnershipTest, ChangesWhatIsPlayedNextAndAsksEveryoneAgain) {
    say(grace, client::Ready{});
    match::Settings settings;
    settings.game = rules::Game::NineBall;
    say(ada, client::ChangeTable{.settings = settings, .passcode = {}});
    EXPECT_EQ(refusal(ada), std::nullopt);
    for (const SessionId session : {ada, grace, linus}) {
        const auto changed = last<told::TableChanged>(session);
        EXPECT_EQ(changed.row.settings, settings);
        EXPECT_FALSE(changed.row.seats[model::Seat::Second].ready);
    }
    start_playing();
    EXPECT_EQ(last<told::MatchStarted>(grace).state.settings.game, rules::Game::NineBall);
}

TEST_F(OwnershipTest, ChangesNothingWhileAMatchRuns) {
    start_playing();
    say(ada, client::ChangeTable{.settings = {}, .is_private = true, .passcode = "cue"});
    EXPECT_EQ(refusal(ada), RefusedCode::MatchRunning);
    const SessionId stranger = greet("Stranger");
    say(stranger, client::Join{table, Role::Spectator});
    EXPECT_EQ(refusal(stranger), std::nullopt);
    EXPECT_FALSE(last<told::TableSnapshot>(stranger).row.is_private);
    EXPECT_FALSE(last<told::TableSnapshot>(stranger).row.has_passcode);
}

TEST_F(OwnershipTest, IsRefusedSettingsAndPasscodesThatAreNone) {
    match::Settings settings;
    settings.race_to = 0;
    say(ada, client::ChangeTable{.settings = settings, .passcode = {}});
    EXPECT_EQ(match_refusal(ada), match::RefusalCode::BadSettings);
    say(ada, client::ChangeTable{.settings = {}, .passcode = "a\x07"});
    EXPECT_EQ(refusal(ada), RefusedCode::Malformed);
    EXPECT_EQ(count<told::TableChanged>(grace), 0U);
}

TEST_F(OwnershipTest, ThrowsNobodyOutByMakingATablePrivate) {
    say(ada, client::ChangeTable{.settings = {}, .is_private = true, .passcode = {}});
    EXPECT_TRUE(last<told::TableChanged>(linus).row.is_private);
    say(linus, client::Chat{"still here"});
    EXPECT_EQ(last<told::ChatSaid>(ada).text, "still here");
    say(linus, client::Leave{});
    EXPECT_TRUE(last<told::TableList>(linus).tables.empty());
    say(linus, client::Join{table, Role::Spectator});
    EXPECT_EQ(refusal(linus), RefusedCode::UnknownTable);
}

TEST_F(OwnershipTest, IsToldAnInviteAlone) {
    say(ada, client::MakeInvite{Role::Player});
    EXPECT_EQ(count<told::InviteMade>(ada), 1U);
    EXPECT_EQ(count<told::InviteMade>(grace) + count<told::InviteMade>(linus), 0U);
}

TEST_F(OwnershipTest, RevokesItsInvites) {
    say(ada, client::ChangeTable{.settings = {}, .is_private = true, .passcode = {}});
    say(ada, client::MakeInvite{Role::Spectator});
    say(ada, client::RevokeInvites{});
    const SessionId stranger = greet("Stranger");
    say(stranger,
        client::Join{
            .table = table, .role = Role::Spectator, .invite = last<told::InviteMade>(ada).secret});
    EXPECT_EQ(refusal(stranger), RefusedCode::WrongSecret);
}

TEST_F(OwnershipTest, MayMakeOnlySoManyInvites) {
    limits.lobby_requests_per_10s = 1000;
    limits.invites_per_table = 2;
    start();
    seat_players();
    for (int i = 0; i < 2; ++i) say(ada, client::MakeInvite{});
    EXPECT_EQ(refusal(ada), std::nullopt);
    say(ada, client::MakeInvite{});
    EXPECT_EQ(refusal(ada), RefusedCode::TooMany);
}

TEST_F(OwnershipTest, KicksASpectatorAtAnyTimeForGood) {
    start_playing();
    EXPECT_EQ(kick(ada, linus), std::nullopt);
    EXPECT_EQ(last<told::Notice>(linus).code, told::NoticeCode::Kicked);
    EXPECT_EQ(last<told::TableList>(linus).tables.size(), 1U);
    say(linus, client::Join{table, Role::Spectator});
    EXPECT_EQ(refusal(linus), RefusedCode::NotAllowed);
    disconnect(linus);
    EXPECT_EQ(last<told::Welcome>(come_back(token_of(linus))).table, std::nullopt);
}

TEST_F(OwnershipTest, KicksAPlayerOnlyWhileNoMatchRuns) {
    EXPECT_EQ(kick(ada, grace), std::nullopt);
    EXPECT_EQ(last<told::Notice>(grace).code, told::NoticeCode::Kicked);
    EXPECT_FALSE(last<told::SeatChanged>(ada).seats[model::Seat::Second].taken);
    const SessionId barbara = greet("Barbara");
    say(barbara, client::Join{table, Role::Player});
    grace = barbara;
    start_playing();
    EXPECT_EQ(kick(ada, barbara), RefusedCode::MatchRunning);
    say(barbara, client::Ping{});
    EXPECT_EQ(count<told::Notice>(barbara), 0U);
}

TEST_F(OwnershipTest, KicksAPlayerWhoIsAway) {
    disconnect(grace);
    EXPECT_EQ(kick(ada, grace), std::nullopt);
    EXPECT_FALSE(last<told::SeatChanged>(ada).seats[model::Seat::Second].taken);
    const SessionId again = come_back(token_of(grace));
    EXPECT_EQ(last<told::Welcome>(again).table, std::nullopt);
    say(again, client::Join{table, Role::Player});
    EXPECT_EQ(refusal(again), RefusedCode::NotAllowed);
}

TEST_F(OwnershipTest, KicksASpectatorWhoIsAway) {
    disconnect(linus);
    EXPECT_EQ(kick(ada, linus), std::nullopt);
    EXPECT_EQ(last<told::Welcome>(come_back(token_of(linus))).table, std::nullopt);
}

TEST_F(OwnershipTest, KicksWhoeverComesToATableWhereASeatOfTheirsIsStillStored) {
    say(grace, client::Leave{});
    say(grace, client::CreateTable{});
    lobby.reset();
    committer.kill();
    DurableWorld world = committer.durable();
    const std::string name = name_of(grace);
    const auto stored = std::ranges::find(world.players, name, &StoredPlayer::name);
    world.tables.front().seats[model::Seat::Second] = stored->player;
    start();
    EXPECT_TRUE(lobby->restore(now, world.stored()).empty());
    const SessionId owner = come_back(token_of(ada));
    const SessionId guest = come_back(token_of(grace));
    say(guest, client::Leave{});
    say(guest, client::Join{table, Role::Spectator});
    EXPECT_EQ(last<told::TableSnapshot>(guest).your_seats, std::vector{model::Seat::Second});
    say(owner, client::Kick{name});
    EXPECT_EQ(last<told::Notice>(guest).code, told::NoticeCode::Kicked);
    disconnect(guest);
    say(owner, client::Leave{});
    say(owner, client::CreateTable{});
    EXPECT_EQ(refusal(owner), std::nullopt);
}

TEST_F(OwnershipTest, KicksAPlayerWhoIsJustComingBack) {
    disconnect(grace);
    disk_is_slow = true;
    const SessionId again = come_back(token_of(grace));
    EXPECT_EQ(kick(ada, grace), std::nullopt);
    commit_all();
    EXPECT_EQ(last<told::Welcome>(again).table, std::nullopt);
    say(again, client::ListTables{});
    EXPECT_EQ(refusal(again), std::nullopt);
}

TEST_F(OwnershipTest, CannotKickThemselvesNorWhoIsNotHere) {
    EXPECT_EQ(kick(ada, ada), RefusedCode::NotAllowed);
    const SessionId elsewhere = greet("Elsewhere");
    EXPECT_EQ(kick(ada, elsewhere), RefusedCode::UnknownPlayer);
    say(ada, client::Kick{"Nobody#0000"});
    EXPECT_EQ(refusal(ada), RefusedCode::UnknownPlayer);
}

TEST_F(OwnershipTest, PassesToTheOtherPlayerWithLeaving) {
    say(ada, client::Leave{});
    EXPECT_EQ(last<told::TableChanged>(grace).row.owner, name_of(grace));
    EXPECT_EQ(last<told::TableChanged>(linus).row.owner, name_of(grace));
    EXPECT_EQ(kick(grace, linus), std::nullopt);
}

TEST_F(OwnershipTest, DoesNotPassWithALostConnectionNorToASpectator) {
    disconnect(ada);
    EXPECT_EQ(count<told::TableChanged>(grace), 0U);
    ada = come_back(token_of(ada));
    say(grace, client::Leave{});
    say(ada, client::Leave{});
    say(ada, client::Join{table, Role::Player});
    EXPECT_EQ(last<told::TableSnapshot>(ada).row.owner, name_of(ada));
}

TEST_F(OwnershipTest, LeavesATableToItsNewOwnerThoughTheOldOneOpensAnother) {
    say(ada, client::Leave{});
    disconnect(grace);
    say(ada, client::CreateTable{});
    EXPECT_EQ(last<told::Welcome>(come_back(token_of(grace))).table, table);
}

TEST_F(OwnershipTest, RemembersOverARestartWhoWasKicked) {
    kick(ada, linus);
    restart();
    const SessionId again = come_back(token_of(linus));
    say(again, client::Join{table, Role::Spectator});
    EXPECT_EQ(refusal(again), RefusedCode::NotAllowed);
}

}  // namespace
}  // namespace billiards::server
