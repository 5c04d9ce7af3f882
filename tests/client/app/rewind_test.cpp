// Holds a match that is stepped through against one that was watched from its beginning.
#include "client/app/rewind.h"

#include "client/app/reduce.h"
#include "common/protocol/codec.h"
#include "common/protocol/framing.h"
#include "tests/client/app/told.h"

#include <gtest/gtest.h>
#include <string>

namespace billiards::client {
namespace {

namespace server = protocol::server;
using model::Seat;

server::MatchStarted started() {
    return {.sequence = 0, .state = told::match_at(1, Seat::First), .turn = {}};
}

/// Started, placed, shot, extended, shot, placed.
std::vector<protocol::ServerMessage> story() {
    match::MatchState in_hand = told::match_at(3, Seat::First, 2);
    in_hand.layout.balls[0].place = model::Place::InHand;
    in_hand.racks_won = {{1, 0}};
    return {started(),
            server::CueBallPlaced{.sequence = 1, .seat = Seat::First, .position_m = {-0.7, 0.1}},
            told::shot(2, told::match_at(2, Seat::Second, 1), 5),
            told::moved(3, Seat::Second, told::match_at(2, Seat::Second, 1)),
            told::shot(4, in_hand, 6),
            server::CueBallPlaced{.sequence = 5, .seat = Seat::First, .position_m = {-0.6, 0.2}}};
}

std::vector<std::byte> encoded(const protocol::ServerMessage& message) {
    const protocol::SharedFrame frame = protocol::encode(message);
    return {frame->begin() + protocol::kFrameHeaderBytes, frame->end()};
}

server::ReplayChunk chunk(std::uint64_t first, std::uint64_t count,
                          const std::vector<protocol::ServerMessage>& all = story()) {
    server::ReplayChunk chunk{.match = 3, .first = first, .total = all.size(), .messages = {}};
    for (std::uint64_t step = first; step < first + count; ++step) {
        chunk.messages.push_back(encoded(all[step]));
    }
    return chunk;
}

ClientState live() {
    return reduce({}, told::snapshot(40, {Seat::First}, told::match_at(9, Seat::Second, 8)),
                  told::kNow);
}

Rewind rewound() {
    Rewind rewind(live(), 0);
    EXPECT_TRUE(rewind.take(chunk(0, 6)).ok());
    return rewind;
}

TEST(Rewind, AsksUntilItHasEverything) {
    Rewind rewind(live(), 0);
    EXPECT_EQ(rewind.question(), (protocol::client::AskReplay{.match = 0, .first = 0}));
    EXPECT_TRUE(rewind.take(chunk(0, 4)).ok());
    EXPECT_EQ(rewind.question(), (protocol::client::AskReplay{.match = 0, .first = 4}));
    EXPECT_TRUE(rewind.take(chunk(4, 2)).ok());
    EXPECT_FALSE(rewind.question());
    rewind.look_for_more();
    EXPECT_EQ(rewind.question(), (protocol::client::AskReplay{.match = 0, .first = 6}));
    EXPECT_TRUE(rewind.take(chunk(6, 0)).ok());
    EXPECT_FALSE(rewind.question());
    EXPECT_EQ(rewind.steps(), 6U);
}

TEST(Rewind, ShowsEachStepAsItWasForWhoeverWatchedFromTheBeginning) {
    const Rewind rewind = rewound();
    ClientState watched = rewind.at(0);
    EXPECT_EQ(watched.table->match, started().state);
    EXPECT_EQ(watched.table->row.racks_won, (model::PerSeat<int>{}));
    for (std::size_t step = 1; step < rewind.steps(); ++step) {
        watched = reduce(std::move(watched), story()[step], base::Instant());
        EXPECT_EQ(rewind.at(step), watched) << step;
    }
    EXPECT_EQ(watched.table->row.racks_won[Seat::First], 1);
    EXPECT_EQ(watched.table->row.name, live().table->row.name);
}

TEST(Rewind, StepsFromShotToShot) {
    const Rewind rewind = rewound();
    EXPECT_EQ(rewind.next_shot(0), 2U);
    EXPECT_EQ(rewind.next_shot(2), 4U);
    EXPECT_EQ(rewind.next_shot(4), 5U);
    EXPECT_EQ(rewind.previous_shot(5), 4U);
    EXPECT_EQ(rewind.previous_shot(4), 2U);
    EXPECT_EQ(rewind.previous_shot(2), 0U);
    EXPECT_EQ(rewind.message(2), story()[2]);
}

TEST(Rewind, RefusesWhatIsNotTheStepsThatItAskedFor) {
    server::ReplayChunk other_match = chunk(4, 1);
    other_match.match = 4;
    server::ReplayChunk no_message = chunk(4, 1);
    no_message.messages[0].resize(8);
    server::ReplayChunk no_step = chunk(4, 1);
    no_step.messages[0] = encoded(server::Pong{});
    server::ReplayChunk other_step = chunk(4, 1);
    other_step.messages[0] = encoded(story()[5]);
    server::ReplayChunk starts_again = chunk(4, 1);
    starts_again.messages[0] =
        encoded(server::MatchStarted{.sequence = 4, .state = {}, .turn = {}});
    for (const server::ReplayChunk& wrong : {other_match, no_message, no_step, other_step,
                                             starts_again, chunk(3, 1), chunk(5, 1), chunk(4, 0)}) {
        Rewind rewind(live(), 0);
        EXPECT_TRUE(rewind.take(chunk(0, 4)).ok());
        EXPECT_FALSE(rewind.take(wrong).ok());
        EXPECT_EQ(rewind.steps(), 4U);
        EXPECT_FALSE(rewind.question()) << "it would be told the same";
    }
}

TEST(Rewind, BeginsWithTheStart) {
    Rewind rewind(live(), 0);
    server::ReplayChunk wrong = chunk(0, 1);
    wrong.messages[0] = encoded(told::shot(0, told::match_at(2, Seat::Second, 1)));
    EXPECT_FALSE(rewind.take(wrong).ok());
}

TEST(Rewind, KeepsOnlySoManySteps) {
    Rewind rewind(live(), 0);
    std::vector<std::byte> start = encoded(started());
    server::ReplayChunk endless{.match = 3, .first = 0, .total = ~0ULL, .messages = {start}};
    ASSERT_TRUE(rewind.take(endless).ok());
    bool goes_on = true;
    while (goes_on && rewind.steps() <= kMaxRewoundSteps) {
        endless.first = rewind.steps();
        endless.messages = {encoded(server::CueBallPlaced{
            .sequence = rewind.steps(), .seat = Seat::First, .position_m = {}})};
        goes_on = rewind.take(endless).ok();
    }
    EXPECT_EQ(rewind.steps(), kMaxRewoundSteps);
}

TEST(Rewind, KeepsOnlySoManyBytes) {
    Rewind rewind(live(), 0);
    ASSERT_TRUE(rewind.take(chunk(0, 1)).ok());
    server::ReplayChunk chunk{.match = 3, .first = 1, .total = 2, .messages = {}};
    chunk.messages.emplace_back(kMaxRewoundBytes);
    const auto refused = rewind.take(chunk);
    ASSERT_FALSE(refused.ok());
    EXPECT_NE(refused.error().find("too long"), std::string::npos);
}

}  // namespace
}  // namespace billiards::client
