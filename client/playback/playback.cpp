// Takes a presentation time; gives poses and events by evaluating the record's timeline.
#include "client/playback/playback.h"

#include "common/timeline/evaluate.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace billiards::client {

Playback::Playback(protocol::server::ShotPlayed shot, base::Duration clock_offset)
    : shot_(std::move(shot)), struck_at_(base::Duration(shot_.struck_us) - clock_offset) {}

std::vector<ShownBall> Playback::balls(base::Instant at) const {
    const double time_s = shot_time_s(at);
    std::vector<ShownBall> shown;
    shown.reserve(shot_.record.timeline.tracks.size());
    for (const timeline::BallTrack& track : shot_.record.timeline.tracks) {
        shown.push_back({.ball = track.ball,
                         .radius_m = track.radius_m,
                         .state = timeline::evaluate(track, time_s)});
    }
    return shown;
}

bool Playback::finished(base::Instant at) const {
    return at >= ends_at();
}

base::Instant Playback::ends_at() const {
    // Rounded up, so that at the end the last ball rests.
    return struck_at_ + base::Duration(static_cast<base::Duration::rep>(
                            std::ceil(shot_.record.duration_s * 1e6)));
}

std::span<const model::ShotEvent> Playback::events_between(base::Instant from,
                                                           base::Instant to) const {
    const auto first_after = [this](base::Instant at) {
        return std::upper_bound(
            shot_.record.events.begin(), shot_.record.events.end(), shot_time_s(at),
            [](double time_s, const model::ShotEvent& event) { return time_s < event.time_s; });
    };
    const auto begin = first_after(from);
    const auto end = first_after(std::max(from, to));
    return {begin, end};
}

}  // namespace billiards::client
