// Plays whole matches over real connections: two players and a spectator, each on a thread.
#include "tools/player/run_player.h"

#include "common/bot/choose.h"
#include "tests/support/chaos_proxy.h"
#include "tests/tools/test_server.h"

#include <future>
#include <gtest/gtest.h>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

namespace billiards::tools {
namespace {

client::ServerLinkOptions link_to(const client::ServerAddress& address, const std::string& name) {
    client::ServerLinkOptions link;
    link.address = address;
    link.name = name;
    link.reconnect.first_delay = std::chrono::milliseconds(10);
    link.reconnect.max_delay = std::chrono::milliseconds(40);
    return link;
}

PlayerOptions player(std::uint64_t seed, std::optional<protocol::TableId> table) {
    PlayerOptions options;
    options.table = table;
    options.settings.race_to = 1;
    options.seed = seed;
    options.choose = bot::choose;
    return options;
}

/// One of three: where it sits is told to whoever waits for it.
struct Part {
    std::promise<protocol::TableId> seated;
    bool is_seated = false;
    int links_lost = 0;
    std::future<PlayedOut> played;

    void start(const client::ServerAddress& server, const std::string& name, PlayerOptions options,
               std::function<void(int shot)> on_shot = nullptr) {
        PlayerEvents events;
        events.seated = [this](const client::TableView& table) {
            if (!std::exchange(is_seated, true)) seated.set_value(table.row.table);
        };
        events.shot = [on_shot](const auto&, const protocol::server::ShotPlayed& shot) {
            if (on_shot) on_shot(shot.after.shots_played);
        };
        played = std::async(std::launch::async, [=, this, link = link_to(server, name)] {
            return run_player(link, options, events,
                              [this](const client::LinkLost&) { ++links_lost; });
        });
    }
    protocol::TableId table() { return seated.get_future().get(); }
};

struct Match {
    Part ada;
    Part mary;
    Part grace;

    explicit Match(const client::ServerAddress& server,
                   std::function<void(int shot)> on_shot = nullptr) {
        ada.start(server, "Ada", player(1, std::nullopt));
        const protocol::TableId table = ada.table();
        PlayerOptions spectator = player(0, table);
        spectator.role = protocol::Role::Spectator;
        mary.start(server, "Mary", spectator, std::move(on_shot));
        mary.table();
        grace.start(server, "Grace", player(2, table));
    }
};

TEST(RunPlayer, AMatchIsTheSameForEveryoneWhoSawIt) {
    const TestServer server;
    Match match(server.address());
    const PlayedOut ada = match.ada.played.get();
    const PlayedOut mary = match.mary.played.get();
    const PlayedOut grace = match.grace.played.get();
    for (const PlayedOut* played : {&ada, &mary, &grace}) {
        EXPECT_EQ(played->failure, "");
        EXPECT_EQ(played->digest.missed(), 0);
        EXPECT_EQ(played->digest.value(), mary.digest.value());
        ASSERT_TRUE(played->table && played->table->over);
        EXPECT_EQ(played->table->over->shots, static_cast<std::uint32_t>(mary.digest.shots()));
    }
    EXPECT_GT(mary.digest.shots(), 2);
    EXPECT_TRUE(ada.name.starts_with("Ada#"));
}

TEST(RunPlayer, AMatchGoesOnAfterTheServerWasRestarted) {
    TestServer server;
    std::promise<void> third_shot;
    Match match(server.address(), [&third_shot](int shot) {
        if (shot == 3) third_shot.set_value();
    });
    third_shot.get_future().wait();
    server.restart();
    const PlayedOut ada = match.ada.played.get();
    const PlayedOut mary = match.mary.played.get();
    const PlayedOut grace = match.grace.played.get();
    EXPECT_GE(match.ada.links_lost + match.mary.links_lost + match.grace.links_lost, 1);
    for (const PlayedOut* played : {&ada, &mary, &grace}) {
        EXPECT_EQ(played->failure, "");
        ASSERT_TRUE(played->table && played->table->over);
        EXPECT_EQ(played->digest.shots() + played->digest.missed(),
                  static_cast<int>(played->table->over->shots));
    }
}

/// Only who is told every event that was missed has them all: a snapshot would leave shots out.
TEST(RunPlayer, AMatchOverLinksThatBreakLosesNothingForAnyone) {
    const TestServer server;
    const asio::ip::tcp::endpoint target(asio::ip::address_v4::loopback(), server.address().port);
    support::ChaosProxy proxy(target, {}, 1);
    Match match({.host = "127.0.0.1", .port = proxy.port()}, [&proxy](int shot) {
        if (shot % 4 == 2) proxy.reset_all();
    });
    const PlayedOut ada = match.ada.played.get();
    const PlayedOut mary = match.mary.played.get();
    const PlayedOut grace = match.grace.played.get();
    EXPECT_GE(match.ada.links_lost + match.mary.links_lost + match.grace.links_lost, 3);
    for (const PlayedOut* played : {&ada, &mary, &grace}) {
        EXPECT_EQ(played->failure, "");
        EXPECT_EQ(played->digest.missed(), 0);
        EXPECT_EQ(played->digest.value(), mary.digest.value());
    }
}

TEST(RunPlayer, SaysWhyItCannotPlay) {
    const TestServer server;
    const PlayedOut nowhere =
        run_player(link_to(server.address(), "Ada"), player(1, protocol::TableId{99}), {}, nullptr);
    EXPECT_NE(nowhere.failure.find("no place at the table"), std::string::npos) << nowhere.failure;
}

TEST(RunPlayer, StopsWhenAsked) {
    const TestServer server;
    std::stop_source stop;
    std::jthread stopper;
    PlayerEvents events;
    events.seated = [&](const client::TableView&) { stop.request_stop(); };
    const PlayedOut played = run_player(link_to(server.address(), "Ada"), player(1, std::nullopt),
                                        events, nullptr, stop.get_token());
    EXPECT_EQ(played.failure, "stopped");
}

}  // namespace
}  // namespace billiards::tools
