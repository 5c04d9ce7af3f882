// Takes the fields of a case; gives the table, the physics and the balls that they describe.
#pragma once

#include "common/model/shot.h"
#include "common/model/table_spec.h"
#include "common/physics/parameters.h"
#include "common/physics/simulate.h"
#include "tools/sim/ball_names.h"
#include "tools/sim/json_node.h"

#include <string>
#include <vector>

namespace billiards::tools {

struct PhysicsSetup {
    physics::Parameters parameters;
    model::BallSpec ball;  ///< Of a ball that does not say otherwise.
};

PhysicsSetup read_physics(const JsonNode& node);
model::BallSpec read_spec(const JsonNode& radius, const JsonNode& mass,
                          const model::BallSpec& usual);
/// The field nose_height_m of `node`; without it that of the named tables for balls of this size.
double read_nose_height(const JsonNode& node, double radius_m);

/// A name, or cushions, jaws and pockets; such a table ends 0.2 m outside its cushions' bounding
/// box. A table of one's own has cushions; one without any goes by the name of "open".
model::TableSpec read_table(const JsonNode& node, const model::BallSpec& ball);

std::vector<physics::BallStart> read_balls(const JsonNode& node, const BallNames& names,
                                           const model::BallSpec& usual);

/// Where the cue points and hits; the power stays as it was made.
model::Shot read_aim(const JsonNode& node);
model::Shot read_shot(const JsonNode& node);

// The engine's refusals in the words of the case: which field, and what about it.
void report_shot(const physics::Error& error, const JsonNode& node);
void report(const physics::Error& error, const BallNames& names, Fault& fault);

}  // namespace billiards::tools
