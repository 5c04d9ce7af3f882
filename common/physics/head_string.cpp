// Takes the cue ball's track; gives its crossings of the head string.
#include "common/physics/head_string.h"

#include "common/base/check.h"
#include "common/physics/detect.h"
#include "common/physics/motion.h"

#include <algorithm>

namespace billiards::physics {

namespace {

using model::ShotEvent;

/// The side on which x is right after now: +1, -1, or 0 where it stays on the line.
int side_of(double offset, double rate, double acceleration) {
    for (const double value : {offset, rate, acceleration}) {
        if (value != 0.0) return value > 0.0 ? 1 : -1;
    }
    return 0;
}

void insert(std::vector<ShotEvent>& events, const ShotEvent& event) {
    const auto after =
        std::upper_bound(events.begin(), events.end(), event.time_s,
                         [](double time, const ShotEvent& other) { return time < other.time_s; });
    events.insert(after, event);
}

/// Follows which side of the line the centre is on.
class Crossings {
  public:
    Crossings(double line_m, double start_m, std::vector<ShotEvent>& events)
        : line_m_(line_m), events_(events), side_(start_m < line_m ? -1 : 1) {}

    void follow(const timeline::Segment& segment, double until_s) {
        const double offset = segment.position_m.x - line_m_;
        const double rate = segment.velocity_mps.x;
        const double acceleration = segment.acceleration_mps2.x;
        const double length = until_s - segment.start_s;
        // A parabola falls through the line once at most, and rises through it once at most.
        const double fall = falling_s(offset, rate, acceleration, length);
        const double rise = falling_s(-offset, -rate, -acceleration, length);
        const bool falls_first = fall < rise;
        pass(segment.start_s, side_of(offset, rate, acceleration));
        if (falls_first) pass(segment.start_s + fall, -1);
        if (rise < kNever_s) pass(segment.start_s + rise, 1);
        if (!falls_first && fall < kNever_s) pass(segment.start_s + fall, -1);
    }

  private:
    void pass(double time_s, int side) {
        if (side == 0 || side == side_) return;
        insert(events_, ShotEvent::head_string(time_s, side));
        side_ = side;
    }

    double line_m_;
    std::vector<ShotEvent>& events_;
    int side_;
};

}  // namespace

void add_head_string_events(const timeline::BallTrack& track, double line_m, double until_s,
                            std::vector<ShotEvent>& events) {
    CHECK(!track.segments.empty());
    Crossings crossings(line_m, track.segments.front().position_m.x, events);
    for (std::size_t i = 0; i < track.segments.size(); ++i) {
        const bool is_last = i + 1 == track.segments.size();
        crossings.follow(track.segments[i], is_last ? until_s : track.segments[i + 1].start_s);
    }
}

}  // namespace billiards::physics
