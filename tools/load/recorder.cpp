// Takes samples; gives counts and quantiles.
#include "tools/load/recorder.h"

#include <algorithm>
#include <cmath>

namespace billiards::tools {

namespace {

constexpr double kMicrosecondsPerMillisecond = 1e3;

}  // namespace

double Samples::at(double quantile) const {
    if (samples_.empty()) return 0.0;
    const auto rank =
        static_cast<std::ptrdiff_t>(std::ceil(quantile * static_cast<double>(samples_.size())));
    std::vector<double> sorted = samples_;
    const auto nth = sorted.begin() + std::max<std::ptrdiff_t>(rank - 1, 0);
    std::nth_element(sorted.begin(), nth, sorted.end());
    return *nth;
}

nlohmann::ordered_json Samples::summary() const {
    if (samples_.empty()) return nullptr;
    // To a thousandth: what is beyond it is noise of the subtractions.
    const auto rounded = [this](double quantile) { return std::round(at(quantile) * 1e3) / 1e3; };
    return {{"p50", rounded(0.5)}, {"p99", rounded(0.99)}, {"max", rounded(1.0)}};
}

void Recorder::shot_sent(std::uint64_t shot_id, base::Instant at) {
    // A repeat after a lost link was sent first when it was sent first.
    if (is_measuring_) sent_.try_emplace(shot_id, Sent{.at = at});
}

void Recorder::shot_received(const protocol::server::ShotPlayed& shot, std::size_t frame_bytes,
                             base::Instant at) {
    const auto sent = sent_.find(shot.shot_id);
    if (sent == sent_.end()) return;
    const double commit_ms = shot.commit_us / kMicrosecondsPerMillisecond;
    const double took_ms =
        static_cast<double>((at - sent->second.at).count()) / kMicrosecondsPerMillisecond;
    shot_to_broadcast_ms_.add(took_ms);
    without_commit_ms_.add(std::max(took_ms - commit_ms, 0.0));
    if (sent->second.is_answered) return;
    sent->second.is_answered = true;
    ++shots_;
    commit_ms_.add(commit_ms);
    bytes_per_shot_.add(static_cast<double>(frame_bytes));
}

void Recorder::await_loss() {
    awaits_loss_ = true;
    first_lost_.reset();
    first_connected_.reset();
    places_lost_ = 0;
    return_s_ = {};
    return_since_up_s_ = {};
}

void Recorder::connected(base::Instant now) {
    if (first_lost_ && !first_connected_) first_connected_ = now;
}

void Recorder::lost_place(base::Instant now) {
    if (awaits_loss_ && !first_lost_) first_lost_ = now;
    ++places_lost_;
}

void Recorder::returned(base::Duration after, base::Instant now) {
    return_s_.add(base::seconds(after));
    if (first_connected_) return_since_up_s_.add(base::seconds(now - *first_connected_));
}

nlohmann::ordered_json Recorder::report() const {
    std::uint64_t errors = 0;
    for (const auto& [what, count] : errors_) errors += count;
    const auto unanswered = std::count_if(
        sent_.begin(), sent_.end(), [](const auto& shot) { return !shot.second.is_answered; });
    return {{"shots", shots_},
            {"shots_unanswered", unanswered},
            {"errors", errors},
            {"error_kinds", errors_},
            {"shot_to_broadcast_ms", shot_to_broadcast_ms_.summary()},
            {"server_part_ms", without_commit_ms_.summary()},
            {"fsync_ms", commit_ms_.summary()},
            {"bytes_per_shot", bytes_per_shot_.summary()},
            {"receipts", shot_to_broadcast_ms_.size()},
            {"reconnects", reconnect_s_.size()},
            {"reconnect_s", reconnect_s_.summary()},
            {"places_lost", places_lost_},
            {"places_taken_again", return_s_.size()},
            {"place_again_s", return_s_.summary()},
            {"place_again_since_up_s", return_since_up_s_.summary()},
            {"resumed_by_ring", by_ring_},
            {"resumed_by_snapshot", by_snapshot_},
            {"nonsense_sent", nonsense_}};
}

}  // namespace billiards::tools
