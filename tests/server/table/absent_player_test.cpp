// Holds what a player may do whose opponent stays away, and what becomes of a seat that nobody
// comes back to.
#include "common/protocol/codec_journal.h"
#include "tests/server/support/game_test.h"

#include <gtest/gtest.h>

namespace billiards::server {
namespace {

using model::Seat;

class AbsentPlayerTest : public MatchTest {
  protected:
    AbsentPlayerTest() {
        settings.shot_clock_s = settings.break_shot_clock_s = 0.0;
        committer.takes = 0s;
    }
    /// Those who are connected stay so.
    void wait(base::Duration duration, const std::vector<SessionId>& here) {
        const base::Instant end = now + duration;
        while (now < end) {
            for (const SessionId session : here) say(session, client::Ping{});
            pass(std::min<base::Duration>(30s, end - now));
        }
    }
    std::optional<std::int64_t> claimable(Seat seat) {
        return last<told::SeatChanged>(linus).seats[seat].claimable_us;
    }
    static std::int64_t wire(base::Instant instant) { return instant.time_since_epoch().count(); }

    match::Settings settings;
};

TEST_F(AbsentPlayerTest, TellsFromWhenOnTheMatchMayBeClaimed) {
    start_match(settings);
    disconnect(grace);
    EXPECT_EQ(claimable(Seat::Second), wire(now + limits.absence_grace));
    EXPECT_EQ(claimable(Seat::First), std::nullopt);
    const SessionId late = greet("Late");
    say(late, client::Join{table, Role::Spectator});
    EXPECT_EQ(last<told::TableSnapshot>(late).row.seats, last<told::SeatChanged>(ada).seats);
}

TEST_F(AbsentPlayerTest, RefusesAClaimBeforeTheGraceIsUsedUp) {
    start_match(settings);
    say(ada, client::ClaimMatch{});
    EXPECT_EQ(refusal(ada), RefusedCode::NotAllowed);
    EXPECT_EQ(last<told::Refused>(ada).detail, "the opponent is here");
    disconnect(grace);
    wait(limits.absence_grace - 1us, {ada, linus});
    say(ada, client::ClaimMatch{});
    EXPECT_EQ(refusal(ada), RefusedCode::NotAllowed);
    EXPECT_EQ(last<told::Refused>(ada).detail, "the opponent may still come back for 1 s");
    EXPECT_EQ(count<told::MatchOver>(ada), 0U);
}

TEST_F(AbsentPlayerTest, EndsTheMatchForWhoClaimsItThroughTheJournal) {
    start_match(settings);
    disconnect(grace);
    wait(limits.absence_grace, {ada, linus});
    disk_is_slow = true;
    say(ada, client::ClaimMatch{});
    ASSERT_EQ(committer.waiting(), 1U);
    const std::vector<Write> writes = committer.next();
    ASSERT_EQ(writes.size(), 2U);
    const auto entry = protocol::decode_entry(std::get<AppendEntry>(writes[0]).entry.entry);
    EXPECT_TRUE(std::holds_alternative<match::Forfeit>(entry->command));
    EXPECT_EQ(entry->seat, Seat::Second);
    EXPECT_EQ(std::get<FinishMatch>(writes[1]).result.ending, told::Ending::Claimed);
    EXPECT_EQ(count<told::MatchOver>(ada), 0U);
    commit_all();
    for (const SessionId session : {ada, linus}) {
        EXPECT_EQ(last<told::MatchMoved>(session).move, told::Move::Forfeit);
        EXPECT_EQ(last<told::MatchMoved>(session).seat, Seat::Second);
        EXPECT_EQ(last<told::MatchOver>(session).winner, Seat::First);
        EXPECT_EQ(last<told::MatchOver>(session).ending, told::Ending::Claimed);
    }
}

TEST_F(AbsentPlayerTest, MayBeClaimedWhileTheBallsRoll) {
    start_match(settings);
    const Seat seat = state().to_act;
    const SessionId who = shooter();
    disconnect(other());
    wait(limits.absence_grace, {who, linus});
    take_turn(1);
    say(who, client::ClaimMatch{});
    EXPECT_EQ(last<told::MatchOver>(linus).winner, seat);
}

TEST_F(AbsentPlayerTest, GoesOnWhereTheOpponentPrefersToWait) {
    start_match(settings);
    const auto token = token_of(grace);
    disconnect(grace);
    wait(3 * limits.absence_grace, {ada, linus});
    EXPECT_EQ(count<told::MatchOver>(ada), 0U);
    grace = come_back(token);
    EXPECT_EQ(claimable(Seat::Second), std::nullopt);
    say(ada, client::ClaimMatch{});
    EXPECT_EQ(refusal(ada), RefusedCode::NotAllowed);
    take_turn(1);
    EXPECT_EQ(count<told::ShotPlayed>(linus), 1U);
}

TEST_F(AbsentPlayerTest, SpendsOneGraceInAllTheAbsencesOfAMatch) {
    start_match(settings);
    disconnect(grace);
    wait(40s, {ada, linus});
    grace = come_back(token_of(grace));
    wait(30s, {ada, grace, linus});
    disconnect(grace);
    EXPECT_EQ(claimable(Seat::Second), wire(now + limits.absence_grace - 40s));
}

TEST_F(AbsentPlayerTest, SpendsNothingWhileTheOpponentIsAwayToo) {
    start_match(settings);
    disconnect(grace);
    wait(40s, {ada, linus});
    disconnect(ada);
    EXPECT_EQ(claimable(Seat::Second), std::nullopt);
    EXPECT_EQ(claimable(Seat::First), std::nullopt);
    wait(5min, {linus});
    ada = come_back(token_of(ada));
    EXPECT_EQ(claimable(Seat::Second), wire(now + limits.absence_grace - 40s));
    say(ada, client::ClaimMatch{});
    EXPECT_EQ(refusal(ada), RefusedCode::NotAllowed);
}

TEST_F(AbsentPlayerTest, RunsTheShotClockOnMeanwhile) {
    settings.break_shot_clock_s = 30.0;
    start_match(settings);
    disconnect(shooter() == ada ? ada : grace);
    wait(31s, {ada, grace, linus});
    EXPECT_EQ(last<told::MatchMoved>(linus).move, told::Move::Timeout);
}

TEST_F(AbsentPlayerTest, RefusesAClaimOfBothSeatsInOneHandAndOfNoMatch) {
    ada = greet("Ada");
    say(ada, client::CreateTable{.name = "Home", .settings = settings, .role = Role::BothSeats});
    say(ada, client::ClaimMatch{});
    EXPECT_EQ(last<told::Refused>(ada).detail, "no match is being played");
    say(ada, client::Ready{});
    say(ada, client::ClaimMatch{});
    EXPECT_EQ(refusal(ada), RefusedCode::NotAllowed);
    EXPECT_EQ(last<told::Refused>(ada).detail, "both seats are yours");
}

TEST_F(AbsentPlayerTest, RefusesAClaimThatWaitedUntilTheOpponentWasBack) {
    start_match(settings);
    const auto token = token_of(grace);
    disconnect(grace);
    wait(limits.absence_grace, {ada, linus});
    disk_is_slow = true;
    grace = connect();
    say(grace, client::Hello{.name = {}, .token = token});
    say(ada, client::Offer{state().turn, match::OfferKind::Draw});
    say(ada, client::ClaimMatch{});
    EXPECT_EQ(refusal(ada), std::nullopt);
    committer.complete();  // Grace is back.
    committer.complete();  // The offer: the claim is next.
    EXPECT_EQ(refusal(ada), RefusedCode::NotAllowed);
    EXPECT_EQ(count<told::MatchOver>(linus), 0U);
}

TEST_F(AbsentPlayerTest, GivesTheGraceBackInFullAfterARestart) {
    start_match(settings);
    disconnect(grace);
    wait(40s, {ada, linus});
    restart();
    ada = come_back(token_of(ada));
    EXPECT_EQ(last<told::TableSnapshot>(ada).row.seats[Seat::Second].claimable_us,
              wire(now + limits.absence_grace));
}

TEST_F(AbsentPlayerTest, EndsWithoutAWinnerWhereBothStayAway) {
    start_match(settings);
    take_turn(1);
    disconnect(ada);
    disconnect(grace);
    disk_is_slow = true;
    wait(limits.empty_table_kept, {linus});
    ASSERT_GT(committer.waiting(), 0U);
    const std::vector<Write> writes = committer.next();
    ASSERT_EQ(writes.size(), 2U);
    const MatchResult& result = std::get<FinishMatch>(writes[0]).result;
    EXPECT_EQ(result.ending, told::Ending::Abandoned);
    EXPECT_EQ(result.winner, std::nullopt);
    EXPECT_EQ(result.shots, 1U);
    EXPECT_EQ(std::get<RemoveTable>(writes[1]).table, table);
    EXPECT_EQ(last<told::Notice>(linus).code, told::NoticeCode::TableClosed);
}

TEST_F(AbsentPlayerTest, LosesTheSeatBetweenMatchesOnceTheGraceIsUsedUp) {
    seat_players(settings);
    disconnect(grace);
    wait(limits.absence_grace - 1us, {ada, linus});
    EXPECT_TRUE(last<told::SeatChanged>(ada).seats[Seat::Second].taken);
    pass(1us);
    EXPECT_FALSE(last<told::SeatChanged>(ada).seats[Seat::Second].taken);
    EXPECT_EQ(committer.table(table)->seats[Seat::Second], std::nullopt);
    const SessionId back = come_back(token_of(grace));
    EXPECT_TRUE(last<told::TableSnapshot>(back).your_seats.empty());
}

TEST_F(AbsentPlayerTest, HasTheWholeGraceForEachAbsenceBetweenMatches) {
    seat_players(settings);
    for (int i = 0; i < 3; ++i) {
        disconnect(grace);
        wait(40s, {ada, linus});
        grace = come_back(token_of(grace));
        EXPECT_EQ(last<told::TableSnapshot>(grace).your_seats, std::vector{Seat::Second});
    }
}

TEST_F(AbsentPlayerTest, KeepsTheSeatForTheMatch) {
    start_match(settings);
    disconnect(grace);
    wait(4 * limits.absence_grace, {ada, linus});
    grace = come_back(token_of(grace));
    EXPECT_EQ(last<told::TableSnapshot>(grace).your_seats, std::vector{Seat::Second});
}

}  // namespace
}  // namespace billiards::server
