// Holds the page of metrics against the numbers that it was made from.
#include "server/ops/metrics.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace billiards::server {
namespace {

using namespace std::chrono_literals;
using testing::HasSubstr;

TEST(Metrics, NamesWhatTheNetworkCounts) {
    NetStats net;
    net.connections = 3;
    net.accepted = 5;
    net.frames_in = 7;
    net.bytes_out = 11;
    net.too_slow = 13;
    net.fell_behind = 17;
    net.shed = 18;
    net.stalled = 19;
    net.queued_bytes = 20;
    const std::string text = metrics_text(net, {}, CommitMetrics());
    EXPECT_THAT(text, HasSubstr("\nbilliards_connections 3\n"));
    EXPECT_THAT(text, HasSubstr("# TYPE billiards_connections gauge\n"));
    EXPECT_THAT(text, HasSubstr("\nbilliards_connections_accepted_total 5\n"));
    EXPECT_THAT(text, HasSubstr("# TYPE billiards_connections_accepted_total counter\n"));
    EXPECT_THAT(text, HasSubstr("\nbilliards_frames_received_total 7\n"));
    EXPECT_THAT(text, HasSubstr("\nbilliards_bytes_sent_total 11\n"));
    EXPECT_THAT(text, HasSubstr("\nbilliards_connections_too_slow_total 13\n"));
    EXPECT_THAT(text, HasSubstr("\nbilliards_fell_behind_total 17\n"));
    EXPECT_THAT(text, HasSubstr("\nbilliards_frames_shed_total 18\n"));
    EXPECT_THAT(text, HasSubstr("\nbilliards_connections_stalled_total 19\n"));
    EXPECT_THAT(text, HasSubstr("\nbilliards_queued_bytes 20\n"));
}

TEST(Metrics, NamesWhatTheGameCounts) {
    LobbyStats lobby;
    lobby.sessions = 2;
    lobby.tables = 4;
    lobby.matches_running = 6;
    lobby.shots = 1'000'000;
    lobby.refusals = 8;
    lobby.unsolvable = 2;
    lobby.storage_failing = true;
    const std::string text = metrics_text({}, lobby, CommitMetrics());
    EXPECT_THAT(text, HasSubstr("\nbilliards_sessions 2\n"));
    EXPECT_THAT(text, HasSubstr("\nbilliards_tables 4\n"));
    EXPECT_THAT(text, HasSubstr("\nbilliards_matches_running 6\n"));
    EXPECT_THAT(text, HasSubstr("\nbilliards_shots_total 1000000\n"));
    EXPECT_THAT(text, HasSubstr("\nbilliards_refusals_total 8\n"));
    EXPECT_THAT(text, HasSubstr("\nbilliards_unsolvable_shots_total 2\n"));
    EXPECT_THAT(text, HasSubstr("\nbilliards_storage_failing 1\n"));
}

TEST(Metrics, SortsCommitsByHowLongTheyTook) {
    CommitMetrics commits;
    commits.observe({.took = 3ms, .submissions = 1});
    commits.observe({.took = 30ms, .submissions = 5, .error = StoreError{}});
    const std::string text = metrics_text({}, {}, commits);
    EXPECT_THAT(text, HasSubstr("\nbilliards_commit_seconds_count 2\n"));
    EXPECT_THAT(text, HasSubstr("\nbilliards_commit_seconds_sum 0.033\n"));
    EXPECT_THAT(text, HasSubstr("\nbilliards_commit_seconds_bucket{le=\"0.002\"} 0\n"));
    EXPECT_THAT(text, HasSubstr("\nbilliards_commit_seconds_bucket{le=\"0.005\"} 1\n"));
    EXPECT_THAT(text, HasSubstr("\nbilliards_commit_seconds_bucket{le=\"0.05\"} 2\n"));
    EXPECT_THAT(text, HasSubstr("\nbilliards_commit_submissions_bucket{le=\"1\"} 1\n"));
    EXPECT_THAT(text, HasSubstr("\nbilliards_commits_failed_total 1\n"));
}

}  // namespace
}  // namespace billiards::server
