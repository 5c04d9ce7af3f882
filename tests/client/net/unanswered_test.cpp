// Holds what is asked again on a new link against everything that may answer it.
#include "client/net/unanswered.h"

#include "tests/client/app/told.h"

#include <gtest/gtest.h>
#include <string>

namespace billiards::client {
namespace {

namespace asked = protocol::client;
namespace server = protocol::server;
using model::Seat;

constexpr std::uint32_t kId = 12;
constexpr model::TurnNumber kTurn{3};
constexpr base::Vec2 kPlace_m{-0.6, 0.1};

struct Case {
    const char* name;
    protocol::ClientMessageBody request;
    protocol::ServerMessage message;
    bool is_answer;
};

match::MatchState in_turn(std::uint32_t turn) {
    return told::match_at(turn, Seat::First);
}

server::TableSnapshot shown(const match::MatchState& match) {
    return told::snapshot(4, {Seat::First}, match);
}

match::MatchState with(void (*change)(match::MatchState&)) {
    match::MatchState match = in_turn(kTurn.value);
    match.layout.balls[0].place = model::Place::InHand;
    change(match);
    return match;
}

server::SeatChanged seats(bool first_is_ready, bool second_is_ready) {
    server::SeatChanged changed;
    changed.seats[Seat::First].ready = first_is_ready;
    changed.seats[Seat::Second].ready = second_is_ready;
    return changed;
}

server::CueBallPlaced placed(base::Vec2 position_m) {
    return {.sequence = 4, .seat = Seat::First, .position_m = position_m};
}

std::vector<Case> cases() {
    const asked::TakeShot shot{.turn = kTurn, .shot_id = 77, .shot = {}, .call = {}};
    const asked::PlaceCueBall place{.turn = kTurn, .position_m = kPlace_m};
    const asked::Choose choose{.turn = kTurn, .choice = rules::Choice::Accept};
    const asked::Answer declines{.turn = kTurn, .accept = false};
    server::TableSnapshot rolling = shown(in_turn(4));
    rolling.rolling = told::shot(4, {}, 77);
    server::TableSnapshot ready = told::snapshot(4, {Seat::First}, std::nullopt);
    ready.row.seats[Seat::First].ready = true;
    const auto over = with([](auto& match) { match.stage = match::Stage::Over; });
    const auto offered = with([](auto& match) {
        match.offer = {match::OfferKind::Draw, Seat::Second};
    });
    const auto claimed = with([](auto& match) { match.claim.emplace(); });
    const auto extended = with([](auto& match) { match.extended_in[Seat::First] = kTurn; });
    const auto other_extended = with([](auto& match) { match.extended_in[Seat::Second] = kTurn; });
    const auto down = with([](auto& match) {
        match.layout.balls[0] = {.ball = model::kCueBall, .position_m = kPlace_m};
    });
    const auto elsewhere = with([](auto& match) {
        match.layout.balls[0] = {.ball = model::kCueBall, .position_m = {-0.7, 0.1}};
    });
    server::MatchMoved spotted = told::moved(4, Seat::First, in_turn(3));
    spotted.move = server::Move::Spotting;
    server::TurnOpened next;
    next.number = {4};
    return {
        {"a shot by its result", shot, told::shot(4, in_turn(4), 77), true},
        {"a shot not by another's", shot, told::shot(4, in_turn(4), 78), false},
        {"a shot by a snapshot that shows it rolling", shot, rolling, true},
        {"a shot not by a snapshot of a later turn: its result is still to come", shot,
         shown(in_turn(4)), false},
        {"a placement by itself", place, placed(kPlace_m), true},
        {"a placement not by an earlier one", place, placed({-0.7, 0.1}), false},
        {"a placement by the ball that lies there", place, shown(down), true},
        {"a placement not by a ball that lies elsewhere", place, shown(elsewhere), false},
        {"a placement not by a ball in hand", place, shown(offered), false},
        {"a placement by the next turn", place, shown(in_turn(4)), true},
        {"a choice by the next turn", choose, told::moved(4, Seat::First, in_turn(4)), true},
        {"a choice by an open next turn", choose, next, true},
        {"a choice not by its own turn", choose, shown(in_turn(3)), false},
        {"a choice by the end of the match", choose, shown(over), true},
        {"a choice by a table without a match", choose,
         told::snapshot(4, {Seat::First}, std::nullopt), true},
        {"an extension by itself", asked::Extend{kTurn}, told::moved(4, Seat::First, extended),
         true},
        {"an extension by a snapshot", asked::Extend{kTurn}, shown(extended), true},
        {"an extension not by the opponent's", asked::Extend{kTurn}, shown(other_extended), false},
        {"an answer by an offer that is gone", declines, shown(in_turn(3)), true},
        {"an answer not by an offer that stands", declines, shown(offered), false},
        {"a claim by itself", asked::ClaimStalemate{kTurn}, shown(claimed), true},
        {"a claim not by its turn", asked::ClaimStalemate{kTurn}, shown(offered), false},
        {"a spotting by itself", asked::SpotNearest{kTurn}, spotted, true},
        {"a spotting not by its turn", asked::SpotNearest{kTurn}, shown(in_turn(3)), false},
        {"giving up by the end", asked::Concede{}, told::over(4, Seat::Second), true},
        {"giving up by a match that is over", asked::Concede{}, shown(over), true},
        {"giving up not by a shot", asked::Concede{}, told::shot(4, in_turn(4)), false},
        {"a claimed match by its end", asked::ClaimMatch{}, told::over(4, Seat::First), true},
        {"a claimed match not by the next turn", asked::ClaimMatch{}, shown(in_turn(4)), false},
        {"ready by its seat", asked::Ready{}, seats(true, false), true},
        {"ready not by the other's", asked::Ready{}, seats(false, true), false},
        {"ready by a snapshot", asked::Ready{}, ready, true},
        {"ready by a match that runs", asked::Ready{}, shown(in_turn(3)), true},
        {"ready not by a table that waits", asked::Ready{},
         told::snapshot(4, {Seat::First}, std::nullopt), false},
        {"ready by a change of what is played", asked::Ready{}, server::TableChanged{}, true},
        {"ready by the start", asked::Ready{}, server::MatchStarted{}, true},
        {"a rematch by its seat", asked::Rematch{}, seats(true, true), true},
        {"a rematch not by the match that is over", asked::Rematch{}, told::over(4, Seat::First),
         false},
        {"to leave by the lobby's list", asked::Leave{}, server::TableList{}, true},
        {"to leave not by the start of a match", asked::Leave{}, server::MatchStarted{}, false},
    };
}

bool is_answered(const protocol::ClientMessageBody& request,
                 const protocol::ServerMessage& message) {
    return is_answer(message, {.request_id = kId, .body = request}, {Seat::First});
}

TEST(Unanswered, IsAnsweredByWhatShowsIt) {
    for (const Case& each : cases()) {
        EXPECT_EQ(is_answered(each.request, each.message), each.is_answer) << each.name;
    }
}

TEST(Unanswered, IsAnsweredByItsRefusalAndByALostPlaceWhateverItIs) {
    for (const Case& each : cases()) {
        const auto by = [&](const protocol::ServerMessage& message) {
            return is_answered(each.request, message);
        };
        EXPECT_TRUE(by(told::refused(protocol::RefusedCode::TooEarly, kId))) << each.name;
        EXPECT_FALSE(by(told::refused(protocol::RefusedCode::TooEarly, kId + 1))) << each.name;
        EXPECT_TRUE(by(told::notice(server::NoticeCode::TableClosed))) << each.name;
        EXPECT_TRUE(by(told::notice(server::NoticeCode::Kicked))) << each.name;
        EXPECT_TRUE(by(told::welcome())) << each.name;
        EXPECT_FALSE(by(told::welcome(protocol::TableId{7}))) << each.name;
        EXPECT_FALSE(by(server::Pong{})) << each.name;
    }
}

TEST(Unanswered, KeepsTheNewestOfEachKindInOrder) {
    Unanswered unanswered;
    const protocol::ClientMessage first{1, asked::PlaceCueBall{kTurn, kPlace_m}};
    const protocol::ClientMessage shot{
        2, asked::TakeShot{.turn = kTurn, .shot_id = 77, .shot = {}, .call = {}}};
    const protocol::ClientMessage second{3, asked::PlaceCueBall{kTurn, {0.0, 0.0}}};
    for (const auto& request : {first, shot}) EXPECT_TRUE(unanswered.sent(request));
    EXPECT_EQ(unanswered.all(), (std::vector{first, shot}));
    unanswered.sent(second);
    EXPECT_EQ(unanswered.all(), (std::vector{shot, second}));
}

TEST(Unanswered, WhoLeavesTakesBackWhatWasAskedBefore) {
    Unanswered unanswered;
    unanswered.sent({1, asked::Concede{}});
    const protocol::ClientMessage leave{2, asked::Leave{}};
    unanswered.sent(leave);
    EXPECT_EQ(unanswered.all(), std::vector{leave});
}

TEST(Unanswered, KeepsNothingThatCouldBeDoneTwice) {
    Unanswered unanswered;
    EXPECT_FALSE(unanswered.sent({1, asked::Chat{.text = "hello"}}));
    EXPECT_FALSE(unanswered.sent({2, asked::Offer{.turn = kTurn, .kind = {}}}));
    EXPECT_FALSE(unanswered.sent({3, asked::CreateTable{}}));
    EXPECT_FALSE(unanswered.sent({4, asked::Undo{}}));
    EXPECT_TRUE(unanswered.all().empty());
}

TEST(Unanswered, KeepsNothingThatAcceptsATableWhichMayHaveChanged) {
    Unanswered unanswered;
    EXPECT_FALSE(unanswered.sent({1, asked::Ready{}}));
    EXPECT_FALSE(unanswered.sent({2, asked::Rematch{}}));
    EXPECT_TRUE(unanswered.all().empty());
}

TEST(Unanswered, KnowsItsSeatsFromTheTable) {
    Unanswered unanswered;
    const server::MatchMoved extended = told::moved(
        4, Seat::First, with([](auto& match) { match.extended_in[Seat::First] = kTurn; }));
    unanswered.received(told::snapshot(1, {Seat::Second}, std::nullopt));
    unanswered.sent({1, asked::Extend{kTurn}});
    unanswered.received(extended);
    EXPECT_EQ(unanswered.all().size(), 1U);
    unanswered.received(
        server::Resumed{.table = {7}, .your_seats = {Seat::First}, .server_time_us = 0});
    unanswered.received(extended);
    EXPECT_TRUE(unanswered.all().empty());
}

}  // namespace
}  // namespace billiards::client
