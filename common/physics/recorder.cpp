// Takes events and segments as they come; gives the record of the shot.
#include "common/physics/recorder.h"

#include "common/physics/head_string.h"
#include "common/physics/motion.h"

#include <algorithm>
#include <utility>

namespace billiards::physics {

namespace {

constexpr std::size_t kUsualEvents = 256;
constexpr std::size_t kUsualSegments = 32;

model::Place place_of(model::Motion motion) {
    if (motion == model::Motion::Pocketed) return model::Place::Pocketed;
    return motion == model::Motion::OffTable ? model::Place::OffTable : model::Place::OnTable;
}

}  // namespace

Recorder::Recorder(std::span<const Mover> movers) {
    record_.events.reserve(kUsualEvents);
    record_.timeline.tracks.reserve(movers.size());
    for (const Mover& mover : movers) {
        timeline::BallTrack& track = record_.timeline.tracks.emplace_back();
        track.ball = mover.id;
        track.radius_m = mover.spec.radius_m;
        track.segments.reserve(kUsualSegments);
        track.segments.push_back(mover.plan.segment);
    }
}

void Recorder::add_segment(std::size_t ball, const timeline::Segment& segment) {
    std::vector<timeline::Segment>& segments = record_.timeline.tracks[ball].segments;
    if (segments.back().start_s == segment.start_s) {
        segments.back() = segment;
    } else {
        segments.push_back(segment);
    }
}

timeline::ShotRecord Recorder::finish(double duration_s, std::optional<double> head_string_m,
                                      std::span<const model::PlacedBall> absent) {
    record_.duration_s = duration_s;
    for (const timeline::BallTrack& track : record_.timeline.tracks) {
        const timeline::Segment& last = track.segments.back();
        record_.final_layout.balls.push_back({.ball = track.ball,
                                              .place = place_of(last.motion),
                                              .position_m = base::horizontal(position_at(
                                                  last, std::max(duration_s, last.start_s)))});
        if (head_string_m && track.ball == model::kCueBall) {
            add_head_string_events(track, *head_string_m, duration_s, record_.events);
        }
    }
    for (const model::PlacedBall& placed : absent) add_absent(placed);
    if (!absent.empty()) sort_balls();
    record_.hash = timeline::hash_of(record_);
    return std::exchange(record_, {});
}

void Recorder::add_absent(const model::PlacedBall& placed) {
    record_.final_layout.balls.push_back(placed);
    if (placed.place != model::Place::Pocketed && placed.place != model::Place::OffTable) return;
    const bool is_pocketed = placed.place == model::Place::Pocketed;
    const double radius = model::BallSpec{}.radius_m;
    record_.timeline.tracks.push_back(
        {.ball = placed.ball,
         .radius_m = radius,
         .segments = {
             {.position_m = {placed.position_m, radius},
              .motion = is_pocketed ? model::Motion::Pocketed : model::Motion::OffTable}}});
}

void Recorder::sort_balls() {
    const auto by_ball = [](const auto& a, const auto& b) { return a.ball < b.ball; };
    std::sort(record_.final_layout.balls.begin(), record_.final_layout.balls.end(), by_ball);
    std::sort(record_.timeline.tracks.begin(), record_.timeline.tracks.end(), by_ball);
}

}  // namespace billiards::physics
