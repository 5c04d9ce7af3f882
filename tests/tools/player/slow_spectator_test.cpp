// Plays a whole match in front of a spectator who reads nothing until it is over.
#include "client/app/reduce.h"
#include "tests/server/net/raw_client.h"
#include "tests/tools/test_server.h"
#include "tools/player/run_player.h"
#include "tools/player/simple_shot.h"

#include <future>
#include <gtest/gtest.h>
#include <utility>

namespace billiards::tools {
namespace {

namespace asked = protocol::client;
namespace told = protocol::server;

/// So little that one match is more than waits and is on its way together.
server::NetLimits small_limits() {
    server::NetLimits limits;
    limits.sheddable_bytes = 16 * 1024;
    limits.send_buffer_bytes = 8 * 1024;
    return limits;
}

PlayedOut play(const TestServer& server, PlayerOptions options, const PlayerEvents& events = {}) {
    client::ServerLinkOptions link;
    link.address = server.address();
    link.name = "Ada";
    options.settings.race_to = 2;
    options.choose = simple_shot;
    return run_player(link, options, events, nullptr);
}

struct Watched {
    client::ClientState state;
    int snapshots = 0;
    int shots = 0;

    void take(const protocol::ServerMessage& message) {
        if (std::holds_alternative<told::TableSnapshot>(message)) ++snapshots;
        if (std::holds_alternative<told::ShotPlayed>(message)) ++shots;
        state = client::reduce(std::move(state), message, base::Instant());
    }
    bool has_seen_the_end() const {
        return state.table && state.table->match && state.table->match->stage == match::Stage::Over;
    }
};

TEST(SlowSpectator, MissesShotsButNotHowTheMatchStandsAndHoldsNobodyUp) {
    const TestServer server(small_limits());
    server::RawClient spectator(server.address().port, 4096);
    Watched watched;
    std::promise<protocol::TableId> opened;
    PlayerEvents events;
    bool is_seated = false;
    events.seated = [&](const client::TableView& table) {
        if (!std::exchange(is_seated, true)) opened.set_value(table.row.table);
    };
    auto first = std::async(std::launch::async, [&] { return play(server, {}, events); });
    PlayerOptions second;
    second.table = opened.get_future().get();
    second.seed = 2;
    spectator.send_preamble();
    ASSERT_TRUE(spectator.receive_preamble());
    spectator.send(protocol::ClientMessage{1, asked::Hello{.name = "Mary", .token = {}}});
    ASSERT_TRUE(spectator.receive_next<told::Welcome>());
    spectator.send(protocol::ClientMessage{
        2, asked::Join{.table = *second.table, .role = protocol::Role::Spectator}});
    while (watched.snapshots == 0) {
        const auto message = spectator.receive_message();
        ASSERT_TRUE(message);
        watched.take(*message);
    }
    const PlayedOut ada = play(server, second);
    ASSERT_EQ(ada.failure, "");
    ASSERT_EQ(first.get().failure, "");
    while (!watched.has_seen_the_end()) {
        const auto message = spectator.receive_message();
        ASSERT_TRUE(message) << "the spectator is not told how the match ended";
        watched.take(*message);
    }
    EXPECT_EQ(watched.state.table->match, ada.table->match);
    EXPECT_GT(watched.snapshots, 1);
    EXPECT_LT(watched.shots, ada.digest.shots());
}

}  // namespace
}  // namespace billiards::tools
