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

/// A name, or cushions, jaws and pockets; such a table ends 0.2 m outside its cushions' bounding
/// box. Without a nose height it has that of the named tables for balls of this size.
model::TableSpec read_table(const JsonNode& node, const model::BallSpec& ball);

std::vector<physics::BallStart> read_balls(const JsonNode& node, const BallNames& names,
                                           const model::BallSpec& usual);

model::Shot read_shot(const JsonNode& node);

/// The engine's refusal in the words of the case: which field, and what about it.
void report(const physics::Error& error, const BallNames& names, Fault& fault);

}  // namespace billiards::tools
