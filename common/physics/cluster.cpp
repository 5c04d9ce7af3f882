// Takes the balls at one instant; gives those that hang together by touching.
#include "common/physics/cluster.h"

#include "common/physics/collide_cushion.h"
#include "common/physics/detect.h"

#include <algorithm>
#include <cmath>

namespace billiards::physics {

namespace {

using base::Vec3;

constexpr double kBoxSlack_m = 1e-9;

std::size_t at(int index) {
    return static_cast<std::size_t>(index);
}

/// From a to b. No ball balances on another: where one stands exactly above the other, it meets it
/// a hair towards the table's centre; so far off its rolling away is a matter of bounces.
Vec3 pair_normal(const Vec3& a, const Vec3& b) {
    constexpr double kHair = 1e-6;
    const Vec3 offset = b - a;
    if (offset.x != 0.0 || offset.y != 0.0) return offset / std::sqrt(glm::dot(offset, offset));
    const double from_centre = std::sqrt(a.x * a.x + a.y * a.y);
    const Vec3 inward = from_centre > 0.0 ? Vec3{-a.x, -a.y, 0.0} / from_centre : Vec3{1, 0, 0};
    const double up = offset.z > 0.0 ? 1.0 : -1.0;
    return {up * kHair * inward.x, up * kHair * inward.y, up};
}

}  // namespace

void Cluster::gather(const TableShape& shape, std::span<const Mover> movers, int mover,
                     const Next& met, double now_s) {
    members.clear();
    bodies.clear();
    contacts.clear();
    const int first = body_of(movers, mover, now_s);
    if (met.cause == Cause::Ball) {
        add_pair(first, body_of(movers, met.index, now_s));
    } else {
        add_fixed(shape, first,
                  met.cause == Cause::Wall ? wall_index(met.index) : post_index(shape, met.index));
    }
    for (int body = 0; body < static_cast<int>(bodies.size()); ++body) {
        look_for_balls(movers, body, now_s);
        look_for_fixed(shape, body);
    }
}

/// Takes the mover in where it is not there yet.
int Cluster::body_of(std::span<const Mover> movers, int mover, double now_s) {
    const auto found = std::find(members.begin(), members.end(), mover);
    if (found != members.end()) return static_cast<int>(found - members.begin());
    const Mover& ball = movers[at(mover)];
    members.push_back(mover);
    bodies.push_back({.spec = ball.spec,
                      .state = state_at(ball.plan.segment, now_s),
                      .is_on_slate = ball.plan.segment.motion != model::Motion::Airborne});
    return static_cast<int>(bodies.size()) - 1;
}

void Cluster::add_pair(int a, int b) {
    contacts.push_back(
        {.a = a,
         .b = b,
         .normal = pair_normal(bodies[at(a)].state.position_m, bodies[at(b)].state.position_m)});
}

void Cluster::add_fixed(const TableShape& shape, int body, FixedIndex fixed) {
    const Body& ball = bodies[at(body)];
    const Nearness near = nearness(shape, fixed, ball.state.position_m, ball.spec.radius_m);
    const NoseContact nose{.into = near.into, .lean_sine = near.lean_sine};
    contacts.push_back({.a = body,
                        .normal = nose_normal(nose, ball.is_on_slate),
                        .into = near.into,
                        .lean_sine = near.lean_sine,
                        .fixed = fixed});
}

/// Parts of a cushion that stop a ball in the same direction, such as two segments in one line
/// where they meet, are one.
bool Cluster::is_stopped_towards(int body, const base::Vec2& into) const {
    constexpr double kSameWay = 1.0 - 1e-12;
    return std::any_of(contacts.begin(), contacts.end(), [&](const Contact& contact) {
        return contact.a == body && contact.b == Contact::kFixed &&
               glm::dot(contact.into, into) > kSameWay;
    });
}

/// Pairs of two bodies that have both been looked at, and the pair that began it, are known.
void Cluster::look_for_balls(std::span<const Mover> movers, int body, double now_s) {
    const Vec3 position = bodies[at(body)].state.position_m;
    const double radius = bodies[at(body)].spec.radius_m;
    Box here;
    here.include(base::horizontal(position));
    for (int other = 0; other < static_cast<int>(movers.size()); ++other) {
        const Mover& mover = movers[at(other)];
        const double distance = radius + mover.spec.radius_m + kTouching_m;
        if (!mover.is_in_play() || !are_near(mover.swept, here, distance + kBoxSlack_m)) continue;
        const Vec3 offset = position_at(mover.plan.segment, now_s) - position;
        if (glm::dot(offset, offset) > distance * distance) continue;
        const auto known = std::find(members.begin(), members.end(), other) - members.begin();
        if (known <= body) continue;
        const bool is_trigger = contacts[0].a == body && contacts[0].b == known;
        if (!is_trigger) add_pair(body, body_of(movers, other, now_s));
    }
}

void Cluster::look_for_fixed(const TableShape& shape, int body) {
    const Body& ball = bodies[at(body)];
    touching_.clear();
    add_touching(shape, ball.state.position_m, ball.spec.radius_m, touching_);
    for (const FixedIndex fixed : touching_) {
        const Nearness near = nearness(shape, fixed, ball.state.position_m, ball.spec.radius_m);
        if (!is_stopped_towards(body, near.into)) add_fixed(shape, body, fixed);
    }
}

}  // namespace billiards::physics
