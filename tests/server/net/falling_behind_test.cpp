// Holds the network against receivers who take little or nothing, over real sockets on this
// machine.
#include "tests/server/net/running_network.h"

#include <gtest/gtest.h>
#include <string>

namespace billiards::server {
namespace {

using namespace std::chrono_literals;
using Kind = RecordedEvent::Kind;

constexpr std::size_t kFrameBytes = 50'000;
constexpr int kSmallReceiveBuffer = 4096;
/// More than the system's buffers hold for one receiver.
constexpr int kMostRounds = 1000;

NetLimits small_limits() {
    NetLimits limits;
    limits.sheddable_bytes = 200'000;
    return limits;
}

/// A server's message that says which one it is, and is as large as a shot.
protocol::SharedFrame numbered(std::uint64_t number) {
    protocol::server::ReplayChunk chunk;
    chunk.first = number;
    chunk.messages.emplace_back(kFrameBytes);
    return protocol::encode(protocol::ServerMessage(std::move(chunk)));
}

std::optional<std::uint64_t> receive_number(RawClient& client) {
    const auto chunk = client.receive_next<protocol::server::ReplayChunk>();
    return chunk ? std::optional(chunk->first) : std::nullopt;
}

/// Sends numbers to both, of which the good one reads each, until the slow one has lost some; gives
/// the last number.
std::uint64_t send_until_shed(Running& running, Greeted& slow, Greeted& good) {
    std::uint64_t number = 0;
    while (number < kMostRounds && running.stats().shed == 0) {
        const auto frame = numbered(++number);
        running.carry_out({{slow.session, Outgoing::Kind::Sheddable, frame},
                           {good.session, Outgoing::Kind::Sheddable, frame}});
        EXPECT_EQ(receive_number(good.client), number);
        EXPECT_LE(running.stats().queued_bytes, small_limits().sheddable_bytes);
    }
    EXPECT_GT(running.stats().shed, 0U);
    return number;
}

TEST(FallingBehind, CostsASpectatorTheFramesThatWaitAndNobodyElseAnything) {
    Running running(small_limits());
    Greeted slow(running, kSmallReceiveBuffer);
    Greeted good(running);
    std::uint64_t number = send_until_shed(running, slow, good);
    for (int i = 0; i < 20; ++i) {
        const auto frame = numbered(++number);
        running.carry_out({{slow.session, Outgoing::Kind::Sheddable, frame},
                           {good.session, Outgoing::Kind::Sheddable, frame}});
        EXPECT_EQ(receive_number(good.client), number);
    }
    EXPECT_LE(running.stats().queued_bytes, small_limits().sheddable_bytes);
    EXPECT_EQ(running.events.count(Kind::FellBehind), 0U) << "it has not read a byte";
    EXPECT_EQ(running.events.count(Kind::Disconnected), 0U);
}

/// What the client gets before this answer, in order.
std::vector<std::uint64_t> receive_numbers_before_pong(RawClient& client) {
    std::vector<std::uint64_t> numbers;
    while (const auto message = client.receive_message()) {
        if (std::holds_alternative<protocol::server::Pong>(*message)) return numbers;
        numbers.push_back(std::get<protocol::server::ReplayChunk>(*message).first);
    }
    ADD_FAILURE() << "no answer arrived";
    return numbers;
}

TEST(FallingBehind, IsToldOnceWhatIsOnItsWayIsOutAndEndsWithAFreshFrame) {
    Running running(small_limits());
    Greeted slow(running, kSmallReceiveBuffer);
    Greeted good(running);
    const std::uint64_t last = send_until_shed(running, slow, good);
    const auto answer = protocol::encode(protocol::ServerMessage(protocol::server::Pong{}));
    running.carry_out({{slow.session, Outgoing::Kind::Ordered, answer}});
    const auto numbers = receive_numbers_before_pong(slow.client);
    for (std::size_t i = 0; i < numbers.size(); ++i) EXPECT_EQ(numbers[i], i + 1);
    EXPECT_LT(numbers.size(), last);
    ASSERT_EQ(running.events.count(Kind::FellBehind), 1U);
    EXPECT_EQ(running.events.wait_for(Kind::FellBehind)->session, slow.session);
    running.carry_out({{slow.session, Outgoing::Kind::Sheddable, numbered(last + 1)},
                       {slow.session, Outgoing::Kind::Fresh, numbered(last + 2)},
                       {slow.session, Outgoing::Kind::Sheddable, numbered(last + 3)}});
    EXPECT_EQ(receive_number(slow.client), last + 2);
    EXPECT_EQ(receive_number(slow.client), last + 3);
    EXPECT_EQ(running.events.count(Kind::FellBehind), 1U);
    EXPECT_EQ(running.stats().fell_behind, 1U);
}

TEST(FallingBehind, EndsTheConnectionOfOneWhoTakesNothingForTooLong) {
    NetLimits limits = small_limits();
    limits.stalled_timeout = 50ms;
    limits.tick = 10ms;
    limits.queued_bytes = 32 * 1024 * 1024;  // Beyond what the system takes of it.
    Running running(limits);
    Greeted slow(running, kSmallReceiveBuffer);
    Greeted idle(running);
    running.carry_out(
        std::vector<Outgoing>(300, {slow.session, Outgoing::Kind::Ordered, frame_of(100'000)}));
    const auto cut = running.events.wait_for(Kind::Disconnected);
    ASSERT_TRUE(cut);
    EXPECT_EQ(cut->session, slow.session);
    EXPECT_EQ(running.stats().stalled, 1U);
    EXPECT_EQ(running.stats().queued_bytes, 0U);
    EXPECT_EQ(running.stats().connections, 1U) << "who is sent nothing takes nothing either";
}

}  // namespace
}  // namespace billiards::server
