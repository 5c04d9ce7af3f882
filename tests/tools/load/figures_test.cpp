// Holds the figures of a load against samples made by hand.
#include "tests/client/app/told.h"
#include "tools/load/nonsense.h"
#include "tools/load/process_stats.h"
#include "tools/load/recorder.h"
#include "tools/load/scrape.h"

#include <gtest/gtest.h>
#include <set>
#include <string>
#include <unistd.h>

namespace billiards::tools {
namespace {

namespace told = client::told;
using std::chrono::milliseconds;
using told::kNow;

TEST(Samples, QuantilesAreSamples) {
    Samples samples;
    for (int i = 100; i >= 1; --i) samples.add(i);
    EXPECT_EQ(samples.at(0.5), 50.0);
    EXPECT_EQ(samples.at(0.99), 99.0);
    EXPECT_EQ(samples.at(1.0), 100.0);
    EXPECT_EQ(samples.summary(), (nlohmann::ordered_json{{"p50", 50}, {"p99", 99}, {"max", 100}}));
}

TEST(Samples, OfNoneThereIsNoQuantile) {
    EXPECT_TRUE(Samples().summary().is_null());
}

protocol::server::ShotPlayed shot(std::uint64_t id, std::uint32_t commit_us) {
    protocol::server::ShotPlayed shot = told::shot(1, {}, id);
    shot.commit_us = commit_us;
    return shot;
}

TEST(Recorder, MeasuresFromTheLastByteToEachReceiver) {
    Recorder recorder;
    recorder.start();
    recorder.shot_sent(1, kNow);
    recorder.shot_received(shot(1, 4000), 2400, kNow + milliseconds(10));
    recorder.shot_received(shot(1, 4000), 2400, kNow + milliseconds(30));
    const auto report = recorder.report();
    EXPECT_EQ(report["shots"], 1);
    EXPECT_EQ(report["receipts"], 2);
    EXPECT_EQ(report["shot_to_broadcast_ms"]["p50"], 10.0);
    EXPECT_EQ(report["shot_to_broadcast_ms"]["max"], 30.0);
    EXPECT_EQ(report["server_part_ms"]["max"], 26.0);
    EXPECT_EQ(report["fsync_ms"]["p99"], 4.0);
    EXPECT_EQ(report["bytes_per_shot"]["p50"], 2400.0);
}

TEST(Recorder, LeavesOutWhatWasSentBeforeItMeasured) {
    Recorder recorder;
    recorder.shot_sent(1, kNow);
    recorder.start();
    recorder.shot_received(shot(1, 0), 100, kNow + milliseconds(10));
    EXPECT_EQ(recorder.report()["receipts"], 0);
}

TEST(Recorder, ARepeatedShotCountsFromItsFirstSending) {
    Recorder recorder;
    recorder.start();
    recorder.shot_sent(1, kNow);
    recorder.shot_sent(1, kNow + milliseconds(500));
    recorder.shot_received(shot(1, 0), 100, kNow + milliseconds(510));
    EXPECT_EQ(recorder.report()["shot_to_broadcast_ms"]["max"], 510.0);
}

TEST(Recorder, CountsErrorsByNameReconnectsAndWhatWasNotAnswered) {
    Recorder recorder;
    recorder.start();
    recorder.shot_sent(1, kNow);
    recorder.error("link lost: closed");
    recorder.error("link lost: closed");
    recorder.error("refused: too early");
    recorder.reconnected(milliseconds(1500));
    const auto report = recorder.report();
    EXPECT_EQ(report["errors"], 3);
    EXPECT_EQ(report["error_kinds"]["link lost: closed"], 2);
    EXPECT_EQ(report["shots_unanswered"], 1);
    EXPECT_EQ(report["reconnects"], 1);
    EXPECT_EQ(report["reconnect_s"]["max"], 1.5);
}

TEST(Recorder, TellsHowSoonPlacesWereTakenAgainOnceTheServerWasUp) {
    Recorder recorder;
    recorder.connected(kNow);
    recorder.lost_place(kNow);
    recorder.returned(milliseconds(100), kNow + milliseconds(100));
    recorder.await_loss();
    recorder.lost_place(kNow + milliseconds(1000));
    recorder.connected(kNow + milliseconds(1500));
    recorder.connected(kNow + milliseconds(1600));
    recorder.resumed(Recorder::Way::Ring);
    recorder.returned(milliseconds(700), kNow + milliseconds(1700));
    const auto report = recorder.report();
    EXPECT_EQ(report["places_lost"], 1);
    EXPECT_EQ(report["places_taken_again"], 1);
    EXPECT_EQ(report["place_again_s"]["max"], 0.7);
    EXPECT_EQ(report["place_again_since_up_s"]["max"], 0.2);
    EXPECT_EQ(report["resumed_by_ring"], 1);
    EXPECT_EQ(report["resumed_by_snapshot"], 0);
}

TEST(ProcessStats, TellOfThisProcess) {
    const auto own = read_process(::getpid());
    ASSERT_TRUE(own);
    EXPECT_GT(own->rss_mb, 1.0);
    EXPECT_LT(own->rss_mb, 10'000.0);
    EXPECT_GE(own->cpu_s, 0.0);
    EXPECT_FALSE(read_process(-5));
}

TEST(Scrape, ReadsMetricsAndLeavesOutTheRest) {
    const auto metrics = parse_metrics(
        "# HELP shots_total Shots\n# TYPE shots_total counter\nshots_total 42\n"
        "commits{kind=\"a b\"} 0.5\n\nnonsense\n");
    EXPECT_EQ(metrics,
              (nlohmann::ordered_json{{"shots_total", 42.0}, {"commits{kind=\"a b\"}", 0.5}}));
}

TEST(Nonsense, IsOfManyKindsAndFollowsFromItsSeed) {
    base::Random random(1);
    base::Random same(1);
    std::set<std::string> kinds;
    for (int i = 0; i < 50; ++i) {
        const std::vector<std::byte> bytes = nonsense(random);
        EXPECT_EQ(bytes, nonsense(same));
        kinds.emplace(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    }
    EXPECT_GT(kinds.size(), 25U);
    EXPECT_TRUE(kinds.contains("")) << "silence is one of them";
}

}  // namespace
}  // namespace billiards::tools
