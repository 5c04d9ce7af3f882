// Takes and gives the record of a shot on the wire: one table of times, events of eight bytes, and
// all segments' numbers in one flat list.
#include "common/protocol/codec_record.h"

#include "common/protocol/codec_enums.h"
#include "common/protocol/codec_message.h"
#include "common/protocol/codec_model.h"
#include "common/protocol/codec_segment.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace billiards::protocol {

namespace {

using model::EventKind;
using model::ShotEvent;
using timeline::Segment;
using timeline::ShotRecord;

/// What an index of the wire can reach.
constexpr std::size_t kMaxTimes = std::size_t{std::numeric_limits<std::uint16_t>::max()} + 1;
static_assert(kMaxEventsInRecord + kMaxSegmentsInRecord <= kMaxTimes);

// ---- To the wire

/// When anything happens in `record`: ascending, each once.
std::vector<double> times_of(const ShotRecord& record) {
    std::vector<double> times;
    for (const ShotEvent& event : record.events) times.push_back(event.time_s);
    for (const timeline::BallTrack& track : record.timeline.tracks) {
        for (const Segment& segment : track.segments) times.push_back(segment.start_s);
    }
    std::sort(times.begin(), times.end());
    times.erase(std::unique(times.begin(), times.end()), times.end());
    CHECK(times.size() <= kMaxTimes);
    return times;
}

std::uint16_t index_of(double time_s, const std::vector<double>& times) {
    const auto at = std::lower_bound(times.begin(), times.end(), time_s);
    return static_cast<std::uint16_t>(at - times.begin());
}

void write(wire::Event::Builder out, const ShotEvent& event, const std::vector<double>& times) {
    out.setTime(index_of(event.time_s, times));
    out.setBall(event.ball.number);
    out.setHeld(event.held);
    switch (event.kind) {
        case EventKind::BallBall:
            return out.setBallBall(event.other.number);
        case EventKind::Cushion:
            return out.setCushion(event.index);
        case EventKind::Jaw:
            return out.setJaw(event.index);
        case EventKind::Pocketed:
            return out.setPocketed(static_cast<std::uint8_t>(event.index));
        case EventKind::Motion:
            return out.setMotion(to_wire(event.to));
        case EventKind::HeadString:
            return out.setHeadString(event.direction);
        case EventKind::Landing:
            return out.setLanding();
        case EventKind::OffTable:
            return out.setOffTable();
    }
    CHECK(false);
}

/// The segments of all tracks, one after another.
struct Columns {
    std::vector<std::uint16_t> times;
    std::vector<std::uint8_t> forms;
    std::vector<float> numbers;
};

Columns columns_of(const timeline::Timeline& timeline, const std::vector<double>& times) {
    Columns columns;
    for (const timeline::BallTrack& track : timeline.tracks) {
        for (const Segment& segment : track.segments) {
            columns.times.push_back(index_of(segment.start_s, times));
            columns.forms.push_back(pack(segment, track.radius_m, columns.numbers));
        }
    }
    return columns;
}

template <class List, class T>
void write_list(List out, const std::vector<T>& values) {
    for (unsigned int i = 0; i < out.size(); ++i) out.set(i, values[i]);
}

unsigned int size_of(const auto& values) {
    return static_cast<unsigned int>(values.size());
}

void write(wire::ShotRecord::Builder out, const timeline::Timeline& timeline,
           const std::vector<double>& times) {
    auto tracks = out.initTracks(size_of(timeline.tracks));
    for (unsigned int i = 0; i < tracks.size(); ++i) {
        const timeline::BallTrack& track = timeline.tracks[i];
        tracks[i].setBall(track.ball.number);
        tracks[i].setRadiusM(track.radius_m);
        CHECK(track.segments.size() < kMaxTimes);
        tracks[i].setSegments(static_cast<std::uint16_t>(track.segments.size()));
    }
    const Columns columns = columns_of(timeline, times);
    write_list(out.initSegmentTimes(size_of(columns.times)), columns.times);
    write_list(out.initSegmentForms(size_of(columns.forms)), columns.forms);
    write_list(out.initNumbers(size_of(columns.numbers)), columns.numbers);
}

// ---- From the wire

std::vector<double> read_times(capnp::List<double>::Reader in) {
    std::vector<double> times;
    times.reserve(at_most(in, kMaxTimes, "times").size());
    for (const double time_s : in) {
        const double previous_s = times.empty() ? -1.0 : times.back();
        require(time_s > previous_s && time_s >= 0 && time_s <= kMaxShotDuration_s, "times");
        times.push_back(time_s);
    }
    return times;
}

double time_at(std::uint16_t index, const std::vector<double>& times) {
    require(index < times.size(), "time");
    return times[index];
}

/// Cushions and jaws are numbered by the table, which only the game knows: any number will do.
ShotEvent read(wire::Event::Reader in, double time_s) {
    const model::BallId ball = ball_id(in.getBall());
    switch (in.which()) {
        case wire::Event::BALL_BALL:
            require(ball < ball_id(in.getBallBall()), "other");
            return ShotEvent::ball_ball(time_s, ball, ball_id(in.getBallBall()));
        case wire::Event::CUSHION:
            return ShotEvent::cushion(time_s, ball, in.getCushion(), in.getHeld());
        case wire::Event::JAW:
            return ShotEvent::jaw(time_s, ball, in.getJaw(), in.getHeld());
        case wire::Event::POCKETED:
            require(in.getPocketed() < model::kPockets, "pocket");
            return ShotEvent::pocketed(time_s, ball, model::PocketId{in.getPocketed()});
        case wire::Event::MOTION:
            return ShotEvent::motion(time_s, ball, from_wire<model::Motion>(in.getMotion(), "to"));
        case wire::Event::HEAD_STRING:
            require(ball == model::kCueBall && std::abs(in.getHeadString()) == 1, "direction");
            return ShotEvent::head_string(time_s, in.getHeadString());
        case wire::Event::LANDING:
            return ShotEvent::landing(time_s, ball);
        case wire::Event::OFF_TABLE:
            return ShotEvent::off_table(time_s, ball);
    }
    fail(DecodeErrorCode::UnknownKind, "event");
}

std::vector<ShotEvent> read_events(capnp::List<wire::Event>::Reader in,
                                   const std::vector<double>& times) {
    std::vector<ShotEvent> events;
    events.reserve(at_most(in, kMaxEventsInRecord, "events").size());
    for (const auto event : in) {
        const double time_s = time_at(event.getTime(), times);
        require(events.empty() || events.back().time_s <= time_s, "events");
        events.push_back(read(event, time_s));
    }
    return events;
}

/// All segments of a record, from which the tracks take theirs one after another.
struct Segments {
    capnp::List<std::uint16_t>::Reader times;
    capnp::List<std::uint8_t>::Reader forms;
    std::vector<float> all_numbers;
    std::span<const float> numbers;  ///< Those not yet taken.
    unsigned int next = 0;
};

Segments open_segments(wire::ShotRecord::Reader in) {
    constexpr std::size_t kMaxNumbersOfASegment = 15;  // In free motion, with height and twist.
    Segments segments{.times = at_most(in.getSegmentTimes(), kMaxSegmentsInRecord, "segments"),
                      .forms = at_most(in.getSegmentForms(), kMaxSegmentsInRecord, "segments"),
                      .all_numbers = {},
                      .numbers = {}};
    require(segments.times.size() == segments.forms.size(), "segments");
    const auto numbers =
        at_most(in.getNumbers(), kMaxNumbersOfASegment * kMaxSegmentsInRecord, "numbers");
    segments.all_numbers.reserve(numbers.size());
    for (const float number : numbers) {
        require(std::abs(number) <= kMaxMagnitude, "numbers");
        segments.all_numbers.push_back(number);
    }
    segments.numbers = segments.all_numbers;
    return segments;
}

Segment next_segment(Segments& from, double radius_m, const std::vector<double>& times) {
    require(from.next < from.times.size(), "segments");
    std::optional<Segment> segment = unpack(from.forms[from.next], radius_m, from.numbers);
    require(segment.has_value(), "segments");
    segment->start_s = time_at(from.times[from.next], times);
    ++from.next;
    return *segment;
}

timeline::BallTrack read_track(wire::Track::Reader in, Segments& from,
                               const std::vector<double>& times) {
    const double radius_m = in.getRadiusM();
    require(radius_m >= kMinBallRadius_m && radius_m <= kMaxBallRadius_m, "radius_m");
    require(in.getSegments() > 0, "segments");
    timeline::BallTrack track{.ball = ball_id(in.getBall()), .radius_m = radius_m, .segments = {}};
    for (unsigned int i = 0; i < in.getSegments(); ++i) {
        const Segment segment = next_segment(from, radius_m, times);
        const double previous_s = i == 0 ? 0.0 : track.segments.back().start_s;
        require(i == 0 ? segment.start_s == 0 : segment.start_s >= previous_s, "start_s");
        track.segments.push_back(segment);
    }
    return track;
}

timeline::Timeline read_timeline(wire::ShotRecord::Reader in, const std::vector<double>& times) {
    Segments segments = open_segments(in);
    timeline::Timeline timeline;
    for (const auto wire_track : at_most(in.getTracks(), model::kMaxBalls, "tracks")) {
        timeline::BallTrack track = read_track(wire_track, segments, times);
        require(timeline.tracks.empty() || timeline.tracks.back().ball < track.ball, "tracks");
        timeline.tracks.push_back(std::move(track));
    }
    require(segments.next == segments.times.size() && segments.numbers.empty(), "segments");
    return timeline;
}

}  // namespace

void write(wire::ShotRecord::Builder out, const ShotRecord& record) {
    const std::vector<double> times = times_of(record);
    out.setHash(record.hash);
    out.setDurationS(record.duration_s);
    write_list(out.initTimesS(size_of(times)), times);
    auto events = out.initEvents(size_of(record.events));
    for (unsigned int i = 0; i < events.size(); ++i) write(events[i], record.events[i], times);
    write(out, record.timeline, times);
    write(out.initFinalLayout(), record.final_layout);
}

ShotRecord read(wire::ShotRecord::Reader in) {
    require(in.getDurationS() >= 0 && in.getDurationS() <= kMaxShotDuration_s, "duration_s");
    const std::vector<double> times = read_times(in.getTimesS());
    return {.events = read_events(in.getEvents(), times),
            .timeline = read_timeline(in, times),
            .final_layout = read(in.getFinalLayout()),
            .duration_s = in.getDurationS(),
            .hash = in.getHash()};
}

}  // namespace billiards::protocol
