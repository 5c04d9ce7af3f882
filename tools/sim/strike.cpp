// Takes a case of a cue and a ball; gives velocity and spin before the slate acts on them.
#include "tools/sim/strike.h"

#include "common/physics/cue.h"
#include "common/physics/simulate.h"
#include "common/physics/validate.h"
#include "tools/sim/read_setup.h"

namespace billiards::tools {

namespace {

/// Asked for as such, or as the power that implies it.
double read_cue_speed(const JsonNode& input, const PhysicsSetup& setup, model::Shot& shot) {
    const JsonNode speed = input["cue_speed_mps"];
    const JsonNode power = input["power"];
    if (!power.is_written()) return speed.number_in(1e-9, physics::kMostSpeed_mps);
    if (speed.is_written()) power.report("stands beside cue_speed_mps, which says the same");
    shot.power = power.number();
    return physics::cue_speed_mps(setup.parameters, setup.ball, shot.power);
}

}  // namespace

Json strike(const JsonNode& input, Fault& fault) {
    const PhysicsSetup setup = read_physics(input["physics"]);
    model::Shot shot = read_aim(input);
    const double cue_speed = read_cue_speed(input, setup, shot);
    const bool squirt = input["squirt"].truth_or(true);
    if (const auto valid = physics::validate(shot); !valid) report_shot(valid.error(), input);
    if (fault.is_found()) return {};
    const physics::Strike struck =
        physics::strike(setup.parameters, setup.ball, shot, cue_speed, squirt);
    return {{"velocity_mps", json_of(struck.velocity_mps)},
            {"spin_radps", json_of(struck.spin_radps)}};
}

}  // namespace billiards::tools
