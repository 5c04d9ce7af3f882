// Takes bodies and their contacts at one instant; gives the bodies after generalized reflections.
#include "common/physics/island.h"

#include "common/physics/collide_cushion.h"
#include "common/physics/detect.h"
#include "common/physics/motion.h"
#include "common/physics/order_free_sum.h"
#include "common/physics/validate.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace billiards::physics {

namespace {

using base::Vec3;

/// As many contacts as there can be at once, even on a table that has every part many times in one
/// place: each pair of balls, and each ball with every cushion, both its ends and every jaw.
constexpr std::size_t kMostTerms =
    model::kMaxBalls * (model::kMaxBalls - 1) / 2 + model::kMaxBalls * 4 * kMostParts;

bool is_fixed(const Contact& contact) {
    return contact.b == Contact::kFixed;
}

template <class Bodies>
auto& body_at(Bodies& bodies, int index) {
    return bodies[static_cast<std::size_t>(index)];
}

double restitution_of(const Parameters& parameters, const Contact& contact) {
    return is_fixed(contact) ? parameters.cushion_restitution : ball_ball_restitution(parameters);
}

/// +1 where an impulse along the normal pushes the body, -1 where against it, 0 where not at all.
double sign_at(const Contact& contact, int body) {
    if (contact.a == body) return -1.0;
    return contact.b == body ? 1.0 : 0.0;
}

/// How much closing speed at contact i an impulse at contact j takes through this body.
double coupling(std::span<const Body> bodies, const Contact& i, const Contact& j, int body) {
    if (body == Contact::kFixed) return 0.0;
    const double signs = sign_at(i, body) * sign_at(j, body);
    if (signs == 0.0) return 0.0;
    const Body& moved = body_at(bodies, body);
    return signs * glm::dot(i.normal, as_free(moved, j.normal)) * moved.inverse_mass_pkg();
}

/// A spin that is only drawn must not push: it has no energy to give.
void forget_spins(std::span<Body> bodies) {
    for (Body& body : bodies) body.state.spin_radps = {};
}

double energy_of(const Parameters& parameters, std::span<const Body> bodies) {
    std::array<double, model::kMaxBalls> energies{};
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        energies[i] = energy_j(parameters, bodies[i].spec, bodies[i].state);
    }
    return order_free_sum(std::span(energies).first(bodies.size()));
}

}  // namespace

double closing_speed_mps(std::span<const Body> bodies, const Contact& contact) {
    const Vec3& a = body_at(bodies, contact.a).state.velocity_mps;
    if (is_fixed(contact)) return glm::dot(a, contact.normal);
    return glm::dot(a - body_at(bodies, contact.b).state.velocity_mps, contact.normal);
}

int IslandSolver::solve(std::span<Body> bodies, std::span<Contact> contacts, const Resting& resting,
                        int max_rounds) {
    int rounds = 0;
    Resting still_resting = resting;
    while (rounds < max_rounds && find_closing(bodies, contacts)) {
        ++rounds;
        if (parameters_.rolls_at_once) forget_spins(bodies);
        find_impulses(bodies, contacts);
        if (is_slow(contacts, resting.floor_mps)) {
            part_slowly(bodies, contacts, still_resting);
        } else {
            reflect(bodies, contacts);
        }
        still_resting = {.floor_mps = resting.floor_mps};
    }
    return rounds;
}

bool IslandSolver::find_closing(std::span<const Body> bodies, std::span<Contact> contacts) {
    closing_.clear();
    speeds_.clear();
    for (std::size_t i = 0; i < contacts.size(); ++i) {
        const double speed = closing_speed_mps(bodies, contacts[i]);
        if (speed <= kClosing_mps) continue;
        closing_.push_back(i);
        speeds_.push_back(speed);
        contacts[i].has_struck = true;
    }
    return !closing_.empty();
}

void IslandSolver::find_impulses(std::span<const Body> bodies, std::span<const Contact> contacts) {
    const std::size_t count = closing_.size();
    mobility_.assign(count * count, 0.0);
    for (std::size_t i = 0; i < count; ++i) {
        for (std::size_t j = 0; j < count; ++j) {
            const Contact& at = contacts[closing_[i]];
            const Contact& from = contacts[closing_[j]];
            mobility_[i * count + j] =
                coupling(bodies, at, from, at.a) + coupling(bodies, at, from, at.b);
        }
    }
    if (count == 1) {
        impulses_.assign(1, speeds_[0] / mobility_[0]);
        return;
    }
    const std::span<const double> solved = stopping_.solve(speeds_, mobility_);
    impulses_.assign(solved.begin(), solved.end());
}

bool IslandSolver::is_slow(std::span<const Contact> contacts, double floor_mps) const {
    for (std::size_t i = 0; i < closing_.size(); ++i) {
        const double e = restitution_of(parameters_, contacts[closing_[i]]);
        if (e * speeds_[i] >= floor_mps) return false;
    }
    return true;
}

/// The impulses l that stop the contacts take l c / 2 of energy; (1 + k) l throws them back k times
/// as fast and adds (k^2 - 1) l c / 2. For one pair of equal balls that energy lets them part at
/// sqrt(c^2 + 4 W / m).
void IslandSolver::part_slowly(std::span<Body> bodies, std::span<const Contact> contacts,
                               const Resting& resting) {
    std::array<double, kMostTerms> terms;
    for (std::size_t i = 0; i < closing_.size(); ++i) terms[i] = impulses_[i] * speeds_[i];
    const double taken = order_free_sum(std::span(terms).first(closing_.size()));
    const double fastest = *std::max_element(speeds_.begin(), speeds_.end());
    const double paid_for =
        resting.is_pressed ? std::sqrt(1.0 + 2.0 * resting.lost_energy_j / taken) : 1.0;
    reflect_plainly(bodies, contacts, 1.0 + std::min(resting.floor_mps / fastest, paid_for));
}

