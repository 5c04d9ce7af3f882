// Takes what the server's threads count; gives it in the text format of Prometheus.
#include "server/ops/metrics.h"

#include <prometheus/metric_family.h>
#include <prometheus/text_serializer.h>
#include <utility>
#include <vector>

namespace billiards::server {
namespace {

using prometheus::ClientMetric;
using prometheus::MetricFamily;
using prometheus::MetricType;

MetricFamily family(std::string name, std::string help, MetricType type, ClientMetric metric) {
    return {std::move(name), std::move(help), type, {std::move(metric)}};
}

template <class Number>
MetricFamily gauge(std::string name, std::string help, Number value) {
    ClientMetric metric;
    metric.gauge.value = static_cast<double>(value);
    return family(std::move(name), std::move(help), MetricType::Gauge, std::move(metric));
}

MetricFamily counter(std::string name, std::string help, std::uint64_t value) {
    ClientMetric metric;
    metric.counter.value = static_cast<double>(value);
    return family(std::move(name), std::move(help), MetricType::Counter, std::move(metric));
}

std::vector<MetricFamily> families_of(const NetStats& net) {
    return {
        gauge("billiards_connections", "Connections open now", net.connections),
        counter("billiards_connections_accepted_total", "Connections taken in", net.accepted),
        counter("billiards_connections_turned_away_total", "Connections over a limit",
                net.turned_away),
        counter("billiards_accept_failures_total", "Times that no connection could be taken in",
                net.accept_failures),
        counter("billiards_connections_timed_out_total",
                "Connections without a greeting or the rest of a frame in time", net.timed_out),
        counter("billiards_connections_too_slow_total", "Receivers cut off with a full queue",
                net.too_slow),
        counter("billiards_connections_stalled_total", "Receivers cut off that took nothing more",
                net.stalled),
        counter("billiards_fell_behind_total", "Spectators sent the newest in place of the rest",
                net.fell_behind),
        counter("billiards_frames_shed_total", "Frames not sent to spectators who were behind",
                net.shed),
        gauge("billiards_queued_bytes", "Bytes that wait for receivers now", net.queued_bytes),
        counter("billiards_frames_received_total", "Frames from clients", net.frames_in),
        counter("billiards_frames_sent_total", "Frames to clients", net.frames_out),
        counter("billiards_bytes_received_total", "Bytes of frames from clients", net.bytes_in),
        counter("billiards_bytes_sent_total", "Bytes to clients", net.bytes_out),
        counter("billiards_malformed_total", "Preambles, frames and messages that were none",
                net.malformed),
    };
}

std::vector<MetricFamily> families_of(const LobbyStats& lobby) {
    return {
        gauge("billiards_sessions", "Sessions known to the game", lobby.sessions),
        gauge("billiards_tables", "Tables open now", lobby.tables),
        gauge("billiards_matches_running", "Matches being played", lobby.matches_running),
        counter("billiards_shots_total", "Shots played", lobby.shots),
        counter("billiards_refusals_total", "Requests that were refused", lobby.refusals),
        counter("billiards_unsolvable_shots_total",
                "Shots refused because too much happens in them", lobby.unsolvable),
        gauge("billiards_storage_failing", "1 while the last commit failed",
              lobby.storage_failing ? 1 : 0),
    };
}

}  // namespace

CommitMetrics::CommitMetrics()
    : took_s_({0.0005, 0.001, 0.002, 0.005, 0.01, 0.02, 0.05, 0.1, 0.2, 0.5, 1.0, 2.0, 5.0}),
      submissions_({1.0, 2.0, 4.0, 8.0, 16.0, 32.0, 64.0, 128.0, 256.0}) {}

void CommitMetrics::observe(const CommitMeasured& measured) {
    took_s_.Observe(base::seconds(measured.took));
    submissions_.Observe(static_cast<double>(measured.submissions));
    if (measured.error) failed_.Increment();
}

std::string metrics_text(const NetStats& net, const LobbyStats& lobby,
                         const CommitMetrics& commits) {
    std::vector<MetricFamily> families = families_of(net);
    for (MetricFamily& one : families_of(lobby)) families.push_back(std::move(one));
    families.push_back(family("billiards_commit_seconds", "From a transaction's begin to durable",
                              MetricType::Histogram, commits.took_s_.Collect()));
    families.push_back(family("billiards_commit_submissions", "Steps in one transaction",
                              MetricType::Histogram, commits.submissions_.Collect()));
    families.push_back(family("billiards_commits_failed_total", "Transactions that failed",
                              MetricType::Counter, commits.failed_.Collect()));
    return prometheus::TextSerializer().Serialize(families);
}

}  // namespace billiards::server
