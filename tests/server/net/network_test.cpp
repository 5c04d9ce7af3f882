// Holds the network against clients that are good, silent, slow or wrong, over real sockets on this
// machine.
#include "server/net/network.h"

#include "tests/server/net/running_network.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>
#include <string>

namespace billiards::server {
namespace {

using namespace std::chrono_literals;
using protocol::server::Refused;
using testing::HasSubstr;
using Kind = RecordedEvent::Kind;

TEST(Network, SendsItsPreambleToAClientThatHasSaidNothing) {
    Running running;
    RawClient client(running.port);
    EXPECT_EQ(client.receive_preamble(), protocol::Preamble{});
    EXPECT_EQ(running.events.count(Kind::Connected), 0U);
}

TEST(Network, TellsOfASessionWhenItsPreambleIsWhole) {
    Running running;
    RawClient client(running.port);
    client.send_preamble();
    EXPECT_TRUE(running.events.wait_for(Kind::Connected));
}

TEST(Network, HandsOnTheMessagesOfAClientInOrder) {
    Running running;
    RawClient client(running.port);
    client.send_preamble();
    for (std::uint32_t number = 1; number <= 20; ++number) client.send(ping(number));
    for (std::uint32_t number = 1; number <= 20; ++number) {
        const auto received = running.events.wait_for(Kind::Received, number);
        ASSERT_TRUE(received);
        EXPECT_EQ(received->message, ping(number));
    }
}

TEST(Network, HandsOnAMessageThatArrivesByteByByte) {
    Running running;
    RawClient client(running.port);
    client.send_preamble();
    const auto frame = protocol::encode(ping(7));
    for (const std::byte& byte : *frame) ASSERT_TRUE(client.send(std::span(&byte, 1)));
    const auto received = running.events.wait_for(Kind::Received);
    ASSERT_TRUE(received);
    EXPECT_EQ(received->message, ping(7));
}

TEST(Network, TellsOfTheEndOfASessionOnce) {
    Running running;
    { const Greeted gone(running); }
    ASSERT_TRUE(running.events.wait_for(Kind::Disconnected));
    Greeted next(running);
    EXPECT_EQ(running.events.count(Kind::Disconnected), 1U);
    EXPECT_EQ(running.stats().connections, 1U);
}

TEST(Network, RefusesBytesThatAreNoPreambleWithoutTellingTheGame) {
    Running running;
    RawClient client(running.port);
    client.send("GET / HTTP/1.1\r\nHost: a\r\n\r\n");
    EXPECT_TRUE(client.receive_preamble());
    expect_refused(client, protocol::RefusedCode::Malformed, "");
    EXPECT_TRUE(running.events.all().empty());
    EXPECT_EQ(running.stats().malformed, 1U);
}

TEST(Network, RefusesAnotherMajorVersionInWordsThatNameBoth) {
    Running running;
    RawClient client(running.port);
    client.send_preamble({.major = 4711});
    EXPECT_EQ(client.receive_preamble(), protocol::Preamble{});
    expect_refused(client, protocol::RefusedCode::Malformed, "4711");
    EXPECT_TRUE(running.events.all().empty());
}

struct HeaderCase {
    const char* name;
    bool greeted;
    std::array<std::uint8_t, 4> header;  ///< The length of a frame, little-endian.
};

class NetworkHeader : public testing::TestWithParam<HeaderCase> {};

TEST_P(NetworkHeader, IsRefusedAndTheSessionEnds) {
    Running running;
    std::optional<Greeted> greeted;
    std::optional<RawClient> fresh;
    if (GetParam().greeted) {
        greeted.emplace(running);
    } else {
        fresh.emplace(running.port).send_preamble();
        EXPECT_TRUE(fresh->receive_preamble());
    }
    RawClient& client = greeted ? greeted->client : *fresh;
    client.send(std::as_bytes(std::span(GetParam().header)));
    expect_refused(client, protocol::RefusedCode::Malformed, "");
    EXPECT_TRUE(running.events.wait_for(Kind::Disconnected));
    EXPECT_EQ(running.events.count(Kind::Received), GetParam().greeted ? 1U : 0U);
}

INSTANTIATE_TEST_SUITE_P(Bad, NetworkHeader,
                         testing::Values(HeaderCase{"Empty", true, {0, 0, 0, 0}},
                                         HeaderCase{"NoMultipleOfEight", true, {12, 0, 0, 0}},
                                         HeaderCase{"OverEightKibibytes", true, {0x08, 0x20, 0, 0}},
                                         HeaderCase{"Huge", true, {0xf8, 0xff, 0xff, 0xff}},
                                         HeaderCase{
                                             "OverTheLimitOfAGreeting", false, {0x08, 0x02, 0, 0}}),
                         [](const auto& param) { return std::string(param.param.name); });

TEST(Network, TakesTheLongestFrameThatIsAllowed) {
    Running running;
    Greeted greeted(running);
    greeted.client.send(protocol::encode_frame_header(protocol::kMaxClientFrameBytes));
    greeted.client.send(std::vector<std::byte>(protocol::kMaxClientFrameBytes));
    greeted.client.send(ping(2));
    EXPECT_TRUE(running.events.wait_for(Kind::Malformed));
    EXPECT_TRUE(running.events.wait_for(Kind::Received, 2));
}

TEST(Network, GoesOnAfterAFrameThatHoldsNoMessage) {
    Running running;
    RawClient client(running.port);
    client.send_preamble();
    client.send(protocol::encode_frame_header(16));
    client.send(std::vector<std::byte>(16, std::byte{0xff}));
    client.send(ping(1));
    EXPECT_TRUE(running.events.wait_for(Kind::Malformed));
    EXPECT_TRUE(running.events.wait_for(Kind::Received));
}

TEST(Network, StandsWhateverBytesAreSent) {
    Running running;
    ASSERT_TRUE(rc::check("random bytes", [&](const std::vector<std::uint8_t>& bytes) {
        RawClient client(running.port);
        client.send_preamble();
        client.send(std::as_bytes(std::span(bytes)));
    }));
    Greeted next(running);
    EXPECT_NE(next.session.value, 0U);
}

TEST(Network, RefusesAClientThatSaysNothing) {
    Running running(impatient());
    RawClient client(running.port);
    EXPECT_TRUE(client.receive_preamble());
    expect_refused(client, protocol::RefusedCode::GreetingTimeout, "no greeting within");
    EXPECT_EQ(running.stats().timed_out, 1U);
}

TEST(Network, RefusesAClientThatDoesNotGreetInTime) {
    Running running(impatient());
    RawClient client(running.port);
    client.send_preamble();
    EXPECT_TRUE(client.receive_preamble());
    expect_refused(client, protocol::RefusedCode::GreetingTimeout, "0.06 s");
    EXPECT_TRUE(running.events.wait_for(Kind::Disconnected));
}

TEST(Network, GivesAGreetingNoMoreTimeForComingInDrops) {
    Running running(impatient());
    RawClient client(running.port);
    client.send_preamble();
    EXPECT_TRUE(client.receive_preamble());
    const auto frame = protocol::encode(ping(1));
    std::size_t sent = 0;
    // Each wait for an answer that does not come is the pace; the whole frame would take longer
    // than the test may.
    while (sent < frame->size() && client.receive(1, 10ms).empty()) {
        client.send(std::span(*frame).subspan(sent++, 1));
    }
    EXPECT_LT(sent, frame->size());
    EXPECT_TRUE(running.events.wait_for(Kind::Disconnected));
    EXPECT_EQ(running.events.count(Kind::Received), 0U);
}

TEST(Network, RefusesAFrameThatIsBegunAndNotEndedInTime) {
    Running running(impatient());
    Greeted greeted(running);
    greeted.client.send(protocol::encode_frame_header(64));
    greeted.client.send("half");
    expect_refused(greeted.client, protocol::RefusedCode::IdleTimeout, "frame");
    EXPECT_TRUE(running.events.wait_for(Kind::Disconnected));
}

TEST(Network, LeavesAGreetedClientAloneHoweverLongItIsSilent) {
    Running running(impatient());
    Greeted patient(running);
    RawClient silent(running.port);
    EXPECT_TRUE(silent.receive_preamble());
    // Came later, and its time is over.
    expect_refused(silent, protocol::RefusedCode::GreetingTimeout, "no greeting within");
    EXPECT_EQ(running.events.count(Kind::Disconnected), 0U);
    EXPECT_TRUE(patient.client.send(ping(2)));
    EXPECT_TRUE(running.events.wait_for(Kind::Received, 2));
}

TEST(Network, SendsFramesInOrderAndEverythingBeforeItCloses) {
    NetLimits limits;
    limits.messages_in_flight = 1;
    Running running(limits);
    Greeted greeted(running);
    for (std::uint32_t number = 1; number <= 3; ++number) greeted.client.send(ping(number));
    ASSERT_TRUE(running.events.wait_for(Kind::Received, 2));  // Two more lie there unread.
    std::vector<Outgoing> batch;
    RawClient::Bytes expected;
    for (std::size_t i = 0; i < 40; ++i) {
        auto frame = std::make_shared<const std::vector<std::byte>>(40'000, std::byte(i));
        expected.insert(expected.end(), frame->begin(), frame->end());
        batch.push_back({greeted.session, Outgoing::Kind::Ordered, std::move(frame)});
    }
    batch.push_back({greeted.session, Outgoing::Kind::Close, nullptr});
    batch.push_back({greeted.session, Outgoing::Kind::Ordered, frame_of(8)});
    running.carry_out(std::move(batch));
    EXPECT_EQ(greeted.client.receive_all(), expected);
    EXPECT_TRUE(running.events.wait_for(Kind::Disconnected));
}

TEST(Network, ClosesEvenWhereTheClientTakesNothingAnyMore) {
    Running running(impatient());
    Greeted greeted(running, 4096);
    std::vector<Outgoing> batch(40, {greeted.session, Outgoing::Kind::Ordered, frame_of(100'000)});
    batch.push_back({greeted.session, Outgoing::Kind::Close, nullptr});
    running.carry_out(std::move(batch));
    EXPECT_TRUE(running.events.wait_for(Kind::Disconnected));
    EXPECT_EQ(running.stop().wait_for(5s), std::future_status::ready);
}

TEST(Network, CutsAReceiverThatIsTooSlowAndNoOneElse) {
    NetLimits limits;
    limits.queued_bytes = 200'000;
    Running running(limits);
    Greeted slow(running, 4096);
    Greeted good(running);
    const protocol::SharedFrame frame = frame_of(100'000);
    std::size_t good_bytes = 0;
    // More than the system's buffers can hold for the slow one.
    for (int round = 0; round < 200 && running.events.count(Kind::Disconnected) == 0; ++round) {
        running.carry_out({{slow.session, Outgoing::Kind::Ordered, frame},
                           {good.session, Outgoing::Kind::Ordered, frame}});
        good_bytes += good.client.receive(frame->size()).size();
        EXPECT_EQ(good_bytes, frame->size() * static_cast<std::size_t>(round + 1));
    }
    const auto cut = running.events.wait_for(Kind::Disconnected);
    ASSERT_TRUE(cut);
    EXPECT_EQ(cut->session, slow.session);
    EXPECT_EQ(running.stats().too_slow, 1U);
    EXPECT_EQ(running.stats().connections, 1U);
}

TEST(Network, ReadsNoFurtherThanTheGameFollows) {
    NetLimits limits;
    limits.messages_in_flight = 3;
    Running running(limits);
    Greeted greeted(running);
    for (std::uint32_t number = 1; number <= 5; ++number) greeted.client.send(ping(number));
    ASSERT_TRUE(running.events.wait_for(Kind::Received, 4));
    { const Greeted another(running); }  // By now a fifth would have been read.
    ASSERT_TRUE(running.events.wait_for(Kind::Disconnected));
    EXPECT_EQ(running.events.count(Kind::Received), 5U);
    running.carry_out(std::vector<Outgoing>(2, {greeted.session, Outgoing::Kind::Handled, {}}));
    const auto last = running.events.wait_for(Kind::Received, 7);
    ASSERT_TRUE(last);
    EXPECT_EQ(last->message, ping(5));
}

TEST(Network, ReadsOnlySoManyMessagesATick) {
    NetLimits limits;
    limits.messages_per_tick = 3;
    limits.tick = 20ms;
    Running running(limits);
    RawClient client(running.port);
    client.send_preamble();
    const auto start = std::chrono::steady_clock::now();
    for (std::uint32_t number = 1; number <= 12; ++number) client.send(ping(number));
    EXPECT_TRUE(running.events.wait_for(Kind::Received, 12));
    EXPECT_GE(std::chrono::steady_clock::now() - start, 2 * limits.tick);
}

TEST(Network, ReadsOnlySoMuchOfWhatIsSaidAfterARefusal) {
    NetLimits limits;
    limits.dropped_bytes = 1000;
    limits.closing_timeout = 1h;
    Running running(limits);
    RawClient client(running.port);
    client.send_preamble({.major = 4711});
    EXPECT_TRUE(client.receive_preamble());
    expect_refused(client, protocol::RefusedCode::Malformed, "4711");
    while (client.send(ping(1))) {  // Until it is gone.
    }
    EXPECT_EQ(running.stats().connections, 0U);
}

TEST(Network, SendsEveryoneAwayBeforeItStops) {
    Running running;
    Greeted one(running);
    Greeted two(running);
    running.carry_out({{one.session, Outgoing::Kind::Ordered, frame_of(1000)}});
    auto stopped = running.stop();
    EXPECT_EQ(one.client.receive_all().size(), 1000U);
    EXPECT_TRUE(two.client.is_closed_by_other_side());
    EXPECT_TRUE(running.events.wait_for(Kind::Disconnected, 2));
    EXPECT_THROW(RawClient(running.port), std::system_error);
}

TEST(Network, CountsWhatGoesInAndOut) {
    Running running;
    Greeted greeted(running);
    running.carry_out({{greeted.session, Outgoing::Kind::Ordered, frame_of(100)}});
    EXPECT_EQ(greeted.client.receive(100).size(), 100U);
    greeted.client.send(ping(1));
    ASSERT_TRUE(running.events.wait_for(Kind::Received, 2));
    const NetStats stats = running.stats();
    EXPECT_EQ(stats.accepted, 1U);
    EXPECT_EQ(stats.frames_in, 2U);
    EXPECT_EQ(stats.bytes_in,
              protocol::encode(ping(0))->size() + protocol::encode(ping(1))->size());
    EXPECT_EQ(stats.frames_out, 2U);
    EXPECT_EQ(stats.bytes_out, protocol::kPreambleBytes + 100U);
}

}  // namespace
}  // namespace billiards::server
