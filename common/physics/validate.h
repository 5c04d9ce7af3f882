// Takes what a shot starts from; gives what is wrong with it, by name.
#pragma once

#include "common/model/shot.h"
#include "common/model/table_spec.h"
#include "common/physics/parameters.h"
#include "common/physics/simulate.h"

#include <span>

namespace billiards::physics {

/// How far bodies may overlap when a shot starts; they count as touching. A micrometre, and what
/// rounding may add to one in a ball's coordinates.
inline constexpr double kMostOverlap_m = 1e-6 + 1e-12;

// What lies beyond these is no game of billiards, and would strain the numbers of the engine.
inline constexpr double kMostPosition_m = 100.0;
inline constexpr double kMostSpeed_mps = 100.0;
inline constexpr double kMostSpin_radps = 10'000.0;
/// Of cushions, of jaws and of pockets, each; the named tables have 18, 12 and 6.
inline constexpr std::size_t kMostParts = 64;
inline constexpr double kMostAngle_rad = 1000.0;  ///< Beyond it the sine's error grows.
inline constexpr double kMostOffset = 0.5;        ///< Further from the centre the tip slips off.
inline constexpr double kLeastRadius_m = 0.001;
inline constexpr double kMostRadius_m = 1.0;
inline constexpr double kLeastMass_kg = 0.001;
inline constexpr double kMostMass_kg = 100.0;

double largest_radius_m(std::span<const BallStart> balls);

Result<base::Done> validate(const Parameters& parameters);
/// A table with bed marks has cushions; an open one has neither.
Result<base::Done> validate(const model::TableSpec& table);
/// Numbers, ids, overlaps and places; the table and the parameters must be valid.
Result<base::Done> validate(const model::TableSpec& table, std::span<const BallStart> balls);

}  // namespace billiards::physics
