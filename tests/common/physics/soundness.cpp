// Takes a solved shot; gives what is wrong with it, found from the record alone.
#include "tests/common/physics/soundness.h"

#include "common/physics/motion.h"
#include "common/timeline/evaluate.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <vector>

namespace billiards::physics {

namespace {

using base::Vec2;
using base::Vec3;
using model::EventKind;
using model::Motion;
using timeline::BallTrack;
using timeline::Segment;

constexpr double kMostEnergyRise_j = 1e-12;
constexpr double kMostOverlap_m = 1e-9;
constexpr double kPlaceRounding_m = 1e-12;
constexpr double kSpeedRounding_mps = 1e-9;

using Fault = std::optional<std::string>;

template <class... Parts>
std::string words(const Parts&... parts) {
    std::ostringstream text;
    text.precision(17);
    (text << ... << parts);
    return text.str();
}

double length_of(const auto& v) {
    return std::sqrt(glm::dot(v, v));
}

bool is_contact(EventKind kind) {
    return kind == EventKind::BallBall || kind == EventKind::Cushion || kind == EventKind::Jaw ||
           kind == EventKind::Landing || kind == EventKind::Pocketed || kind == EventKind::OffTable;
}

bool had_contact(const timeline::ShotRecord& record, model::BallId ball, double time_s) {
    return std::any_of(record.events.begin(), record.events.end(), [&](const auto& event) {
        const bool is_its =
            event.ball == ball || (event.kind == EventKind::BallBall && event.other == ball);
        return event.time_s == time_s && is_its && is_contact(event.kind);
    });
}

Fault law_fault(const Diagnostics& diagnostics) {
    if (diagnostics.max_energy_rise_j > kMostEnergyRise_j)
        return words("energy rises by ", diagnostics.max_energy_rise_j, " J");
    if (diagnostics.min_gap_m.value_or(0.0) < -kMostOverlap_m)
        return words("balls overlap by ", -*diagnostics.min_gap_m, " m at an event");
    return {};
}

Fault order_fault(const timeline::ShotRecord& record) {
    if (record.hash != timeline::hash_of(record)) return "the hash is another's";
    const auto is_earlier = [](const auto& a, const auto& b) { return a.time_s < b.time_s; };
    if (!std::is_sorted(record.events.begin(), record.events.end(), is_earlier))
        return "events are out of order";
    const double last_s = record.events.empty() ? 0.0 : record.events.back().time_s;
    if (last_s != record.duration_s) return words("ends at ", record.duration_s, " s");
    return {};
}

/// Places never jump; velocities only where something was met.
Fault joint_fault(const SolvedShot& shot, const BallTrack& track, std::size_t next_index) {
    const Segment& next = track.segments[next_index];
    const Segment& ended = track.segments[next_index - 1];
    if (next.start_s <= ended.start_s) return words("segments out of order at ", next.start_s);
    const model::BallState end = timeline::evaluate(ended, next.start_s);
    const double leap = length_of(end.position_m - next.position_m);
    if (leap > kPlaceRounding_m) return words("jumps by ", leap, " m at ", next.start_s, " s");
    const double kick = length_of(end.velocity_mps - next.velocity_mps);
    const double allowed = shot.parameters.stop_speed_mps + kSpeedRounding_mps;
    if (kick > allowed && !had_contact(shot.record, track.ball, next.start_s))
        return words("its velocity jumps by ", kick, " m/s at ", next.start_s, " s");
    const double slip = length_of(slip_mps(
        {.velocity_mps = next.velocity_mps, .spin_radps = next.spin_radps}, track.radius_m));
    if (next.motion == Motion::Rolling && slip > kPlaceRounding_m)
        return words("slips by ", slip, " m/s as it rolls");
    return {};
}

Fault track_fault(const SolvedShot& shot, const BallTrack& track) {
    if (track.segments.empty() || track.segments.front().start_s != 0.0) return "does not start";
    for (std::size_t i = 1; i < track.segments.size(); ++i) {
        if (auto fault = joint_fault(shot, track, i)) return fault;
    }
    const Motion last = track.segments.back().motion;
    if (last != Motion::Resting && last != Motion::Pocketed && last != Motion::OffTable)
        return words("ends in motion ", static_cast<int>(last));
    const bool has_flown = std::any_of(track.segments.begin(), track.segments.end(),
                                       [](auto& s) { return s.motion == Motion::Airborne; });
    if (last == Motion::OffTable && !has_flown) return "left the table without flying";
    return {};
}

/// In a pocket's mouth a ball may rest past the nose line.
Fault rest_fault(const SolvedShot& shot, const BallTrack& track) {
    const Segment& last = track.segments.back();
    if (last.motion != Motion::Resting) return {};
    const Vec2 place = base::horizontal(last.position_m);
    const Vec2 excess = glm::abs(place) - (shot.table.half_playing_m - track.radius_m);
    const bool is_inside = std::max(excess.x, excess.y) < kMostOverlap_m;
    constexpr double kMouth_m = 0.08;
    const auto is_mouth = [&](const model::PocketCircle& pocket) {
        return length_of(place - pocket.center_m) < pocket.radius_m + kMouth_m;
    };
    const auto& pockets = shot.table.pockets;
    if (!is_inside && std::none_of(pockets.begin(), pockets.end(), is_mouth))
        return words("rests outside the cushions, at ", place.x, ", ", place.y);
    if (last.position_m.z != track.radius_m)
        return words("rests at the height ", last.position_m.z);
    return {};
}

/// Of a ball as it comes to an instant, before what happens then.
Vec3 velocity_before(const BallStart& ball, const BallTrack& track, double time_s) {
    if (time_s == 0.0) return ball.velocity_mps;
    const auto next = std::find_if(track.segments.begin() + 1, track.segments.end(),
                                   [&](const Segment& s) { return s.start_s >= time_s; });
    return timeline::evaluate(*(next - 1), time_s).velocity_mps;
}

/// Where balls meet nothing but each other, what they carry along the slate stays.
Fault momentum_fault(const SolvedShot& shot, double time_s) {
    Vec2 change{};
    for (const BallStart& ball : shot.balls) {
        const auto& tracks = shot.record.timeline.tracks;
        const auto track = std::find_if(tracks.begin(), tracks.end(),
                                        [&](const BallTrack& t) { return t.ball == ball.ball; });
        const Vec3 kick =
            timeline::evaluate(*track, time_s).velocity_mps - velocity_before(ball, *track, time_s);
        change += ball.spec.mass_kg * base::horizontal(kick);
    }
    constexpr double kRounding_ns = 1e-12;
    if (length_of(change) <= kRounding_ns) return {};
    return words("momentum changes by ", length_of(change), " N s at ", time_s, " s");
}

Fault momentum_fault(const SolvedShot& shot) {
    const auto& events = shot.record.events;
    for (std::size_t first = 0, next = 0; first < events.size(); first = next) {
        bool is_among_balls = true;
        for (; next < events.size() && events[next].time_s == events[first].time_s; ++next) {
            is_among_balls &= events[next].kind == EventKind::BallBall;
        }
        if (!is_among_balls) continue;
        if (auto fault = momentum_fault(shot, events[first].time_s)) return fault;
    }
    return {};
}

double gap_to(const model::CushionSegment& cushion, const Vec2& place) {
    const Vec2 span = cushion.to_m - cushion.from_m;
    const double along = glm::dot(place - cushion.from_m, span) / glm::dot(span, span);
    return length_of(place - (cushion.from_m + glm::clamp(along, 0.0, 1.0) * span));
}

struct Seen {
    const BallTrack* track;
    model::BallState state;
};

Fault overlap_fault(const SolvedShot& shot, std::span<const Seen> seen) {
    for (std::size_t i = 0; i < seen.size(); ++i) {
        const Vec3& place = seen[i].state.position_m;
        const double radius = seen[i].track->radius_m;
        const auto name = [&](std::size_t ball) { return int{seen[ball].track->ball.number}; };
        for (std::size_t j = i + 1; j < seen.size(); ++j) {
            const double gap =
                length_of(seen[j].state.position_m - place) - radius - seen[j].track->radius_m;
            if (gap < -kMostOverlap_m)
                return words("balls ", name(i), ", ", name(j), " overlap by ", -gap, " m");
        }
        if (seen[i].state.motion == Motion::Airborne) continue;
        for (const model::CushionSegment& cushion : shot.table.cushions) {
            const double gap = gap_to(cushion, base::horizontal(place)) - radius;
            if (gap < -kMostOverlap_m) return words("ball ", name(i), " is in a cushion by ", -gap);
        }
        for (const model::JawArc& jaw : shot.table.jaws) {
            const double gap =
                length_of(base::horizontal(place) - jaw.center_m) - jaw.radius_m - radius;
            if (gap < -kMostOverlap_m) return words("ball ", name(i), " is in a jaw by ", -gap);
        }
    }
    return {};
}

/// At each event and between each two, so that a contact that was missed shows.
Fault overlap_fault(const SolvedShot& shot) {
    std::vector<Seen> seen;
    double before_s = 0.0;
    for (const model::ShotEvent& event : shot.record.events) {
        const double step = (event.time_s - before_s) / 3;
        if (step == 0.0) continue;
        for (const double time_s : {before_s + step, before_s + 2 * step, event.time_s}) {
            seen.clear();
            for (const BallTrack& track : shot.record.timeline.tracks) {
                const model::BallState state = timeline::evaluate(track, time_s);
                if (model::is_on_table(state.motion)) seen.push_back({&track, state});
            }
            if (auto fault = overlap_fault(shot, seen)) return words(*fault, " at ", time_s, " s");
        }
        before_s = event.time_s;
    }
    return {};
}

}  // namespace

Fault first_fault(const SolvedShot& shot) {
    if (auto fault = law_fault(shot.diagnostics)) return fault;
    if (auto fault = order_fault(shot.record)) return fault;
    for (const BallTrack& track : shot.record.timeline.tracks) {
        auto fault = track_fault(shot, track);
        if (!fault) fault = rest_fault(shot, track);
        if (fault) return words("ball ", int{track.ball.number}, " ", *fault);
    }
    if (auto fault = momentum_fault(shot)) return fault;
    return overlap_fault(shot);
}

}  // namespace billiards::physics
