// Gives the constants of cloth, balls, cushions and cue, each with where it comes from.
#pragma once

#include <cstdint>

namespace billiards::physics {

enum class BallBallModel : std::uint8_t {
    Frictional,  ///< Normal impulse with restitution, Coulomb friction mu(s): Alciatore TP A-14.
    Elastic,     ///< Normal parts of the velocities are exchanged, nothing else.
};

enum class CushionModel : std::uint8_t {
    Han2005,       ///< Han, "Dynamics in carom and three cushion billiards", JMST 19 (2005).
    Mathavan2010,  ///< Friction at nose and slate, integrated: cushion_mathavan.h.
    Stronge,       ///< Normal and tangential springs: cushion_stronge.h.
    Mirror,        ///< Reflect, then scale the speed by the restitution.
};

/// Sources: A = Alciatore, "Physical properties of balls, cushions and cloth"
/// (billiards.colostate.edu); W = WPA Equipment Specifications; O = the original gl-billiards
/// design, equation 3.
struct Parameters {
    double gravity_mps2 = 9.81;
    double sliding_friction = 0.2;           ///< A; 0.15 - 0.4.
    double rolling_friction = 0.01;          ///< A; 0.005 - 0.015.
    double spin_deceleration_radps2 = 10.9;  ///< A; about the vertical axis, 5 - 15.
    BallBallModel ball_ball = BallBallModel::Frictional;
    double ball_ball_restitution = 0.95;  ///< A; 0.92 - 0.98.
    /// mu(s) = base + scale exp(-decay s), s the slip speed of the contact point: TP A-14.
    double ball_friction_base = 0.009951;
    double ball_friction_scale = 0.108;
    double ball_friction_decay_spm = 1.088;
    CushionModel cushion = CushionModel::Han2005;
    double cushion_restitution = 0.85;       ///< A; 0.6 - 0.9.
    double cushion_friction = 0.2;           ///< Han 2005.
    double ball_table_restitution = 0.5;     ///< A.
    double cue_mass_kg = 0.567;              ///< 20 oz.
    double cue_end_mass_ratio = 1.0 / 30.0;  ///< Effective end mass over ball mass: TP A-31.
    double cue_spring_npm = 200.0;           ///< O.
    double cue_contact_time_s = 0.01;        ///< O.
    /// No spin at all: a ball rolls from the first instant, its spin is for the eye and carries no
    /// energy, and a strike ignores tip offset and elevation (O).
    bool rolls_at_once = false;
    double stop_speed_mps = 0.0;  ///< A rolling ball that has slowed down to this rests (O).

    friend bool operator==(const Parameters&, const Parameters&) = default;
};

/// The defaults: what balls, cushions and cloth are measured to do.
Parameters realistic_parameters();

/// The original gl-billiards design as a preset of the same engine: equal exchange between balls,
/// mirror cushions that keep 0.7 of the speed, no spin, a glide slowed by 0.017 g that ends at
/// 1 cm/s.
Parameters classic_parameters();

}  // namespace billiards::physics
