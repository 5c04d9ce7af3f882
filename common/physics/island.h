// Takes balls that touch each other, cushions or jaws at one instant; gives them after all their
// contacts, solved together.
#pragma once

#include "common/base/vec.h"
#include "common/physics/collide_ball.h"
#include "common/physics/parameters.h"
#include "common/physics/stopping_impulses.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace billiards::physics {

/// One place where two balls touch, or a ball and something fixed.
struct Contact {
    static constexpr int kFixed = -1;

    int a = 0;                ///< Index of a body.
    int b = kFixed;           ///< Index of another; kFixed: a cushion or jaw.
    base::Vec3 normal{};      ///< Unit vector from a to b; to a cushion as nose_normal gives it.
    base::Vec2 into{};        ///< Fixed only: horizontal unit vector to the cushion.
    double lean_sine = 0.0;   ///< Fixed only.
    std::uint16_t fixed = 0;  ///< Fixed only: which, in the caller's numbering.
    bool has_struck = false;  ///< Out: an impulse passed here.
};

/// Restitution times closing speed under this is slow.
inline constexpr double kFloor_mps = 0.005;

/// Energy that the balls of pressed contacts have just lost to the slate: what a bounce may use.
struct Resting {
    bool is_pressed = false;
    double lost_energy_j = 0.0;
    double floor_mps = kFloor_mps;
};

/// Solves islands; keeps its memory from one to the next.
class IslandSolver {
  public:
    explicit IslandSolver(const Parameters& parameters) : parameters_(parameters) {}

    /// Rounds of generalized reflections (Smith et al., "Reflections on simultaneous impact",
    /// SIGGRAPH 2012) until no contact closes: in each, the contacts that close are stopped
    /// together and thrown back by their restitution; friction follows from the one state that
    /// this leaves. Where all close so slowly that restitution times speed is under the floor,
    /// they part without friction, a little faster than they closed where `resting` pays for it,
    /// and never faster than the floor: so a pressed contact bounces by micrometres a few hundred
    /// times a second instead of for ever. Energy never rises beyond what `resting` allows. Returns
    /// the number of rounds, max_rounds at most.
    int solve(std::span<Body> bodies, std::span<Contact> contacts, const Resting& resting,
              int max_rounds);

  private:
    struct Change {
        int body = 0;
        Kick kick;
    };

    bool find_closing(std::span<const Body> bodies, std::span<Contact> contacts);
    void find_impulses(std::span<const Body> bodies, std::span<const Contact> contacts);
    bool is_slow(std::span<const Contact> contacts, double floor_mps) const;
    void part_slowly(std::span<Body> bodies, std::span<const Contact> contacts,
                     const Resting& resting);
    void reflect(std::span<Body> bodies, std::span<const Contact> contacts);
    void reflect_plainly(std::span<Body> bodies, std::span<const Contact> contacts, double factor);
    void add_normal(std::span<const Body> bodies, const Contact& contact, double impulse_ns);
    void add_cushion(std::span<const Body> bodies, const Contact& contact, double impulse_ns);
    void add_friction(std::span<const Body> bodies, std::span<const Contact> contacts);
    int busier_of(const Contact& contact, std::span<const Contact> contacts) const;
    void apply_changes(std::span<Body> bodies);

    const Parameters& parameters_;
    StoppingImpulses stopping_;
    std::vector<std::size_t> closing_;  ///< Indices of contacts.
    std::vector<double> speeds_;        ///< Their closing speeds.
    std::vector<double> mobility_;
    std::vector<double> impulses_;
    std::vector<Change> changes_;
    std::vector<Body> before_;
};

/// How fast a and b, or a and the fixed thing, approach along the contact's normal.
double closing_speed_mps(std::span<const Body> bodies, const Contact& contact);

}  // namespace billiards::physics
