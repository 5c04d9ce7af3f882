// Holds what a match takes beside shots: extensions, offers and their answers, claims of a
// stalemate; and that none of it costs a player time.
#include "tests/server/support/game_test.h"

#include <gtest/gtest.h>

namespace billiards::server {
namespace {

using match::OfferKind;
using model::Seat;

class AgreementTest : public MatchTest {
  protected:
    AgreementTest() {
        settings.shot_clock_s = 20.0;
        settings.break_shot_clock_s = 30.0;
        settings.extension_s = 15.0;
        committer.takes = 0s;
    }
    /// The rack is broken, and the turn after it is open.
    void start_broken() {
        start_match(settings);
        take_turn(1);
        let_rest();
        while (state().stage == match::Stage::Choosing) {
            say(shooter(), client::Choose{state().turn, state().pending->verdict.choices.front()});
        }
        ASSERT_EQ(state().stage, match::Stage::Shooting);
    }
    told::Turn turn() {
        const SessionId late = greet("Late");
        say(late, client::Join{table, Role::Spectator});
        return last<told::TableSnapshot>(late).turn;
    }
    told::MatchMoved moved() { return last<told::MatchMoved>(linus); }

    match::Settings settings;
};

TEST_F(AgreementTest, AddsTheExtensionToTheDeadlineThatRuns) {
    start_match(settings);
    pass(10s);
    const auto before = last<told::MatchStarted>(linus).turn;
    say(shooter(), client::Extend{state().turn});
    EXPECT_EQ(moved().move, told::Move::Extension);
    EXPECT_EQ(moved().turn.opens_us, before.opens_us);
    EXPECT_EQ(moved().turn.deadline_us, *before.deadline_us + 15'000'000);
    EXPECT_EQ(turn(), moved().turn);
    say(shooter(), client::Extend{state().turn});
    EXPECT_EQ(match_refusal(shooter()), match::RefusalCode::NoExtension);
}

TEST_F(AgreementTest, RefusesAnExtensionToWhoIsNotToActAndWhileTheBallsRoll) {
    start_match(settings);
    say(other(), client::Extend{state().turn});
    EXPECT_EQ(match_refusal(other()), match::RefusalCode::NotYourTurn);
    take_turn(1);
    say(shooter(), client::Extend{state().turn});
    EXPECT_EQ(refusal(shooter()), RefusedCode::TooEarly);
}

TEST_F(AgreementTest, LosesNoTimeThoughTheClockRunsOutWhileTheExtensionIsStored) {
    start_match(settings);
    const auto deadline = *last<told::MatchStarted>(linus).turn.deadline_us;
    pass(29s);
    disk_is_slow = true;
    say(shooter(), client::Extend{state().turn});
    pass(5s);
    committer.takes = 5s;
    committer.complete();
    disk_is_slow = false;
    EXPECT_EQ(moved().move, told::Move::Extension);
    EXPECT_EQ(moved().turn.deadline_us, deadline + 15'000'000);
    pass(5s);
    EXPECT_EQ(moved().move, told::Move::Extension);
    pass(10s);
    EXPECT_EQ(moved().move, told::Move::Timeout);
}

TEST_F(AgreementTest, KeepsTheExtensionThroughARestart) {
    start_match(settings);
    say(shooter(), client::Extend{state().turn});
    restart();
    ada = come_back(token_of(ada));
    EXPECT_EQ(last<told::TableSnapshot>(ada).turn.deadline_us,
              (now + 45s).time_since_epoch().count());
}

TEST_F(AgreementTest, TakesAnOfferFromEitherSeatAndLeavesTheClockAlone) {
    for (const bool by_who_acts : {true, false}) {
        start_match(settings);
        const auto before = turn();
        pass(7s);
        const SessionId who = by_who_acts ? shooter() : other();
        say(who, client::Offer{state().turn, OfferKind::Draw});
        EXPECT_EQ(moved().move, told::Move::Offer);
        EXPECT_EQ(session_of(moved().seat), who);
        EXPECT_EQ(moved().turn, before);
        EXPECT_EQ(state().offer->by, moved().seat);
        say(who == ada ? grace : ada, client::Answer{state().turn, false});
        EXPECT_EQ(moved().move, told::Move::Rejection);
        EXPECT_EQ(moved().turn, before);
        EXPECT_FALSE(state().offer.has_value());
    }
}

TEST_F(AgreementTest, EndsWithoutAWinnerWhereADrawIsAccepted) {
    start_match(settings);
    say(other(), client::Offer{state().turn, OfferKind::Draw});
    say(shooter(), client::Answer{state().turn, true});
    EXPECT_EQ(moved().move, told::Move::Acceptance);
    for (const SessionId session : {ada, grace, linus}) {
        EXPECT_EQ(last<told::MatchOver>(session).winner, std::nullopt);
        EXPECT_EQ(last<told::MatchOver>(session).ending, told::Ending::Played);
    }
    EXPECT_EQ(lobby->stats().matches_running, 0U);
}

TEST_F(AgreementTest, LetsNobodyAnswerTheirOwnOffer) {
    start_match(settings);
    const SessionId who = other();
    say(who, client::Offer{state().turn, OfferKind::Draw});
    say(who, client::Answer{state().turn, true});
    EXPECT_EQ(match_refusal(who), match::RefusalCode::NoOffer);
}

TEST_F(AgreementTest, LetsOneWhoHoldsBothSeatsAgreeWithThemselves) {
    ada = grace = linus = greet("Ada");
    say(ada, client::CreateTable{.name = "Home", .settings = settings, .role = Role::BothSeats});
    say(ada, client::Ready{});
    say(ada, client::Offer{state().turn, OfferKind::Draw});
    say(ada, client::Answer{state().turn, true});
    EXPECT_EQ(count<told::MatchOver>(ada), 1U);
}

TEST_F(AgreementTest, OpensANewTurnWhereTheRackIsPlayedAgain) {
    start_broken();
    pass(5s);
    say(shooter(), client::Offer{state().turn, OfferKind::Stalemate});
    const auto offered = moved();
    say(other(), client::Answer{state().turn, true});
    EXPECT_GT(moved().after.turn, offered.after.turn);
    EXPECT_EQ(moved().turn.deadline_us, (now + 30s).time_since_epoch().count());
    EXPECT_EQ(state().rack.phase, rules::Phase::Break);
}

TEST_F(AgreementTest, TellsThatAStalemateIsClaimed) {
    start_broken();
    const auto before = turn();
    say(shooter(), client::ClaimStalemate{state().turn});
    EXPECT_EQ(moved().move, told::Move::StalemateClaim);
    EXPECT_TRUE(state().claim.has_value());
    EXPECT_EQ(moved().turn, before);
}

TEST_F(AgreementTest, RefusesAnOfferWhileTheBallsRollAndOneForAnotherTurn) {
    start_match(settings);
    take_turn(1);
    say(ada, client::Offer{state().turn, OfferKind::Draw});
    EXPECT_EQ(refusal(ada), RefusedCode::TooEarly);
    let_rest();
    say(ada, client::Offer{{state().turn.value + 1}, OfferKind::Draw});
    EXPECT_EQ(match_refusal(ada), match::RefusalCode::StaleTurn);
}

TEST_F(AgreementTest, SaysWhatEachMoveWas) {
    start_match(settings);
    place_cue_ball();
    auto soft = shot(1);
    soft.shot.power = 0.05;
    say(shooter(), soft);
    let_rest();
    say(shooter(), client::Choose{state().turn, state().pending->verdict.choices.front()});
    EXPECT_EQ(moved().move, told::Move::Choice);
    EXPECT_TRUE(moved().choice.has_value());
    pass(31s);
    EXPECT_EQ(moved().move, told::Move::Timeout);
    say(ada, client::Concede{});
    EXPECT_EQ(moved().move, told::Move::Concession);
}

}  // namespace
}  // namespace billiards::server
