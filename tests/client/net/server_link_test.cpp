// Holds a session on its own thread against servers that close, restart, and send faster than
// anyone listens.
#include "client/net/server_link.h"

#include "tests/client/app/told.h"
#include "tests/client/net/fake_server.h"

#include <gtest/gtest.h>
#include <string>

namespace billiards::client {
namespace {

namespace server = protocol::server;
using std::chrono::milliseconds;

ServerLinkOptions options_for(const FakeServer& server) {
    ServerLinkOptions options;
    options.address = server.address();
    options.name = "Ada";
    options.reconnect.first_delay = milliseconds(5);
    return options;
}

/// The next message of a kind; losses and other messages before it are dropped.
template <class Message>
std::optional<Message> wait_for_a(ServerLink& link) {
    while (const auto event = link.wait_for(Peer::kPatience)) {
        const auto* arrived = std::get_if<Arrived>(&*event);
        if (arrived == nullptr) continue;
        if (const auto* message = std::get_if<Message>(&arrived->message)) return *message;
    }
    return std::nullopt;
}

Peer greet(FakeServer& self, protocol::client::Hello& hello, std::uint8_t token) {
    Peer peer = self.accept();
    peer.exchange_preambles();
    hello = peer.read_a<protocol::client::Hello>();
    server::Welcome welcome = told::welcome(protocol::TableId{7});
    welcome.token = {token};
    peer.write(welcome);
    return peer;
}

TEST(ServerLink, GreetsAndGivesWhatArrives) {
    protocol::client::Hello hello;
    FakeServer fake([&](FakeServer& self) {
        Peer peer = greet(self, hello, 1);
        peer.read_a<protocol::client::ListTables>();
        peer.write(server::TableList{});
        peer.wait_until_closed();
    });
    {
        ServerLink link(options_for(fake));
        ASSERT_TRUE(wait_for_a<server::Welcome>(link));
        link.send(protocol::client::ListTables{});
        ASSERT_TRUE(wait_for_a<server::TableList>(link));
        EXPECT_FALSE(link.poll());
    }
    fake.finish();
    EXPECT_EQ(hello.name, "Ada");
    EXPECT_FALSE(hello.token);
}

TEST(ServerLink, ComesBackWithItsTokenAndRepeatsTheUnansweredShot) {
    const protocol::client::TakeShot shot{
        .turn = {3}, .shot_id = 77, .shot = {.angle_rad = 1.0}, .call = model::Safety{}};
    std::vector<protocol::client::Hello> hellos(3);
    std::vector<protocol::client::TakeShot> shots;
    bool is_repeated_once_answered = false;
    FakeServer fake([&](FakeServer& self) {
        {
            Peer peer = greet(self, hellos[0], 1);
            peer.write(told::snapshot(3, {}, told::match_at(3, model::Seat::First)));
            shots.push_back(peer.read_a<protocol::client::TakeShot>());
        }
        {
            Peer peer = greet(self, hellos[1], 2);
            peer.write(told::snapshot(3, {}, told::match_at(3, model::Seat::First)));
            shots.push_back(peer.read_a<protocol::client::TakeShot>());
            peer.write(told::shot(4, told::match_at(4, model::Seat::Second, 1), 77));
            peer.read_a<protocol::client::Seen>();
        }
        Peer peer = greet(self, hellos[2], 3);
        peer.write(server::Resumed{});
        const auto next = peer.read();
        is_repeated_once_answered =
            next && std::holds_alternative<protocol::client::TakeShot>(next->body);
    });
    {
        ServerLink link(options_for(fake));
        ASSERT_TRUE(wait_for_a<server::Welcome>(link));
        link.send(shot);
        ASSERT_TRUE(wait_for_a<server::ShotPlayed>(link));
        link.send(protocol::client::Seen{});
        ASSERT_TRUE(wait_for_a<server::Welcome>(link));
        fake.finish();
    }
    EXPECT_EQ(shots, (std::vector{shot, shot}));
    EXPECT_FALSE(is_repeated_once_answered);
    EXPECT_EQ(hellos[1].token, protocol::ResumeToken{1});
    EXPECT_EQ(hellos[2].token, protocol::ResumeToken{2});
    EXPECT_FALSE(hellos[0].followed);
    ASSERT_TRUE(hellos[1].followed && hellos[2].followed);
    EXPECT_EQ(hellos[1].followed->sequence, 3U);
    EXPECT_EQ(hellos[2].followed->sequence, 4U);
}

TEST(ServerLink, SaysWhyTheFirstConnectionFailedAndThatItIsFinal) {
    std::optional<ServerLinkOptions> options;
    {
        FakeServer fake([](FakeServer&) {});
        options = options_for(fake);
    }
    ServerLink link(*options);
    const auto event = link.wait_for(Peer::kPatience);
    ASSERT_TRUE(event);
    const auto* lost = std::get_if<LinkLost>(&*event);
    ASSERT_NE(lost, nullptr);
    EXPECT_EQ(lost->lost.code, LostCode::ConnectionRefused);
    EXPECT_FALSE(lost->retry_after);
}

TEST(ServerLink, SaysThatItTriesAgain) {
    protocol::client::Hello hello;
    FakeServer fake([&](FakeServer& self) {
        greet(self, hello, 1);
        greet(self, hello, 2).wait_until_closed();
    });
    {
        ServerLink link(options_for(fake));
        ASSERT_TRUE(wait_for_a<server::Welcome>(link));
        const auto event = link.wait_for(Peer::kPatience);
        ASSERT_TRUE(event);
        const auto* lost = std::get_if<LinkLost>(&*event);
        ASSERT_NE(lost, nullptr);
        EXPECT_TRUE(lost->retry_after);
        ASSERT_TRUE(wait_for_a<server::Welcome>(link));
    }
    fake.finish();
}

TEST(ServerLink, LosesNothingWhenNobodyListensForAWhile) {
    constexpr std::size_t kLines = 3 * kMaxWaitingEvents;
    protocol::client::Hello hello;
    FakeServer fake([&](FakeServer& self) {
        Peer peer = greet(self, hello, 1);
        for (std::size_t i = 0; i < kLines; ++i) {
            peer.write(server::ChatSaid{.name = "Grace", .text = std::to_string(i)});
        }
        peer.write(server::TableList{});
        peer.wait_until_closed();
    });
    {
        ServerLink link(options_for(fake));
        ASSERT_TRUE(wait_for_a<server::Welcome>(link));
        for (std::size_t i = 0; i < kLines; ++i) {
            const auto said = wait_for_a<server::ChatSaid>(link);
            ASSERT_TRUE(said);
            ASSERT_EQ(said->text, std::to_string(i));
        }
        ASSERT_TRUE(wait_for_a<server::TableList>(link));
    }
    fake.finish();
}

}  // namespace
}  // namespace billiards::client
