// Takes balls that meet each other or a cushion; gives them after it, by the model alone.
#include "tools/sim/collide.h"

#include "common/physics/collide_alone.h"
#include "common/physics/validate.h"
#include "tools/sim/read_setup.h"
#include "tools/sim/words.h"

#include <cmath>

namespace billiards::tools {

namespace {

using base::Vec2;
using base::Vec3;

constexpr double kMostNormal = 1e6;

void expect_within(const JsonNode& node, const Vec3& value, double most) {
    for (int axis = 0; axis < 3; ++axis) node.expect_within(value[axis], -most, most);
}

Vec3 read_vector(const JsonNode& node, double most) {
    const Vec3 value = node.triple_or({});
    expect_within(node, value, most);
    return value;
}

/// At the height of the slate, or lower, a ball that does not jump is on it.
physics::Body read_body(const JsonNode& node, const model::BallSpec& usual) {
    physics::Body body;
    body.spec = read_spec(node["radius_m"], node["mass_kg"], usual);
    body.state.position_m = node["position_m"].triple(body.spec.radius_m);
    expect_within(node["position_m"], body.state.position_m, physics::kMostPosition_m);
    body.state.velocity_mps = read_vector(node["velocity_mps"], physics::kMostSpeed_mps);
    body.state.spin_radps = read_vector(node["spin_radps"], physics::kMostSpin_radps);
    const double height = body.state.position_m.z - body.spec.radius_m;
    body.is_on_slate = height <= physics::kMostOverlap_m && body.state.velocity_mps.z <= 0.0;
    return body;
}

Json state_of(const physics::Body& body) {
    return {{"position_m", json_of(body.state.position_m)},
            {"velocity_mps", json_of(body.state.velocity_mps)},
            {"spin_radps", json_of(body.state.spin_radps)}};
}

/// However far apart they are, they meet along the line of their centres.
Json collide_balls(const JsonNode& input, PhysicsSetup& setup, Fault& fault) {
    physics::Parameters& parameters = setup.parameters;
    parameters.ball_ball = read_word_or(input["model"], parameters.ball_ball);
    physics::Body a = read_body(input["a"], setup.ball);
    physics::Body b = read_body(input["b"], setup.ball);
    const Vec3 offset = b.state.position_m - a.state.position_m;
    const double distance = std::sqrt(glm::dot(offset, offset));
    if (!(distance > 0.0)) input["b"]["position_m"].report("is where a is");
    if (fault.is_found()) return {};
    physics::collide_alone(parameters, a, b, offset / distance);
    return {{"a", state_of(a)}, {"b", state_of(b)}};
}

/// A ball in the air that passes over the nose, or below it, goes on as it was.
Json collide_with_cushion(const JsonNode& input, PhysicsSetup& setup, Fault& fault) {
    physics::Parameters& parameters = setup.parameters;
    parameters.cushion = read_word_or(input["model"], parameters.cushion);
    physics::Body ball = read_body(input["ball"], setup.ball);
    const Vec2 normal = input["normal"].pair();
    expect_within(input["normal"], {normal, 0.0}, kMostNormal);
    const double length = std::sqrt(glm::dot(normal, normal));
    if (!(length > 0.0)) input["normal"].report("must point from the cushion to the table");
    const double radius = ball.spec.radius_m;
    const double height = ball.is_on_slate ? radius : ball.state.position_m.z;
    const double lean = (read_nose_height(input, radius) - height) / radius;
    const bool meets = lean > -1.0 && lean < 1.0;
    if (!meets && ball.is_on_slate) input["nose_height_m"].report("is out of range");
    if (fault.is_found()) return {};
    if (meets) {
        physics::collide_alone(parameters, ball, {.into = -normal / length, .lean_sine = lean});
    }
    return {{"ball", state_of(ball)}};
}

}  // namespace

Json collide(const JsonNode& input, Fault& fault) {
    PhysicsSetup setup = read_physics(input["physics"]);
    const bool is_between_balls = input["kind"].one_of({"ball-ball", "cushion"}) == 0;
    if (fault.is_found()) return {};
    return is_between_balls ? collide_balls(input, setup, fault)
                            : collide_with_cushion(input, setup, fault);
}

}  // namespace billiards::tools
