// Holds each mode of the load generator against a whole server.
#include "tools/load/load.h"

#include "tests/tools/test_server.h"

#include <future>
#include <gtest/gtest.h>
#include <unistd.h>

namespace billiards::tools {
namespace {

using nlohmann::ordered_json;

/// For players who do not think: they set the cue ball down as often as they shoot.
server::LobbyLimits for_the_hasty() {
    server::LobbyLimits limits;
    limits.placements_per_10s = 10'000;
    return limits;
}

struct HastyServer : TestServer {
    HastyServer() : TestServer({}, for_the_hasty()) {}
};

LoadOptions hasty(const TestServer& server, LoadMode mode) {
    LoadOptions options;
    options.server = server.address();
    options.mode = mode;
    options.tables = 3;
    options.spectators = 6;
    options.min_think_s = 0.0;
    options.max_think_s = 0.05;
    return options;
}

ordered_json load_on(const TestServer& server, LoadMode mode) {
    LoadOptions options = hasty(server, mode);
    options.http = server.http_address();
    options.seconds = 0.6;
    options.server_pid = ::getpid();
    return make_load(options);
}

void expect_a_clean_match(const ordered_json& report) {
    EXPECT_EQ(report["errors"], 0) << report.dump(2);
    EXPECT_GT(report["shots"], 5) << report.dump(2);
    EXPECT_GT(report["shot_to_broadcast_ms"]["p50"], 0.0);
    EXPECT_GE(report["shot_to_broadcast_ms"]["max"], report["shot_to_broadcast_ms"]["p50"]);
    EXPECT_LE(report["server_part_ms"]["p50"], report["shot_to_broadcast_ms"]["p50"]);
    EXPECT_GT(report["bytes_per_shot"]["p50"], 100.0);
    EXPECT_EQ(report["connections"], report["connections_wanted"]);
    EXPECT_GT(report["server_rss_mb"], 0.0);
}

TEST(Load, PlayersShootAndEveryReceiverIsCounted) {
    const HastyServer server;
    const ordered_json report = load_on(server, LoadMode::Play);
    expect_a_clean_match(report);
    EXPECT_EQ(report["connections"], 12);
    // Two players and two spectators a table; what was sent last may still be on its way.
    EXPECT_GE(report["receipts"], 3 * report["shots"].get<int>());
    EXPECT_LE(report["receipts"], 4 * report["shots"].get<int>());
    EXPECT_FALSE(report["server_metrics"].empty());
}

TEST(Load, SpectatorsMayAllWatchOneTable) {
    const HastyServer server;
    expect_a_clean_match(load_on(server, LoadMode::Spectate));
}

TEST(Load, IdleSpectatorsOnlyStay) {
    const HastyServer server;
    const ordered_json report = load_on(server, LoadMode::Idle);
    EXPECT_EQ(report["errors"], 0) << report.dump(2);
    EXPECT_EQ(report["connections"], 9);
    EXPECT_EQ(report["shots"], 0);
    EXPECT_TRUE(report["shot_to_broadcast_ms"].is_null());
}

TEST(Load, SlowSpectatorsDoNotHoldUpPlayers) {
    const HastyServer server;
    const ordered_json report = load_on(server, LoadMode::Slow);
    expect_a_clean_match(report);
    EXPECT_LE(report["receipts"], 2 * report["shots"].get<int>() + 6) << "only players read";
}

TEST(Load, PlayersPlayOnBesideNonsense) {
    const HastyServer server;
    const ordered_json report = load_on(server, LoadMode::Garbage);
    expect_a_clean_match(report);
    EXPECT_GT(report["nonsense_sent"], 5);
}

TEST(Load, WhoeverDropsComesBack) {
    const HastyServer server;
    LoadOptions options = hasty(server, LoadMode::Flap);
    options.seconds = 1.0;
    options.drop_after_s = 0.4;
    const ordered_json report = make_load(options);
    EXPECT_EQ(report["errors"], 0) << report.dump(2);
    EXPECT_GT(report["reconnects"], 3);
    EXPECT_GT(report["shots"], 5);
    EXPECT_TRUE(report["server_cpu_s"].is_null());
}

TEST(Load, AfterARestartItTellsHowSoonEverybodyWasBack) {
    HastyServer server;
    LoadOptions options = hasty(server, LoadMode::Reconnect);
    options.seconds = 30.0;
    std::promise<void> in_place;
    options.in_place = [&in_place] { in_place.set_value(); };
    std::future<ordered_json> load = std::async(std::launch::async, make_load, options);
    in_place.get_future().wait();
    server.restart();
    const ordered_json report = load.get();
    EXPECT_EQ(report["gone"], 0) << report.dump(2);
    EXPECT_EQ(report["places_lost"], 12);
    EXPECT_EQ(report["places_taken_again"], 12);
    EXPECT_GT(report["place_again_since_up_s"]["max"], 0.0);
    EXPECT_LT(report["measured_s"], 30.0);
}

TEST(Load, WhoReadsNothingIsComparedWithNobodyOfThatKind) {
    const HastyServer server;
    const ordered_json report = load_on(server, LoadMode::Stall);
    expect_a_clean_match(report);
    EXPECT_EQ(report["stalled"], 1);
    EXPECT_GT(report["shot_to_broadcast_ms_without_stalled"]["p99"], 0.0);
    EXPECT_GT(report["ratio"]["shot_to_broadcast_ms"]["p99"], 0.0);
}

TEST(Load, AServerThatIsNotThereIsAnError) {
    std::optional<client::ServerAddress> address;
    {
        const TestServer server;
        address = server.address();
    }
    LoadOptions options;
    options.server = *address;
    options.tables = 1;
    options.seconds = 0.1;
    options.gather_s = 0.1;
    const ordered_json report = make_load(options);
    EXPECT_GE(report["errors"], 1);
    EXPECT_EQ(report["connections"], 0);
}

}  // namespace
}  // namespace billiards::tools
