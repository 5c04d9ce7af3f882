// Takes a cue ball in hand; gives where it is held, and whether it may be set down there.
#pragma once

#include "common/base/vec.h"
#include "common/match/match_state.h"

namespace billiards::client {

inline constexpr double kNudge_m = 0.001;
inline constexpr double kBigNudge_m = 0.010;

/// The cue ball in hand of one turn. It may be held anywhere between the cushions.
class Placing {
  public:
    /// Held where it lies, or where a player would first put it. The match has the ball in hand.
    explicit Placing(const match::MatchState& match);

    base::Vec2 position_m() const { return position_m_; }
    void hold_at(base::Vec2 position_m);
    void move(base::Vec2 by_m) { hold_at(position_m_ + by_m); }
    /// Whether it may be set down where it is; false is shown in red.
    bool is_legal() const;
    /// It lies where it is held: nothing has to be said to the server.
    bool is_down() const;

    /// The same turn, after the server has set the ball down.
    void update(const match::MatchState& match) { match_ = match; }

  private:
    match::MatchState match_;
    base::Vec2 position_m_{};
};

}  // namespace billiards::client
