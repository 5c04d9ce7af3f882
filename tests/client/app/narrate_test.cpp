// Holds the sentences for people against rulings, one case a sentence.
#include "client/app/narrate.h"

#include "tests/client/app/told.h"

#include <gtest/gtest.h>
#include <string>
#include <vector>

namespace billiards::client {
namespace {

namespace server = protocol::server;
using model::BallId;
using model::PocketId;
using model::Seat;
using model::ShotEvent;

struct Told {
    const char* sentence;
    rules::Phase phase = rules::Phase::Groups;
    model::Call call = model::NoCall{};
    std::vector<ShotEvent> events;
    rules::Verdict verdict;
};

TableView table_before(rules::Phase phase) {
    const server::TableSnapshot snapshot = told::snapshot(1, {}, told::match_at(7, Seat::First, 6));
    TableView before;
    before.row = snapshot.row;
    before.match = snapshot.match;
    before.match->rack.phase = phase;
    return before;
}

std::string narrated(const Told& told) {
    server::ShotPlayed shot = told::shot(2, told::match_at(8, told.verdict.next_player, 7));
    shot.call = told.call;
    shot.record.events = told.events;
    shot.verdict = told.verdict;
    return narrate(table_before(told.phase), shot);
}

model::Call called(std::uint8_t ball, std::uint8_t pocket) {
    return model::CalledBall{BallId{ball}, PocketId{pocket}};
}

ShotEvent fell(std::uint8_t ball, std::uint8_t pocket = 2) {
    return ShotEvent::pocketed(1.0, BallId{ball}, PocketId{pocket});
}

rules::Verdict verdict(rules::Reason reason, Seat next, bool continues = false) {
    rules::Verdict verdict;
    verdict.reason = reason;
    verdict.next_player = next;
    verdict.turn_continues = continues;
    return verdict;
}

rules::Verdict foul(rules::Foul foul, rules::Zone zone) {
    rules::Verdict verdict = client::verdict(rules::Reason::Foul, Seat::Second);
    verdict.fouls = {foul};
    verdict.in_hand = zone;
    return verdict;
}

rules::Verdict rack_won(rules::Reason reason, Seat winner) {
    rules::Verdict verdict = client::verdict(reason, winner);
    verdict.winner = winner;
    return verdict;
}

rules::Verdict choices(rules::Reason reason, std::vector<rules::Choice> offered) {
    rules::Verdict verdict = client::verdict(reason, Seat::Second);
    verdict.choices = std::move(offered);
    verdict.chooser = Seat::Second;
    return verdict;
}

rules::Verdict groups_set(rules::Group first) {
    rules::Verdict verdict = client::verdict(rules::Reason::LegalPot, Seat::First, true);
    verdict.groups.emplace();
    (*verdict.groups)[Seat::First] = first;
    return verdict;
}

class NarrateShot : public testing::TestWithParam<Told> {};

TEST_P(NarrateShot, InOneSentence) {
    EXPECT_EQ(narrated(GetParam()), std::string("rack 1, shot 7: Ada#12ab ") + GetParam().sentence);
}

using rules::Choice;
using rules::Phase;
using rules::Reason;
using rules::Zone;

INSTANTIATE_TEST_SUITE_P(
    Cases, NarrateShot,
    testing::Values(
        Told{"called 5 in pocket 2: pocketed 5; Ada continues",
             Phase::Groups,
             called(5, 2),
             {fell(5)},
             verdict(Reason::LegalPot, Seat::First, true)},
        Told{"breaks: pocketed 3, 11 and 14; Ada continues",
             Phase::Break,
             model::NoCall{},
             {fell(3), fell(11), fell(14)},
             verdict(Reason::BreakPot, Seat::First, true)},
        Told{"breaks: nothing pocketed; Grace to play",
             Phase::Break,
             model::NoCall{},
             {},
             verdict(Reason::LegalBreak, Seat::Second)},
        Told{"called a safety: nothing pocketed; Grace to play",
             Phase::Groups,
             model::Safety{},
             {},
             verdict(Reason::Safety, Seat::Second)},
        Told{"plays: pocketed 5; Ada continues",
             Phase::Groups,
             model::NoCall{},
             {fell(5)},
             verdict(Reason::LegalPot, Seat::First, true)},
        Told{"called 5 in pocket 1: pocketed 6, not as called; Grace to play",
             Phase::Groups,
             called(5, 1),
             {fell(6)},
             verdict(Reason::NotCalled, Seat::Second)},
        Told{"called 5 in pocket 1: nothing pocketed; foul: scratch; Grace to play with ball in "
             "hand",
             Phase::Groups,
             called(5, 1),
             {fell(0)},
             foul(rules::Foul::Scratch, Zone::Anywhere)},
        Told{"breaks: nothing pocketed; foul: scratch; Grace to play with ball in hand behind the "
             "head string",
             Phase::Break,
             model::NoCall{},
             {fell(0)},
             foul(rules::Foul::Scratch, Zone::BehindHeadString)},
        Told{"called 5 in pocket 1: nothing pocketed, 7 off the table; foul: ball off the table; "
             "Grace to play with ball in hand",
             Phase::Groups,
             called(5, 1),
             {ShotEvent::off_table(1.0, BallId{7})},
             foul(rules::Foul::BallOffTable, Zone::Anywhere)},
        Told{"called 5 in pocket 2: pocketed 5; Ada has solids; Ada continues",
             Phase::Open,
             called(5, 2),
             {fell(5)},
             groups_set(rules::Group::Solids)},
        Told{"breaks: nothing pocketed; Grace may play on, re-rack and break or have the opponent "
             "break again",
             Phase::Break,
             model::NoCall{},
             {},
             choices(Reason::IllegalBreak,
                     {Choice::Accept, Choice::RebreakSelf, Choice::RebreakOpponent})},
        Told{"called 8 in pocket 4: pocketed 8; Ada wins the rack",
             Phase::Groups,
             called(8, 4),
             {fell(8, 4)},
             rack_won(Reason::EightWon, Seat::First)},
        Told{"called 5 in pocket 4: pocketed 8, the 8 too early; Grace wins the rack",
             Phase::Groups,
             called(5, 4),
             {fell(8, 4)},
             rack_won(Reason::EightEarly, Seat::Second)}));

/// What a safety of the first seat leads to, with nothing pocketed.
std::string safety(const TableView& before, const rules::Verdict& ruling,
                   const match::MatchState& after) {
    server::ShotPlayed shot = told::shot(2, after);
    shot.call = model::Safety{};
    shot.verdict = ruling;
    return tell(before, shot);
}

TEST(Narrate, AStalematesLastTurnAndWhoBreaksThen) {
    match::MatchState again = told::match_at(8, Seat::First, 7);
    again.rack.phase = Phase::Break;
    EXPECT_EQ(safety(table_before(Phase::Groups), verdict(Reason::Safety, Seat::Second), again),
              "Ada#12ab called a safety: nothing pocketed; the rack is played again; Ada to break");
}

TEST(Narrate, PointsAndTheThirdFoulOfStraightPool) {
    TableView before = table_before(Phase::Groups);
    before.match->rack.scores = {{9, 30}};
    rules::Verdict third = verdict(Reason::ThreeFouls, Seat::First, true);
    third.score_change[Seat::First] = -16;
    third.rerack = rules::Rerack::Fifteen;
    match::MatchState opening = told::match_at(8, Seat::First, 7);
    opening.rack.phase = Phase::Break;
    EXPECT_EQ(safety(before, third, opening),
              "Ada#12ab called a safety: nothing pocketed, the third foul in a row; points -7 to "
              "30; Ada to break");
}

TEST(Narrate, TheDiscriminatorStaysWhereBothAreCalledTheSame) {
    server::TableSnapshot snapshot = told::snapshot(1, {}, std::nullopt);
    snapshot.row.seats[Seat::Second].name = "Ada#9999";
    TableView table;
    table.row = snapshot.row;
    EXPECT_EQ(short_name(table, Seat::First), "Ada#12ab");
    EXPECT_EQ(short_name(table_before(rules::Phase::Open), Seat::First), "Ada");
}

TEST(Narrate, TwoPlayersAtOneScreenAreToldApart) {
    TableView table = table_before(rules::Phase::Open);
    table.row.seats[Seat::Second].name = table.row.seats[Seat::First].name;
    EXPECT_EQ(short_name(table, Seat::First), "Player 1");
    EXPECT_EQ(full_name(table, Seat::Second), "Player 2");
}

TEST(Narrate, AChoiceAndWhatFollows) {
    server::MatchMoved moved = told::moved(2, Seat::Second, told::match_at(9, Seat::Second, 1));
    moved.choice = Choice::RebreakSelf;
    moved.after.rack.phase = rules::Phase::Break;
    EXPECT_EQ(narrate(table_before(rules::Phase::Break), moved),
              "rack 1, after shot 1: Grace#3f21 chose to re-rack and break; Grace to break");
}

TEST(Narrate, AClockThatRanOut) {
    server::MatchMoved moved = told::moved(2, Seat::First, told::match_at(9, Seat::Second, 4));
    moved.move = server::Move::Timeout;
    moved.verdict = verdict(Reason::ClockRanOut, Seat::Second);
    moved.after.rack.in_hand = Zone::Anywhere;
    EXPECT_EQ(narrate(table_before(rules::Phase::Open), moved),
              "rack 1, after shot 4: Ada#12ab ran out of time; Grace to play with ball in hand");
}

TEST(Narrate, AClockThatCostPoints) {
    TableView before = table_before(Phase::Groups);
    before.match->rack.scores = {{0, 12}};
    server::MatchMoved moved = told::moved(2, Seat::First, told::match_at(8, Seat::Second, 6));
    moved.move = server::Move::Timeout;
    moved.verdict = verdict(Reason::ClockRanOut, Seat::Second);
    moved.verdict->score_change[Seat::First] = -1;
    EXPECT_EQ(tell(before, moved), "Ada#12ab ran out of time; points -1 to 12; Grace to play");
}

/// What the first seat does in turn 7, which leaves the match so.
std::string moved_to(server::Move move, const match::MatchState& after) {
    server::MatchMoved moved = told::moved(2, Seat::First, after);
    moved.move = move;
    return tell(table_before(rules::Phase::Open), moved);
}

match::MatchState turn_7() {
    return told::match_at(7, Seat::First, 6);
}

match::MatchState over_for(std::optional<Seat> winner) {
    match::MatchState over = turn_7();
    over.stage = match::Stage::Over;
    over.winner = winner;
    return over;
}

using server::Move;

TEST(Narrate, WhatStandsBetweenTwoTurns) {
    match::MatchState offers = turn_7();
    offers.offer = {match::OfferKind::Draw, Seat::First};
    EXPECT_EQ(moved_to(Move::Offer, offers), "Ada#12ab offers a draw; Grace may agree or decline");
    offers.offer->kind = match::OfferKind::Stalemate;
    EXPECT_EQ(moved_to(Move::Offer, offers),
              "Ada#12ab offers to play the rack again; Grace may agree or decline");
    EXPECT_EQ(moved_to(Move::StalemateClaim, turn_7()), "Ada#12ab claims a stalemate; Ada to play");
    EXPECT_EQ(moved_to(Move::Extension, turn_7()), "Ada#12ab takes an extension; Ada to play");
    match::MatchState choosing = turn_7();
    choosing.stage = match::Stage::Choosing;
    EXPECT_EQ(moved_to(Move::Extension, choosing), "Ada#12ab takes an extension; Ada to choose");
}

TEST(Narrate, BallsThatAreSetWithoutAShot) {
    EXPECT_EQ(moved_to(Move::Spotting, turn_7()),
              "Ada#12ab has the nearest ball spotted; Ada to play");
    EXPECT_EQ(moved_to(Move::Placing, turn_7()), "Ada#12ab places a ball; Ada to play");
    EXPECT_EQ(moved_to(Move::Undoing, turn_7()),
              "Ada#12ab takes the last change back; Ada to play");
    EXPECT_EQ(moved_to(Move::Repeating, turn_7()),
              "Ada#12ab sets the balls up as before the last shot; Ada to play");
    match::MatchState racked = turn_7();
    racked.rack.phase = rules::Phase::Break;
    EXPECT_EQ(moved_to(Move::Reracking, racked), "Ada#12ab racks the balls again; Ada to break");
}

TEST(Narrate, AnAnswerToAnOffer) {
    TableView before = table_before(rules::Phase::Open);
    before.match->offer = {match::OfferKind::Stalemate, Seat::Second};
    server::MatchMoved moved = told::moved(2, Seat::First, turn_7());
    moved.move = Move::Rejection;
    EXPECT_EQ(tell(before, moved), "Ada#12ab declines to play the rack again; Ada to play");
    before.match->offer->kind = match::OfferKind::Draw;
    EXPECT_EQ(tell(before, moved), "Ada#12ab declines the draw; Ada to play");
    moved.move = Move::Acceptance;
    moved.after.rack.phase = rules::Phase::Break;
    EXPECT_EQ(tell(before, moved), "Ada#12ab agrees to play the rack again; Ada to break");
    moved.after = over_for(std::nullopt);
    EXPECT_EQ(tell(before, moved), "Ada#12ab agrees to the draw");
}

TEST(Narrate, WhoeverGivesUpOrStaysAway) {
    EXPECT_EQ(moved_to(Move::Concession, over_for(Seat::Second)), "Ada#12ab concedes");
    EXPECT_EQ(moved_to(Move::Forfeit, over_for(Seat::Second)),
              "Ada#12ab stayed away for too long; Grace claims the match");
    match::MatchState practice = over_for(std::nullopt);
    practice.settings.game = rules::Game::Practice;
    EXPECT_EQ(moved_to(Move::Concession, practice), "Ada#12ab ends the practice");
}

TEST(Narrate, AMatchThatNobodyHasWon) {
    server::MatchOver over = told::over(3, Seat::Second);
    over.winner.reset();
    over.racks_won = {{2, 1}};
    TableView before = table_before(rules::Phase::Groups);
    EXPECT_EQ(narrate(before, over), "the match is drawn 2-1");
    before.row.settings.game = rules::Game::Practice;
    EXPECT_EQ(narrate(before, over), "practice is over");
}

TEST(Narrate, TheEndOfAMatch) {
    server::MatchOver over = told::over(3, Seat::Second);
    over.racks_won[Seat::Second] = 3;
    over.racks_won[Seat::First] = 1;
    EXPECT_EQ(narrate(table_before(rules::Phase::Groups), over), "Grace#3f21 wins the match 3-1");
    over.ending = protocol::server::Ending::Conceded;
    EXPECT_EQ(narrate(table_before(rules::Phase::Groups), over),
              "Grace#3f21 wins the match 3-1: Ada conceded");
    over.ending = protocol::server::Ending::Claimed;
    EXPECT_EQ(narrate(table_before(rules::Phase::Groups), over),
              "Grace#3f21 wins the match 3-1: Ada stayed away");
    over.ending = protocol::server::Ending::Abandoned;
    over.winner.reset();
    EXPECT_EQ(narrate(table_before(rules::Phase::Groups), over),
              "the match is abandoned at 1-3: nobody came back to it");
}

}  // namespace
}  // namespace billiards::client
