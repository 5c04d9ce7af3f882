// Holds the network against addresses that it cannot have, and guests that it has no room for.
#include "tests/server/net/running_network.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <spdlog/spdlog.h>
#include <sys/resource.h>
#include <unistd.h>

namespace billiards::server {
namespace {

using namespace std::chrono_literals;
using testing::HasSubstr;
using Kind = RecordedEvent::Kind;

TEST(Listening, TurnsAwayInWordsWhoIsOverTheLimitAndTakesTheNextOneInItsPlace) {
    NetLimits limits;
    limits.connections = 1;
    Running running(limits);
    {
        Greeted first(running);
        RawClient second(running.port);
        EXPECT_TRUE(second.receive_preamble());
        expect_refused(second, protocol::RefusedCode::TooMany, "too many connections");
        EXPECT_EQ(running.stats().turned_away, 1U);
    }
    ASSERT_TRUE(running.events.wait_for(Kind::Disconnected));
    Greeted third(running);
    EXPECT_EQ(running.stats().accepted, 2U);
}

TEST(Listening, ReadsWhatIsSaidByWhoIsTurnedAwaySoThatNothingCutsOffTheAnswer) {
    NetLimits limits;
    limits.connections = 1;
    Running running(limits);
    Greeted first(running);
    {
        RawClient second(running.port);
        EXPECT_TRUE(second.receive_preamble());
        expect_refused(second, protocol::RefusedCode::TooMany, "too many connections");
        for (std::uint32_t number = 1; number <= 3; ++number) {
            EXPECT_TRUE(second.send(ping(number)));
        }
        EXPECT_EQ(running.stats().connections, 1U);
    }
    EXPECT_EQ(running.events.count(Kind::Connected), 1U);
    first.client.send(ping(1));
    EXPECT_TRUE(running.events.wait_for(Kind::Received, 2));
}

TEST(Listening, WaitsOnlyForSoManyWhomItTurnsAwayAndTellsTheOthersWithoutWaiting) {
    NetLimits limits;
    limits.connections = 1;
    limits.turned_away_at_once = 0;
    limits.closing_timeout = 1h;
    Running running(limits);
    Greeted first(running);
    RawClient second(running.port);
    EXPECT_TRUE(second.receive_preamble());
    expect_refused(second, protocol::RefusedCode::TooMany, "too many connections");
    while (second.send(ping(1))) {  // Until it is gone: nobody reads this.
    }
}

TEST(Listening, SaysWhichAddressIsInUse) {
    Running running;
    asio::io_context context;
    RecordedEvents events;
    spdlog::logger log("test");
    Network second(context, {}, events, log);
    const Endpoint taken(asio::ip::address_v4::loopback(), running.port);
    try {
        second.listen(taken);
        FAIL() << "listens twice";
    } catch (const std::runtime_error& error) {
        EXPECT_THAT(error.what(), HasSubstr(to_text(taken)));
        EXPECT_THAT(error.what(), HasSubstr("already in use"));
    }
}

TEST(Listening, ListensWithIPv6WhereIPv4HasTheSamePort) {
    Running running;
    asio::io_context context;
    RecordedEvents events;
    spdlog::logger log("test");
    Network second(context, {}, events, log);
    try {
        second.listen(*parse_endpoint("[::1]:0"));
    } catch (const std::runtime_error&) {
        GTEST_SKIP() << "this machine has no IPv6";
    }
    const Endpoint same_port(asio::ip::address_v6::any(), running.port);
    EXPECT_EQ(second.listen(same_port), same_port);
}

TEST(Listening, SaysWhichAddressIsNotThisMachines) {
    asio::io_context context;
    RecordedEvents events;
    spdlog::logger log("test");
    Network network(context, {}, events, log);
    try {
        network.listen(*parse_endpoint("192.0.2.1:0"));  // Of documentation: RFC 5737.
        FAIL() << "listens on an address of documentation";
    } catch (const std::runtime_error& error) {
        EXPECT_THAT(error.what(), HasSubstr("192.0.2.1:0"));
        EXPECT_THAT(error.what(), HasSubstr("assign"));
    }
}

/// Leaves this process one descriptor to open, for as long as it lives.
class OneMoreDescriptor {
  public:
    OneMoreDescriptor() {
        ::getrlimit(RLIMIT_NOFILE, &before_);
        const int lowest_free = ::dup(0);
        ::close(lowest_free);
        rlimit few = before_;
        few.rlim_cur = static_cast<rlim_t>(lowest_free) + 1;
        ::setrlimit(RLIMIT_NOFILE, &few);
    }
    ~OneMoreDescriptor() { ::setrlimit(RLIMIT_NOFILE, &before_); }
    OneMoreDescriptor(const OneMoreDescriptor&) = delete;
    OneMoreDescriptor& operator=(const OneMoreDescriptor&) = delete;

  private:
    rlimit before_{};
};

TEST(Listening, TakesClientsInOnceThereAreDescriptorsAgain) {
#ifdef __SANITIZE_ADDRESS__
    GTEST_SKIP()
        << "the sanitizers open pipes to look at memory, and call it bad where they cannot";
#endif
    NetLimits limits;
    limits.pause_when_out_of_sockets = 5ms;
    Running running(limits);
    std::optional<OneMoreDescriptor> shortage(std::in_place);
    RawClient client(running.port);  // Has the last descriptor, so the server cannot accept it.
    const auto end = std::chrono::steady_clock::now() + 5s;
    while (running.log_text().empty() && std::chrono::steady_clock::now() < end) {
    }
    EXPECT_THAT(running.log_text(), HasSubstr("cannot accept on 127.0.0.1"));
    EXPECT_GE(running.stats().accept_failures, 1U);
    shortage.reset();
    EXPECT_TRUE(client.receive_preamble());
}

}  // namespace
}  // namespace billiards::server
