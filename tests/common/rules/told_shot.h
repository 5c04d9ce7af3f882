// Takes a shot told event by event, and what was said before it; gives the events, one every tenth
// of a second, and the call. The first seat shoots.
#pragma once

#include "common/model/seat.h"
#include "common/model/shot.h"
#include "common/model/shot_event.h"
#include "common/rules/facts.h"

#include <utility>
#include <vector>

namespace billiards::rules {

inline constexpr model::Seat kShooter = model::Seat::First;
inline constexpr model::Seat kOther = model::Seat::Second;

class ToldShot {
  public:
    /// The cue ball meets an object ball.
    ToldShot& hits(int ball) { return meets(0, ball); }
    ToldShot& meets(int ball, int other) {
        return add(model::ShotEvent::ball_ball(next(), id(ball), id(other)));
    }
    ToldShot& cushion(int ball, bool held = false) {
        return add(model::ShotEvent::cushion(next(), id(ball), 3, held));
    }
    ToldShot& jaw(int ball, bool held = false) {
        return add(model::ShotEvent::jaw(next(), id(ball), 3, held));
    }
    ToldShot& pots(int ball, int pocket = 2) {
        const model::PocketId into{static_cast<std::uint8_t>(pocket)};
        return add(model::ShotEvent::pocketed(next(), id(ball), into));
    }
    ToldShot& leaves(int ball) { return add(model::ShotEvent::off_table(next(), id(ball))); }
    ToldShot& crosses_head_string(int direction = 1) {
        return add(model::ShotEvent::head_string(next(), direction));
    }
    ToldShot& lands(int ball) { return add(model::ShotEvent::landing(next(), id(ball))); }
    ToldShot& moves(int ball) {
        return add(model::ShotEvent::motion(next(), id(ball), model::Motion::Rolling));
    }
    /// The next event happens this much after the last one, instead of a tenth of a second.
    ToldShot& after(double pause_s) {
        pause_s_ = pause_s;
        return *this;
    }
    ToldShot& at_once() { return after(0.0); }

    const std::vector<model::ShotEvent>& events() const { return events_; }
    Facts facts() const { return facts_of(events_); }

    static model::BallId id(int ball) { return {static_cast<std::uint8_t>(ball)}; }

  private:
    double next() { return now_s_ += std::exchange(pause_s_, 0.1); }
    ToldShot& add(const model::ShotEvent& event) {
        events_.push_back(event);
        return *this;
    }

    std::vector<model::ShotEvent> events_;
    double now_s_ = 0.0;
    double pause_s_ = 0.1;
};

inline model::BallSet balls(std::initializer_list<int> numbers) {
    model::BallSet set;
    for (const int number : numbers) set.insert(ToldShot::id(number));
    return set;
}

inline model::Call call(int ball, int pocket = 2) {
    return model::CalledBall{ToldShot::id(ball), {static_cast<std::uint8_t>(pocket)}};
}

}  // namespace billiards::rules
