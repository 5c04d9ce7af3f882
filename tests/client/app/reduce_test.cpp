// Holds what a client knows against sequences of messages.
#include "client/app/reduce.h"

#include "tests/client/app/told.h"

#include <gtest/gtest.h>
#include <initializer_list>
#include <string>

namespace billiards::client {
namespace {

namespace server = protocol::server;
using model::Seat;
using told::kNow;
using told::match_at;
using told::shot;
using told::snapshot;
using told::welcome;

ClientState after(std::initializer_list<protocol::ServerMessage> messages, ClientState state = {}) {
    for (const protocol::ServerMessage& message : messages) {
        state = reduce(std::move(state), message, kNow);
    }
    return state;
}

TEST(Reduce, WelcomeGivesNameAndNewestToken) {
    const ClientState state = after({welcome()});
    EXPECT_EQ(state.link, LinkState::Ready);
    EXPECT_EQ(state.name, "Ada#12ab");
    EXPECT_EQ(state.token, welcome().token);
}

TEST(Reduce, WelcomeWithoutATableTakesTheTableAway) {
    const ClientState at_table = after({welcome(), snapshot(1, {Seat::First}, std::nullopt)});
    ASSERT_TRUE(at_table.table);
    EXPECT_FALSE(after({welcome()}, at_table).table);
    EXPECT_TRUE(after({welcome(protocol::TableId{7})}, at_table).table);
}

TEST(Reduce, SnapshotReplacesTheTable) {
    const ClientState state = after({snapshot(4, {Seat::Second}, match_at(3, Seat::Second))});
    ASSERT_TRUE(state.table);
    EXPECT_EQ(state.table->row.table, protocol::TableId{7});
    EXPECT_EQ(state.table->my_seats, std::vector{Seat::Second});
    EXPECT_EQ(state.table->match->turn, model::TurnNumber{3});
    EXPECT_EQ(state.table->sequence, 4U);
}

TEST(Reduce, SnapshotOfTheSameRestKeepsTheLastShot) {
    const ClientState played =
        after({snapshot(1, {}, match_at(1, Seat::First)), shot(2, match_at(2, Seat::Second, 1))});
    EXPECT_TRUE(after({snapshot(2, {}, match_at(2, Seat::Second, 1))}, played).table->last_shot);
    EXPECT_FALSE(after({snapshot(5, {}, match_at(4, Seat::Second, 3))}, played).table->last_shot);
}

TEST(Reduce, SnapshotOfTheNextMatchTakesNothingOverFromTheOneThatEnded) {
    const ClientState ended =
        after({snapshot(1, {}, match_at(1, Seat::First)), shot(2, match_at(2, Seat::Second, 1)),
               told::over(3, Seat::First)});
    match::MatchState next = match_at(2, Seat::Second, 1);
    EXPECT_FALSE(after({snapshot(9, {}, next)}, ended).table->last_shot);
    next.stage = match::Stage::Over;
    next.winner = Seat::Second;
    EXPECT_EQ(after({snapshot(9, {}, next)}, ended).table->over->winner, Seat::Second);
}

TEST(Reduce, ShotMovesTheMatchOn) {
    const ClientState state = after({snapshot(1, {Seat::First}, match_at(1, Seat::First)),
                                     shot(2, match_at(2, Seat::Second, 1))});
    EXPECT_EQ(state.table->match->turn, model::TurnNumber{2});
    EXPECT_EQ(state.table->last_shot->sequence, 2U);
    EXPECT_EQ(state.table->turn.opens_us, 9'000'000);
    EXPECT_FALSE(my_turn(state));
}

TEST(Reduce, AnAnswerThatComesASecondTimeChangesNothing) {
    const ClientState state = after({snapshot(5, {Seat::First}, match_at(3, Seat::First, 2))});
    EXPECT_EQ(after({shot(2, match_at(2, Seat::Second, 1))}, state), state);
}

TEST(Reduce, MatchStartedBeginsWithoutAShotAndWithoutAResult) {
    ClientState state = after({snapshot(1, {Seat::First}, match_at(1, Seat::First)),
                               shot(2, match_at(2, Seat::Second, 1)), told::over(3, Seat::Second)});
    EXPECT_FALSE(state.table->row.playing);
    state =
        after({server::MatchStarted{
                  .sequence = 4, .state = match_at(1, Seat::First), .turn = told::open_since(1)}},
              state);
    EXPECT_TRUE(state.table->row.playing);
    EXPECT_FALSE(state.table->last_shot);
    EXPECT_FALSE(state.table->over);
    EXPECT_EQ(my_turn(state), Seat::First);
}

TEST(Reduce, MatchOverEndsTheMatchForBoth) {
    server::MatchOver over = told::over(2, Seat::Second);
    over.racks_won[Seat::Second] = 3;
    const ClientState state = after({snapshot(1, {Seat::First}, match_at(1, Seat::First)), over});
    EXPECT_EQ(state.table->match->stage, match::Stage::Over);
    EXPECT_EQ(state.table->match->winner, Seat::Second);
    EXPECT_EQ(state.table->row.racks_won[Seat::Second], 3);
    EXPECT_FALSE(my_turn(state));
}

TEST(Reduce, CueBallIsWhereItWasPlaced) {
    match::MatchState in_hand = match_at(1, Seat::First);
    in_hand.layout.balls[0].place = model::Place::InHand;
    const ClientState state =
        after({snapshot(1, {}, in_hand),
               server::CueBallPlaced{.sequence = 2, .position_m = {-0.7, 0.1}}});
    const model::PlacedBall* cue_ball = state.table->match->layout.find(model::kCueBall);
    EXPECT_EQ(cue_ball->place, model::Place::OnTable);
    EXPECT_EQ(cue_ball->position_m, base::Vec2(-0.7, 0.1));
}

TEST(Reduce, AimIsThatOfThePresentTurnOnly) {
    const ClientState state = after({snapshot(1, {}, match_at(2, Seat::First))});
    EXPECT_FALSE(after({told::aim(1)}, state).table->aim);
    const ClientState aiming = after({told::aim(2)}, state);
    EXPECT_TRUE(aiming.table->aim);
    EXPECT_FALSE(after({shot(2, match_at(3, Seat::Second, 1))}, aiming).table->aim);
}

TEST(Reduce, TurnOpenedCountsForItsTurnOnly) {
    const ClientState state = after({snapshot(1, {}, match_at(2, Seat::First))});
    const server::TurnOpened opened{.sequence = 2, .number = {2}, .turn = told::open_since(42)};
    EXPECT_EQ(after({opened}, state).table->turn.opens_us, 42);
    server::TurnOpened other = opened;
    other.number = {1};
    EXPECT_EQ(after({other}, state).table->turn.opens_us, 0);
}

TEST(Reduce, EventsOfATableWithoutATableAreLeftAlone) {
    const ClientState nowhere = after({welcome()});
    EXPECT_EQ(after({shot(1, match_at(2, Seat::First, 1)), told::moved(2, Seat::First, {}),
                     server::SeatChanged{3, {}, 0}, told::over(4, Seat::First)},
                    nowhere),
              nowhere);
}

TEST(Reduce, OnlyTheNewestLinesOfChatAreKept) {
    ClientState state;
    for (std::size_t line = 0; line < kChatKept + 5; ++line) {
        state = after({server::ChatSaid{.name = "Ada", .text = std::to_string(line)}}, state);
    }
    ASSERT_EQ(state.chat.size(), kChatKept);
    EXPECT_EQ(state.chat.front().text, "5");
    EXPECT_EQ(state.chat.back().text, std::to_string(kChatKept + 4));
}

TEST(Reduce, AClosedTableIsLeft) {
    const ClientState state = after(
        {snapshot(1, {Seat::First}, std::nullopt), told::notice(server::NoticeCode::TableClosed)});
    EXPECT_FALSE(state.table);
    EXPECT_EQ(state.last_notice->code, server::NoticeCode::TableClosed);
}

// The server's clock is 50 s ahead of the local one in what follows.
constexpr base::Duration kOffset = std::chrono::seconds(50);

/// A ping that took `there` and `back`, answered at a local time.
ClientState pinged(ClientState state, base::Duration there, base::Duration back) {
    const base::Instant sent = kNow - there - back;
    return reduce(
        std::move(state),
        server::Pong{.client_time_us = sent.time_since_epoch().count(),
                     .server_time_us = (sent + there + kOffset).time_since_epoch().count()},
        kNow);
}

TEST(ClockOffset, TheFastestOfTheLastPingsCounts) {
    using std::chrono::milliseconds;
    ClientState state = pinged({}, milliseconds(90), milliseconds(10));
    EXPECT_EQ(state.clock_offset, kOffset + milliseconds(40));
    state = pinged(state, milliseconds(2), milliseconds(2));
    EXPECT_EQ(state.clock_offset, kOffset);
    state = pinged(state, milliseconds(10), milliseconds(90));
    EXPECT_EQ(state.clock_offset, kOffset);
}

TEST(ClockOffset, OldPingsAreForgotten) {
    using std::chrono::milliseconds;
    ClientState state = pinged({}, milliseconds(2), milliseconds(2));
    for (std::size_t i = 0; i < kClockSamplesKept; ++i) {
        state = pinged(state, milliseconds(10), milliseconds(30));
    }
    EXPECT_EQ(state.clock_samples.size(), kClockSamplesKept);
    EXPECT_EQ(state.clock_offset, kOffset - milliseconds(10));
}

TEST(ClockOffset, AnEchoFromTheFutureIsIgnored) {
    const ClientState state =
        after({server::Pong{.client_time_us = (kNow.time_since_epoch().count()) + 1}});
    EXPECT_FALSE(state.clock_offset);
}

TEST(ClockOffset, WelcomeGivesAFirstGuessAndForgetsTheClockOfBefore) {
    const ClientState state = after({welcome()}, pinged({}, base::Duration(2), base::Duration(2)));
    EXPECT_TRUE(state.clock_samples.empty());
    EXPECT_EQ(state.clock_offset, base::Duration(5'000'000) - kNow.time_since_epoch());
    EXPECT_EQ(local_time_of(state, 5'000'000), kNow);
}

TEST(MyTurn, IsTheSeatToActAmongMine) {
    const auto turn_at = [](std::vector<Seat> mine, match::Stage stage) {
        match::MatchState match = match_at(1, Seat::Second);
        match.stage = stage;
        return my_turn(after({snapshot(1, std::move(mine), match)}));
    };
    using match::Stage;
    EXPECT_EQ(turn_at({Seat::Second}, Stage::Shooting), Seat::Second);
    EXPECT_EQ(turn_at({Seat::Second}, Stage::Choosing), Seat::Second);
    EXPECT_EQ(turn_at({Seat::First, Seat::Second}, Stage::Shooting), Seat::Second);
    EXPECT_EQ(turn_at({Seat::First}, Stage::Shooting), std::nullopt);
    EXPECT_EQ(turn_at({Seat::Second}, Stage::Over), std::nullopt);
    EXPECT_EQ(turn_at({}, Stage::Shooting), std::nullopt);
    EXPECT_EQ(my_turn(after({snapshot(1, {Seat::First}, std::nullopt)})), std::nullopt);
}

}  // namespace
}  // namespace billiards::client
