// Takes what hands do to the cue; gives the shot under construction.
#pragma once

#include "common/base/vec.h"
#include "common/model/shot.h"

#include <optional>

namespace billiards::client {

inline constexpr double kPowerStep = 0.01;
inline constexpr double kMaxTipOffset = 0.5;  ///< In ball radii, as the engine has it.
inline constexpr double kMaxElevation_rad =
    1.4835299;  ///< 85 degrees: the cue stays off the cloth.
/// A pull shorter than this is a change of mind, not a shot.
inline constexpr double kLeastPull_m = 0.02;

/// The numbers of the shot stay what the engine accepts, whatever the hands do.
class ShotControl {
  public:
    const model::Shot& shot() const { return shot_; }

    /// Points the cue from the cue ball towards `point_m`; a point on the ball's centre says
    /// nothing. The aim is locked while the cue is pulled back.
    void aim_at(base::Vec2 cue_ball_m, base::Vec2 point_m);
    void set_angle(double angle_rad);
    void turn(double by_rad) { set_angle(shot_.angle_rad + by_rad); }

    /// Kept within [kPowerStep, 1].
    void set_power(double power);
    void step_power(int steps) { set_power(shot_.power + steps * kPowerStep); }

    /// In ball radii, left and up as the shooter sees them; kept within kMaxTipOffset.
    void set_tip(base::Vec2 left_up);
    void move_tip(base::Vec2 by) { set_tip(base::Vec2{shot_.tip_left, shot_.tip_up} + by); }
    /// Kept within [0, kMaxElevation_rad].
    void set_elevation(double elevation_rad);

    /// Takes hold of the cue; pull_to says how far it is back, at most one metre.
    void begin_pull() { pulled_m_ = 0.0; }
    void pull_to(double back_m);
    void cancel_pull() { pulled_m_.reset(); }
    /// Lets the cue go: the shot with the power of the pull, which stays the set power; none where
    /// it was not pulled, or not far enough.
    std::optional<model::Shot> release();
    bool is_pulled() const { return pulled_m_.has_value(); }
    /// How far the tip is drawn back, for the eye: the pull, or else as the power is set.
    double drawn_back_m() const { return pulled_m_.value_or(shot_.power); }

    /// What is said before the shot; it holds for one shot.
    const model::Call& call() const { return call_; }
    void set_call(const model::Call& call) { call_ = call; }

    /// A new turn: centre hit, level cue, nothing called. Angle and power stay as they were.
    void start_turn();

  private:
    model::Shot shot_;
    model::Call call_;
    std::optional<double> pulled_m_;
};

}  // namespace billiards::client
