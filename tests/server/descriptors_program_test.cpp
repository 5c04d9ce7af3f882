// Gives a server few descriptors and more clients than that; those who are in go on as before.
#include "tests/server/net/raw_client.h"
#include "tests/support/process.h"
#include "tests/support/temporary_folder.h"

#include <gtest/gtest.h>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace billiards::server {
namespace {

constexpr std::size_t kDescriptors = 100;
constexpr std::size_t kConnections = kDescriptors / 2;  // The rest is the server's own.

/// A server that may have so many files and connections open.
struct FewDescriptors {
    support::TemporaryFolder folder;
    support::Process process{
        {"/bin/sh", "-c", "ulimit -n " + std::to_string(kDescriptors) + "; exec \"$@\"", "sh",
         BILLIARDS_SERVER_PROGRAM, "--listen", "127.0.0.1:0", "--data", folder.path().string()}};
    std::uint16_t port = 0;

    FewDescriptors() {
        const auto line = process.read_line_with("listening on 127.0.0.1:");
        if (!line) throw std::runtime_error("the server does not listen");
        port = static_cast<std::uint16_t>(std::stoi(line->substr(line->rfind(':') + 1)));
    }
};

/// None where the server turns it away. It is welcome once the player is in the database.
std::unique_ptr<RawClient> welcomed(std::uint16_t port) {
    auto client = std::make_unique<RawClient>(port);
    client->send_preamble();
    client->send(protocol::ClientMessage{1, protocol::client::Hello{.name = "Ada", .token = {}}});
    if (!client->receive_preamble()) return nullptr;
    return client->receive_next<protocol::server::Welcome>() ? std::move(client) : nullptr;
}

bool is_answered(RawClient& client) {
    client.send(protocol::ClientMessage{2, protocol::client::Ping{.client_time_us = 7}});
    return client.receive_next<protocol::server::Pong>().has_value();
}

TEST(Descriptors, AtTheirLimitTheServerServesThoseWhoAreThereAndTakesOthersLater) {
    FewDescriptors server;
    std::vector<std::unique_ptr<RawClient>> inside;
    for (std::size_t i = 0; i < kConnections; ++i) {
        inside.push_back(welcomed(server.port));
        ASSERT_TRUE(inside.back()) << i;
    }
    for (int i = 0; i < 200; ++i) {
        RawClient outside(server.port);
        EXPECT_TRUE(outside.receive_preamble()) << i;
        const auto refused = outside.receive_next<protocol::server::Refused>();
        ASSERT_TRUE(refused) << i;
        EXPECT_EQ(refused->code, protocol::RefusedCode::TooMany);
    }
    for (const auto& client : inside) EXPECT_TRUE(is_answered(*client));
    inside.pop_back();
    std::unique_ptr<RawClient> next;
    // The server may not know at once that there is room again.
    for (int i = 0; i < 1000 && !next; ++i) next = welcomed(server.port);
    EXPECT_TRUE(next);
}

}  // namespace
}  // namespace billiards::server