/// Each model of a collision loses energy alone. Several at once can add some through each other's
/// friction; then they go without it.
void IslandSolver::reflect(std::span<Body> bodies, std::span<const Contact> contacts) {
    const bool is_alone = closing_.size() == 1;
    if (!is_alone) before_.assign(bodies.begin(), bodies.end());
    changes_.clear();
    for (std::size_t i = 0; i < closing_.size(); ++i) {
        const Contact& contact = contacts[closing_[i]];
        if (is_fixed(contact)) {
            add_cushion(bodies, contact, impulses_[i]);
        } else {
            add_normal(bodies, contact, (1.0 + ball_ball_restitution(parameters_)) * impulses_[i]);
        }
    }
    apply_changes(bodies);
    if (parameters_.ball_ball == BallBallModel::Frictional) {
        changes_.clear();
        add_friction(bodies, contacts);
        apply_changes(bodies);
    }
    if (is_alone || energy_of(parameters_, bodies) <= energy_of(parameters_, before_)) return;
    std::copy(before_.begin(), before_.end(), bodies.begin());
    double e = 1.0;
    for (const std::size_t i : closing_) e = std::min(e, restitution_of(parameters_, contacts[i]));
    reflect_plainly(bodies, contacts, 1.0 + e);
}

void IslandSolver::reflect_plainly(std::span<Body> bodies, std::span<const Contact> contacts,
                                   double factor) {
    changes_.clear();
    for (std::size_t i = 0; i < closing_.size(); ++i) {
        add_normal(bodies, contacts[closing_[i]], factor * impulses_[i]);
    }
    apply_changes(bodies);
}

void IslandSolver::add_normal(std::span<const Body> bodies, const Contact& contact,
                              double impulse_ns) {
    const Body& a = body_at(bodies, contact.a);
    const Vec3 impulse = impulse_ns * contact.normal;
    changes_.push_back({contact.a, {as_free(a, -impulse) * a.inverse_mass_pkg(), {}}});
    if (is_fixed(contact)) return;
    const Body& b = body_at(bodies, contact.b);
    changes_.push_back({contact.b, {as_free(b, impulse) * b.inverse_mass_pkg(), {}}});
}

void IslandSolver::add_cushion(std::span<const Body> bodies, const Contact& contact,
                               double impulse_ns) {
    const Body& ball = body_at(bodies, contact.a);
    const NoseContact nose{.into = contact.into,
                           .lean_sine = contact.lean_sine,
                           .closing_mps = impulse_ns * ball.inverse_mass_pkg()};
    changes_.push_back({contact.a, cushion_kick(parameters_, ball, nose)});
}

void IslandSolver::add_friction(std::span<const Body> bodies, std::span<const Contact> contacts) {
    const double factor = 1.0 + ball_ball_restitution(parameters_);
    for (std::size_t i = 0; i < closing_.size(); ++i) {
        const Contact& contact = contacts[closing_[i]];
        if (is_fixed(contact)) continue;
        const PairKick kick =
            friction_kick(parameters_, body_at(bodies, contact.a), body_at(bodies, contact.b),
                          contact.normal, factor * impulses_[i], busier_of(contact, contacts));
        changes_.push_back({contact.a, kick.a});
        changes_.push_back({contact.b, kick.b});
    }
}

/// Closing contacts of whichever of the two balls has more of them.
int IslandSolver::busier_of(const Contact& contact, std::span<const Contact> contacts) const {
    int of_a = 0;
    int of_b = 0;
    for (const std::size_t i : closing_) {
        if (is_fixed(contacts[i])) continue;
        if (sign_at(contacts[i], contact.a) != 0.0) ++of_a;
        if (sign_at(contacts[i], contact.b) != 0.0) ++of_b;
    }
    return std::max(of_a, of_b);
}

/// Adds each body's changes in no order.
void IslandSolver::apply_changes(std::span<Body> bodies) {
    if (closing_.size() == 1) {
        for (const Change& change : changes_) {
            body_at(bodies, change.body).state.velocity_mps += change.kick.velocity_mps;
            body_at(bodies, change.body).state.spin_radps += change.kick.spin_radps;
        }
        return;
    }
    std::array<std::array<double, kMostTerms>, 6> terms;
    for (std::size_t body = 0; body < bodies.size(); ++body) {
        std::size_t count = 0;
        for (const Change& change : changes_) {
            if (change.body != static_cast<int>(body)) continue;
            for (int axis = 0; axis < 3; ++axis) {
                terms[static_cast<std::size_t>(axis)][count] = change.kick.velocity_mps[axis];
                terms[static_cast<std::size_t>(axis + 3)][count] = change.kick.spin_radps[axis];
            }
            ++count;
        }
        if (count == 0) continue;
        for (int axis = 0; axis < 3; ++axis) {
            const auto sum = [&](int row) {
                return order_free_sum(std::span(terms[static_cast<std::size_t>(row)]).first(count));
            };
            bodies[body].state.velocity_mps[axis] += sum(axis);
            bodies[body].state.spin_radps[axis] += sum(axis + 3);
        }
    }
}

}  // namespace billiards::physics
