// Holds a link against servers that are not there, are something else, or do as they should.
#include "client/net/link.h"

#include "tests/client/app/told.h"
#include "tests/client/net/fake_server.h"

#include <gtest/gtest.h>
#include <string>
#include <vector>

namespace billiards::client {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;

/// A link and all that it told.
struct Probe {
    asio::io_context io;
    int connected = 0;
    std::vector<protocol::ServerMessage> messages;
    std::size_t bytes = 0;
    std::optional<Lost> lost;
    std::optional<Link> link;

    explicit Probe(ServerAddress address, const LinkLimits& limits = {}) {
        link.emplace(
            io.get_executor(), std::move(address),
            Link::Callbacks{.connected = [this] { ++connected; },
                            .message =
                                [this](protocol::ServerMessage&& message, std::size_t frame_bytes) {
                                    messages.push_back(std::move(message));
                                    bytes += frame_bytes;
                                },
                            .lost = [this](const Lost& why) { lost = why; }},
            limits);
    }

    template <class Condition>
    void run_until(Condition condition) {
        const auto until = std::chrono::steady_clock::now() + Peer::kPatience;
        while (!condition() && std::chrono::steady_clock::now() < until) {
            io.restart();
            io.run_one_for(seconds(1));
        }
        ASSERT_TRUE(condition());
    }
    void run_until_lost() {
        run_until([this] { return lost.has_value(); });
    }
};

Lost lost_to(FakeServer::Script script, const LinkLimits& limits = {}) {
    FakeServer server(std::move(script));
    Probe probe(server.address(), limits);
    probe.run_until_lost();
    probe.link.reset();
    server.finish();
    EXPECT_TRUE(probe.messages.empty());
    return probe.lost.value_or(Lost{});
}

TEST(Link, SaysThatNothingListens) {
    std::optional<ServerAddress> address;
    {
        FakeServer server([](FakeServer&) {});
        address = server.address();
    }
    Probe probe(*address);
    probe.run_until_lost();
    EXPECT_EQ(probe.lost->code, LostCode::ConnectionRefused);
    EXPECT_EQ(probe.lost->reason, "connection refused: nothing listens at " + to_text(*address));
}

TEST(Link, SaysThatAHostIsUnknown) {
    const std::string too_long_a_label(64, 'x');  // Refused by the resolver without asking anyone.
    Probe probe({.host = too_long_a_label, .port = 1});
    probe.run_until_lost();
    EXPECT_EQ(probe.lost->code, LostCode::UnknownHost);
    EXPECT_EQ(probe.lost->reason, "unknown host: " + too_long_a_label);
}

TEST(Link, SaysThatSomethingElseAnswers) {
    const Lost lost = lost_to([](FakeServer& server) {
        Peer peer = server.accept();
        peer.write(std::string_view("HTTP/1.1 400 Bad Request\r\n\r\n"));
        peer.wait_until_closed();
    });
    EXPECT_EQ(lost.code, LostCode::NotAServer);
    EXPECT_NE(lost.reason.find("is not a gl-billiards server"), std::string::npos) << lost.reason;
}

TEST(Link, SaysThatTheServerSpeaksAnotherVersion) {
    const Lost lost = lost_to([](FakeServer& server) {
        Peer peer = server.accept();
        peer.write_preamble(protocol::kVersionMajor + 1);
        peer.wait_until_closed();
    });
    EXPECT_EQ(lost.code, LostCode::OtherVersion);
    EXPECT_NE(lost.reason.find("2.1"), std::string::npos) << lost.reason;
    EXPECT_NE(lost.reason.find("1.1"), std::string::npos) << lost.reason;
}

TEST(Link, SaysThatTheServerClosed) {
    EXPECT_EQ(lost_to([](FakeServer& server) { server.accept(); }).code, LostCode::Closed);
    EXPECT_EQ(lost_to([](FakeServer& server) { server.accept().exchange_preambles(); }).code,
              LostCode::Closed);
}

TEST(Link, SaysThatWhatCameIsNoMessage) {
    const Lost lost = lost_to([](FakeServer& server) {
        Peer peer = server.accept();
        peer.exchange_preambles();
        const std::vector<std::byte> noise(64, std::byte{0xa5});
        peer.write(protocol::encode_frame_header(noise.size()));
        peer.write(noise);
        peer.wait_until_closed();
    });
    EXPECT_EQ(lost.code, LostCode::Malformed);
}

TEST(Link, SaysThatALengthIsImpossible) {
    for (const std::string_view header : {"\x07\x00\x00\x00", "\x08\x00\x00\x7f"}) {
        const Lost lost = lost_to([header](FakeServer& server) {
            Peer peer = server.accept();
            peer.exchange_preambles();
            peer.write(std::as_bytes(std::span(header.data(), protocol::kFrameHeaderBytes)));
            peer.wait_until_closed();
        });
        EXPECT_EQ(lost.code, LostCode::Malformed);
    }
}

TEST(Link, DoesNotWaitForeverForAPreamble) {
    const Lost lost = lost_to([](FakeServer& server) { server.accept().wait_until_closed(); },
                              {.connect_timeout = milliseconds(30)});
    EXPECT_EQ(lost.code, LostCode::NoAnswer);
}

TEST(Link, NoticesAServerThatHasGoneSilent) {
    const Lost lost = lost_to(
        [](FakeServer& server) {
            Peer peer = server.accept();
            peer.exchange_preambles();
            peer.wait_until_closed();
        },
        {.ping_interval = milliseconds(10), .max_silence = milliseconds(30)});
    EXPECT_EQ(lost.code, LostCode::NoAnswer);
}

TEST(Link, KeepsASessionAliveByPings) {
    FakeServer server([](FakeServer& self) {
        Peer peer = self.accept();
        peer.exchange_preambles();
        for (int i = 0; i < 5; ++i) {
            const auto ping = peer.read_a<protocol::client::Ping>();
            peer.write(
                protocol::server::Pong{.client_time_us = ping.client_time_us, .server_time_us = i});
        }
    });
    Probe probe(server.address(),
                {.ping_interval = milliseconds(5), .max_silence = milliseconds(1000)});
    probe.run_until([&] { return probe.connected == 1; });
    probe.link->keep_alive();
    probe.run_until_lost();
    server.finish();
    EXPECT_EQ(probe.messages.size(), 5U);
}

protocol::server::ChatSaid line(std::size_t number) {
    return {.name = "Ada", .text = std::to_string(number)};
}

TEST(Link, DeliversMessagesHoweverTheyAreCut) {
    std::vector<std::byte> stream;
    constexpr std::size_t kLines = 20;
    for (std::size_t i = 0; i < kLines; ++i) {
        const protocol::SharedFrame frame = protocol::encode(line(i));
        stream.insert(stream.end(), frame->begin(), frame->end());
    }
    for (const std::size_t piece : {std::size_t{1}, std::size_t{7}, stream.size()}) {
        FakeServer server([&](FakeServer& self) {
            Peer peer = self.accept();
            peer.exchange_preambles();
            for (std::size_t at = 0; at < stream.size(); at += piece) {
                peer.write(std::span(stream).subspan(at, std::min(piece, stream.size() - at)));
            }
        });
        Probe probe(server.address());
        probe.run_until_lost();
        ASSERT_EQ(probe.messages.size(), kLines) << piece;
        EXPECT_EQ(probe.bytes, stream.size());
        for (std::size_t i = 0; i < kLines; ++i) {
            EXPECT_EQ(probe.messages[i], protocol::ServerMessage(line(i)));
        }
    }
}

TEST(Link, DeliversAFrameLongerThanItsBuffer) {
    protocol::server::TableList list;
    list.tables.resize(500);
    for (protocol::server::TableRow& row : list.tables) row.name = "A table with a long name";
    ASSERT_GT(protocol::encode(list)->size(), 50'000U);
    FakeServer server([&](FakeServer& self) {
        Peer peer = self.accept();
        peer.exchange_preambles();
        peer.write(list);
        peer.write(line(1));
    });
    Probe probe(server.address());
    probe.run_until_lost();
    ASSERT_EQ(probe.messages.size(), 2U);
    EXPECT_EQ(probe.messages[0], protocol::ServerMessage(list));
    EXPECT_EQ(probe.messages[1], protocol::ServerMessage(line(1)));
}

TEST(Link, SendsInOrderAndTellsWhenItIsWritten) {
    constexpr std::uint32_t kCount = 100;
    FakeServer server([](FakeServer& self) {
        Peer peer = self.accept();
        peer.exchange_preambles();
        for (std::uint32_t i = 0; i < kCount; ++i) {
            if (peer.read()->request_id != i) throw std::runtime_error("out of order");
        }
    });
    Probe probe(server.address());
    std::vector<std::uint32_t> written;
    for (std::uint32_t i = 0; i < kCount; ++i) {  // The first before it is even connected.
        probe.link->send({.request_id = i, .body = protocol::client::ListTables{}},
                         [&written, i] { written.push_back(i); });
        if (i == kCount / 2) probe.run_until([&] { return probe.connected == 1; });
    }
    probe.run_until_lost();
    server.finish();
    ASSERT_EQ(written.size(), kCount);
    EXPECT_TRUE(std::is_sorted(written.begin(), written.end()));
}

TEST(Link, GivesUpAServerThatTakesNothing) {
    const LinkLimits limits{.max_waiting_bytes = 4096};
    FakeServer server([](FakeServer& self) {
        Peer peer = self.accept();
        peer.exchange_preambles();
        peer.wait_until_closed();
    });
    Probe probe(server.address(), limits);
    for (int i = 0; i < 1000; ++i) {  // It cannot be written before it is connected.
        probe.link->send({.request_id = 1, .body = protocol::client::Chat{"still there?"}});
    }
    probe.run_until_lost();
    EXPECT_EQ(probe.lost->code, LostCode::TooMuchWaiting);
}

TEST(Link, LeavesWhatArrivesWhileReadingIsPaused) {
    FakeServer server([](FakeServer& self) {
        Peer peer = self.accept();
        peer.exchange_preambles();
        peer.write(line(1));
        peer.read_a<protocol::client::ListTables>();
        peer.write(line(2));
    });
    Probe probe(server.address());
    probe.run_until([&] { return probe.connected == 1; });
    probe.link->pause_reading();
    // The read that was under way is the last one.
    probe.run_until([&] { return probe.messages.size() == 1; });
    probe.link->send({.request_id = 1, .body = protocol::client::ListTables{}});
    probe.io.restart();
    probe.io.poll();
    server.finish();
    probe.io.restart();
    probe.io.poll();
    EXPECT_EQ(probe.messages.size(), 1U);
    EXPECT_FALSE(probe.lost);
    probe.link->resume_reading();
    probe.run_until_lost();
    EXPECT_EQ(probe.messages.size(), 2U);
}

TEST(Link, NothingIsToldAfterItsEnd) {
    FakeServer server([](FakeServer& self) {
        Peer peer = self.accept();
        peer.exchange_preambles();
        peer.write(line(1));
        peer.wait_until_closed();
    });
    Probe probe(server.address());
    probe.run_until([&] { return probe.messages.size() == 1; });
    probe.link.reset();
    probe.io.restart();
    probe.io.run();
    EXPECT_FALSE(probe.lost);
}

TEST(Link, MayEndInItsOwnCallback) {
    FakeServer server([](FakeServer& self) {
        Peer peer = self.accept();
        peer.exchange_preambles();
        peer.write(line(1));
        peer.write(line(2));
        peer.wait_until_closed();
    });
    asio::io_context io;
    std::optional<Link> link;
    int told = 0;
    link.emplace(io.get_executor(), server.address(),
                 Link::Callbacks{.connected = [] {},
                                 .message =
                                     [&](protocol::ServerMessage&&, std::size_t) {
                                         ++told;
                                         link.reset();
                                     },
                                 .lost = [&](const Lost&) { ++told; }});
    io.run();
    EXPECT_EQ(told, 1);
}

}  // namespace
}  // namespace billiards::client
