// Gives what can happen during a shot, in the form that rules, sounds and people read.
#pragma once

#include "common/model/ball.h"
#include "common/model/shot.h"

#include <cstdint>

namespace billiards::model {

/// The order is part of the wire format; only append.
enum class EventKind : std::uint8_t {
    BallBall,    ///< ball, other: in ascending number.
    Cushion,     ///< ball, index of the cushion segment, held.
    Jaw,         ///< ball, index of the jaw arc, held.
    Pocketed,    ///< ball, index of the pocket.
    Motion,      ///< ball, to: it now moves like this.
    HeadString,  ///< The cue ball's centre crosses the head string; direction +1 is towards +x.
    Landing,     ///< ball: it comes down on the slate.
    OffTable,    ///< ball.
};

/// One event. Fields that its kind does not name keep their defaults.
struct ShotEvent {
    double time_s = 0.0;  ///< Since the strike.
    EventKind kind = EventKind::Motion;
    BallId ball{};
    BallId other{};
    Motion to = Motion::Resting;
    std::int8_t direction = 0;
    /// The ball was touching this cushion or jaw already and had not left it: no new contact.
    bool held = false;
    std::uint16_t index = 0;

    friend bool operator==(const ShotEvent&, const ShotEvent&) = default;

    static ShotEvent ball_ball(double time_s, BallId a, BallId b) {
        ShotEvent event{.time_s = time_s, .kind = EventKind::BallBall, .ball = a, .other = b};
        if (b < a) event.ball = b, event.other = a;
        return event;
    }
    static ShotEvent cushion(double time_s, BallId ball, std::uint16_t index, bool held = false) {
        return {.time_s = time_s,
                .kind = EventKind::Cushion,
                .ball = ball,
                .held = held,
                .index = index};
    }
    static ShotEvent jaw(double time_s, BallId ball, std::uint16_t index, bool held = false) {
        return {
            .time_s = time_s, .kind = EventKind::Jaw, .ball = ball, .held = held, .index = index};
    }
    static ShotEvent pocketed(double time_s, BallId ball, PocketId pocket) {
        return {
            .time_s = time_s, .kind = EventKind::Pocketed, .ball = ball, .index = pocket.number};
    }
    static ShotEvent motion(double time_s, BallId ball, Motion to) {
        return {.time_s = time_s, .kind = EventKind::Motion, .ball = ball, .to = to};
    }
    static ShotEvent head_string(double time_s, int direction) {
        return {.time_s = time_s,
                .kind = EventKind::HeadString,
                .ball = kCueBall,
                .direction = static_cast<std::int8_t>(direction)};
    }
    static ShotEvent landing(double time_s, BallId ball) {
        return {.time_s = time_s, .kind = EventKind::Landing, .ball = ball};
    }
    static ShotEvent off_table(double time_s, BallId ball) {
        return {.time_s = time_s, .kind = EventKind::OffTable, .ball = ball};
    }
};

}  // namespace billiards::model
