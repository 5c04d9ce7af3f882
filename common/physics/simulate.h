// Takes a table, a layout and a strike; gives the record of everything that follows, solved once
// and exactly: no tick, no dt, only events.
#pragma once

#include "common/base/result.h"
#include "common/model/ball.h"
#include "common/model/layout.h"
#include "common/model/shot.h"
#include "common/model/table_spec.h"
#include "common/physics/parameters.h"
#include "common/timeline/shot_record.h"

#include <cstdint>
#include <optional>
#include <span>
#include <string>

namespace billiards::physics {

enum class ErrorCode : std::uint8_t {
    NotFinite,      ///< A number is NaN or infinite.
    OutOfRange,     ///< A number is outside what it can mean (power, offset, mass ...).
    TooManyBalls,   ///< More than model::kMaxBalls, or none.
    DuplicateBall,  ///< The same id twice.
    Overlap,        ///< Two balls, or a ball and a cushion, overlap by more than 1e-6 m.
    OutsideTable,
    NoCueBall,   ///< A strike without a cue ball on the table.
    Unsolvable,  ///< More than kMaxEvents events.
};

/// What was wrong; detail names the field, the balls or the number, in plain ASCII.
struct Error {
    ErrorCode code = ErrorCode::OutOfRange;
    std::string detail;

    friend bool operator==(const Error&, const Error&) = default;
};

template <class T>
using Result = base::Result<T, Error>;

/// The hard cap of a shot: it counts events, never wall time.
inline constexpr int kMaxEvents = 20'000;

/// One ball as it starts.
struct BallStart {
    model::BallId ball;
    model::BallSpec spec{};
    base::Vec3 position_m{};
    base::Vec3 velocity_mps{};
    base::Vec3 spin_radps{};
};

/// What only proofs ask for, measured over all events of a shot.
struct Diagnostics {
    /// The largest rise of the total energy from after the events of one instant to after those of
    /// the next.
    double max_energy_rise_j = 0.0;
    /// The smallest gap between two balls at any event; none with one ball. Balls that overlap at
    /// the start count once they have opened.
    std::optional<double> min_gap_m;
};

/// Whether a strike's numbers make sense: power in (0, 1], angle within 1000 rad, offset within
/// 0.5, elevation in [0, pi/2), all finite.
Result<base::Done> validate(const model::Shot& shot);

/// Solves the motion of balls that already move. At most kMaxBalls, unique ids, none overlapping.
/// Deterministic: the same arguments give the same bits on every machine. Diagnostics are filled
/// when asked for, and cost time.
Result<timeline::ShotRecord> simulate(const model::TableSpec& table, const Parameters& parameters,
                                      std::span<const BallStart> balls,
                                      Diagnostics* diagnostics = nullptr);

/// Strikes the cue ball of a layout at rest and solves what follows. The record names every ball
/// of the layout; those not on the table stay as they are.
Result<timeline::ShotRecord> simulate_shot(const model::TableSpec& table,
                                           const Parameters& parameters,
                                           const model::Layout& layout, const model::Shot& shot);

}  // namespace billiards::physics
