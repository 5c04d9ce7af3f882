// Takes bodies that meet; gives them after one collision.
#include "common/physics/collide_alone.h"

namespace billiards::physics {

namespace {

void apply(const Kick& kick, Body& body) {
    body.state.velocity_mps += kick.velocity_mps;
    body.state.spin_radps += kick.spin_radps;
    if (body.is_on_slate) body.state.velocity_mps.z = 0.0;
}

}  // namespace

void collide_alone(const Parameters& parameters, Body& a, Body& b, const base::Vec3& normal) {
    const double closing = glm::dot(a.state.velocity_mps - b.state.velocity_mps, normal);
    if (closing <= 0.0) return;
    const auto give = [&](const Body& body) {
        return glm::dot(normal, as_free(body, normal)) * body.inverse_mass_pkg();
    };
    const double impulse =
        (1.0 + ball_ball_restitution(parameters)) * closing / (give(a) + give(b));
    apply({as_free(a, -impulse * normal) * a.inverse_mass_pkg(), {}}, a);
    apply({as_free(b, impulse * normal) * b.inverse_mass_pkg(), {}}, b);
    if (parameters.ball_ball == BallBallModel::Elastic) return;
    const PairKick kick = friction_kick(parameters, a, b, normal, impulse, 1);
    apply(kick.a, a);
    apply(kick.b, b);
}

void collide_alone(const Parameters& parameters, Body& ball, NoseContact contact) {
    contact.closing_mps = glm::dot(ball.state.velocity_mps, nose_normal(contact, ball.is_on_slate));
    if (contact.closing_mps <= 0.0) return;
    apply(cushion_kick(parameters, ball, contact), ball);
}

}  // namespace billiards::physics
