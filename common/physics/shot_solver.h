// Takes valid balls on a valid table; gives the record of their motion, event by event.
#pragma once

#include "common/physics/agenda.h"
#include "common/physics/cluster.h"
#include "common/physics/island.h"
#include "common/physics/mover.h"
#include "common/physics/parameters.h"
#include "common/physics/recorder.h"
#include "common/physics/simulate.h"
#include "common/physics/table_shape.h"
#include "common/physics/watch.h"

#include <optional>
#include <span>
#include <vector>

namespace billiards::physics {

/// Solves one shot: find the earliest event, resolve it, plan the balls that it touched, repeat.
class ShotSolver {
  public:
    /// Everything valid; balls in ascending number.
    ShotSolver(const model::TableSpec& table, const Parameters& parameters,
               std::span<const BallStart> balls, Diagnostics* diagnostics);

    /// Balls that take no part are named in the record as they are. Call it once.
    Result<timeline::ShotRecord> solve(std::span<const model::PlacedBall> absent);

  private:
    void happen(const Agenda::Entry& entry);
    void end_motion(int ball);
    void land(int ball);
    void collide(int ball, const Next& met);
    double floor_mps() const;
    Resting resting() const;
    double lost_energy_j() const;
    void record_contact(const Contact& contact);
    bool is_leaning(const Mover& mover, FixedIndex fixed) const;
    bool has_left(const Mover& mover, FixedIndex fixed) const;
    void lean(const Contact& contact);
    void look_again(const Contact& contact);
    void remove(int ball, model::Motion motion);
    void set_state(int ball, const model::BallState& state);
    bool is_on_rail(const base::Vec3& position, double radius_m) const;
    std::optional<int> pocket_at(const base::Vec3& position) const;
    Mover& mover(int ball) { return movers_[static_cast<std::size_t>(ball)]; }

    const Parameters& parameters_;
    TableShape shape_;
    std::optional<double> head_string_m_;
    std::vector<Mover> movers_;
    Agenda agenda_;
    Cluster cluster_;
    IslandSolver islands_;
    std::optional<Recorder> recorder_;
    std::optional<Watch> watch_;

    double now_s_ = 0.0;
    double before_s_ = 0.0;  ///< The latest earlier instant at which something happened.
    int events_ = 0;
    std::vector<int> changed_;
};

}  // namespace billiards::physics
