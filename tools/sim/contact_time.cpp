// Takes two balls of one size with constant accelerations; gives their next contact.
#include "tools/sim/contact_time.h"

#include "common/physics/detect.h"
#include "common/physics/motion.h"

namespace billiards::tools {

namespace {

/// Beyond it the polynomials of the engine would lose their digits.
constexpr double kMost = 1e6;

base::Vec3 read_vector(const JsonNode& node) {
    const base::Vec2 value = node.pair();
    node.expect_within(value.x, -kMost, kMost);
    node.expect_within(value.y, -kMost, kMost);
    return {value, 0.0};
}

base::Vec3 read_vector_or_zero(const JsonNode& node) {
    return node.is_written() ? read_vector(node) : base::Vec3{};
}

physics::Course read_course(const JsonNode& node) {
    return {.position_m = read_vector(node["p"]),
            .velocity_mps = read_vector_or_zero(node["v"]),
            .acceleration_mps2 = read_vector_or_zero(node["a"])};
}

}  // namespace

Json contact_time(const JsonNode& input, Fault& fault) {
    const double radius = input["radius_m"].number_in(1e-6, kMost);
    const physics::Course a = read_course(input["a"]);
    const physics::Course b = read_course(input["b"]);
    const double horizon = input["horizon_s"].number_in(0.0, kMost);
    if (a.position_m == b.position_m) input["b"]["p"].report("is where a is");
    if (fault.is_found()) return {};
    const physics::Course difference{
        .position_m = b.position_m - a.position_m,
        .velocity_mps = b.velocity_mps - a.velocity_mps,
        .acceleration_mps2 = b.acceleration_mps2 - a.acceleration_mps2};
    const double time = physics::meeting_s(difference, 2.0 * radius, horizon);
    return {{"t", time < physics::kNever_s ? Json(time) : Json(nullptr)}};
}

}  // namespace billiards::tools
