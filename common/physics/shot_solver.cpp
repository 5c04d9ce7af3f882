// Takes valid balls on a valid table; gives the record of the shot.
#include "common/physics/shot_solver.h"

#include "common/physics/collide_slate.h"
#include "common/physics/detect.h"
#include "common/physics/forecast.h"
#include "common/physics/nearness.h"
#include "common/physics/order_free_sum.h"
#include "common/physics/validate.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <string>
#include <utility>

namespace billiards::physics {

namespace {

using base::Vec2;
using base::Vec3;
using model::BallState;
using model::Motion;
using model::ShotEvent;

/// A ball has left a cushion when their gap was larger than this: more than the bounces of a
/// pressed contact reach (v^2 / 2a = 6.4 micrometres at the floor speed and sliding friction).
constexpr double kLeft_m = 1e-5;

std::size_t at(int index) {
    return static_cast<std::size_t>(index);
}

Mover mover_of(const Parameters& parameters, const BallStart& ball) {
    BallState state{.position_m = ball.position_m,
                    .velocity_mps = ball.velocity_mps,
                    .spin_radps = ball.spin_radps};
    const double height = state.position_m.z - ball.spec.radius_m;
    if (std::abs(height) <= kMostOverlap_m) {
        state.position_m.z = ball.spec.radius_m;
    }
    const bool is_driven_down =
        state.position_m.z == ball.spec.radius_m && ball.velocity_mps.z < 0.0;
    if (is_driven_down) state = landed(parameters, ball.spec.radius_m, state);
    Mover mover;
    mover.id = ball.ball;
    mover.spec = ball.spec;
    mover.plan = plan_motion(parameters, ball.spec.radius_m,
                             settled(parameters, ball.spec.radius_m, state), 0.0);
    return mover;
}

/// The largest gap along `into` from `start` to `end` of a plan, whose gap at the start is known.
double widest_gap_m(const Plan& plan, const Vec2& into, double gap_m, double end_s) {
    const double rate = -glm::dot(into, base::horizontal(plan.segment.velocity_mps));
    const double acceleration = -glm::dot(into, base::horizontal(plan.segment.acceleration_mps2));
    const double length = end_s - plan.segment.start_s;
    double widest = std::max(gap_m, gap_m + (rate + acceleration * (length / 2)) * length);
    const bool turns = rate > 0.0 && rate + acceleration * length < 0.0;
    if (turns) widest = std::max(widest, gap_m - rate * rate / (2 * acceleration));
    return widest;
}

}  // namespace

ShotSolver::ShotSolver(const model::TableSpec& table, const Parameters& parameters,
                       std::span<const BallStart> balls, Diagnostics* diagnostics)
    : parameters_(parameters),
      shape_(table, largest_radius_m(balls)),
      head_string_m_(table.head_string_m),
      islands_(parameters) {
    movers_.reserve(balls.size());
    std::vector<FixedIndex> touching;
    for (const BallStart& ball : balls) {
        Mover& mover = movers_.emplace_back(mover_of(parameters, ball));
        touching.clear();
        add_touching(shape_, mover.plan.segment.position_m, mover.spec.radius_m, touching);
        for (const FixedIndex fixed : touching) mover.leanings.add(fixed);
        foresee_alone(shape_, mover, 0.0);
    }
    recorder_.emplace(movers_);
    for (const BallStart& ball : balls) {
        const bool is_driven_down =
            ball.velocity_mps.z < 0.0 && ball.position_m.z <= ball.spec.radius_m + kMostOverlap_m;
        if (is_driven_down) recorder_->add(ShotEvent::landing(0.0, ball.ball));
    }
    if (diagnostics != nullptr) watch_.emplace(parameters, movers_, *diagnostics);
    changed_.resize(movers_.size());
    std::iota(changed_.begin(), changed_.end(), 0);
    agenda_.update(movers_, changed_, 0.0);
}

Result<timeline::ShotRecord> ShotSolver::solve(std::span<const model::PlacedBall> absent) {
    for (Agenda::Entry entry = agenda_.first(movers_); entry.next.time_s < kNever_s;
         entry = agenda_.first(movers_)) {
        if (entry.next.time_s > now_s_) before_s_ = std::exchange(now_s_, entry.next.time_s);
        changed_.clear();
        happen(entry);
        if (++events_ > kMaxEvents) {
            return Error{ErrorCode::Unsolvable,
                         "more than " + std::to_string(kMaxEvents) + " events"};
        }
        if (watch_) watch_->look(movers_, now_s_);
        for (const int ball : changed_) foresee_alone(shape_, mover(ball), now_s_);
        agenda_.update(movers_, changed_, now_s_);
    }
    return recorder_->finish(now_s_, head_string_m_, absent);
}

void ShotSolver::happen(const Agenda::Entry& entry) {
    switch (entry.next.cause) {
        case Cause::MotionEnd:
            return end_motion(entry.ball);
        case Cause::Ball:
        case Cause::Wall:
        case Cause::Post:
            return collide(entry.ball, entry.next);
        case Cause::Pocket:
            recorder_->add(
                ShotEvent::pocketed(now_s_, mover(entry.ball).id,
                                    model::PocketId{static_cast<std::uint8_t>(entry.next.index)}));
            return remove(entry.ball, Motion::Pocketed);
        case Cause::Edge:
            recorder_->add(ShotEvent::off_table(now_s_, mover(entry.ball).id));
            return remove(entry.ball, Motion::OffTable);
    }
}

void ShotSolver::end_motion(int ball) {
    const Mover& ended = mover(ball);
    if (ended.plan.segment.motion == Motion::Airborne) return land(ball);
    const BallState state = state_at_end(parameters_, ended.spec.radius_m, ended.plan);
    recorder_->add(ShotEvent::motion(now_s_, ended.id, state.motion));
    set_state(ball, state);
}

/// On the slate, in a pocket's mouth, or on a rail or the floor.
void ShotSolver::land(int ball) {
    const Mover& falling = mover(ball);
    const BallState state = state_at_end(parameters_, falling.spec.radius_m, falling.plan);
    if (const std::optional<int> pocket = pocket_at(state.position_m)) {
        recorder_->add(ShotEvent::pocketed(now_s_, falling.id,
                                           model::PocketId{static_cast<std::uint8_t>(*pocket)}));
        return remove(ball, Motion::Pocketed);
    }
    if (is_on_rail(state.position_m, falling.spec.radius_m)) {
        recorder_->add(ShotEvent::off_table(now_s_, falling.id));
        return remove(ball, Motion::OffTable);
    }
    recorder_->add(ShotEvent::landing(now_s_, falling.id));
    set_state(ball, settled(parameters_, falling.spec.radius_m,
                            landed(parameters_, falling.spec.radius_m, state)));
}

void ShotSolver::collide(int ball, const Next& met) {
    cluster_.gather(shape_, movers_, ball, met, now_s_);
    events_ += islands_.solve(cluster_.bodies, cluster_.contacts, resting(), kMaxEvents - events_);
    std::array<bool, model::kMaxBalls> is_struck{};
    for (const Contact& contact : cluster_.contacts) {
        if (!contact.has_struck) continue;
        is_struck[at(contact.a)] = true;
        if (contact.b != Contact::kFixed) is_struck[at(contact.b)] = true;
        record_contact(contact);
    }
    for (std::size_t i = 0; i < cluster_.bodies.size(); ++i) {
        if (!is_struck[i]) continue;
        const Body& body = cluster_.bodies[i];
        set_state(cluster_.members[i], settled(parameters_, body.spec.radius_m, body.state));
    }
    for (const Contact& contact : cluster_.contacts) lean(contact);
    if (!cluster_.contacts[0].has_struck) look_again(cluster_.contacts[0]);
}

/// A long row of balls that a spinning one keeps pressing has too many contacts for each to bounce
/// by micrometres until all rest: the longer a shot goes on, the higher they may.
double ShotSolver::floor_mps() const {
    constexpr int kPatience = 2'500;
    constexpr int kMostDoublings = 4;
    return kFloor_mps * (1 << std::min(events_ / kPatience, kMostDoublings));
}

/// Only a contact that opened so little since the latest event is pressed; one that comes from
/// further away has no claim on energy that was lost on its way.
Resting ShotSolver::resting() const {
    const Contact& trigger = cluster_.contacts[0];
    const bool is_pair = trigger.b != Contact::kFixed;
    const double e = is_pair ? ball_ball_restitution(parameters_) : parameters_.cushion_restitution;
    Resting resting{.floor_mps = floor_mps()};
    if (e * closing_speed_mps(cluster_.bodies, trigger) >= resting.floor_mps) return resting;

    const Mover& a = movers_[at(cluster_.members[at(trigger.a)])];
    double since = std::max(before_s_, a.plan.segment.start_s);
    double gap = 0.0;
    if (is_pair) {
        const Mover& b = movers_[at(cluster_.members[at(trigger.b)])];
        since = std::max(since, b.plan.segment.start_s);
        const Vec3 offset = position_at(b.plan.segment, since) - position_at(a.plan.segment, since);
        gap = std::sqrt(glm::dot(offset, offset)) - a.spec.radius_m - b.spec.radius_m;
    } else {
        const Vec3 position = position_at(a.plan.segment, since);
        gap = nearness(shape_, trigger.fixed, position, a.spec.radius_m).gap_m;
    }
    resting.is_pressed = gap <= kLeft_m;
    if (resting.is_pressed) resting.lost_energy_j = lost_energy_j();
    return resting;
}

/// What the balls of the cluster lost to the slate since the latest earlier instant.
double ShotSolver::lost_energy_j() const {
    std::array<double, model::kMaxBalls> losses{};
    for (std::size_t i = 0; i < cluster_.bodies.size(); ++i) {
        const Mover& mover = movers_[at(cluster_.members[i])];
        const double since = std::max(before_s_, mover.plan.segment.start_s);
        const BallState before = state_at(mover.plan.segment, since);
        losses[i] = std::max(0.0, energy_j(parameters_, mover.spec, before) -
                                      energy_j(parameters_, mover.spec, cluster_.bodies[i].state));
    }
    return order_free_sum(std::span(losses).first(cluster_.bodies.size()));
}

void ShotSolver::record_contact(const Contact& contact) {
    const Mover& a = movers_[at(cluster_.members[at(contact.a)])];
    if (contact.b != Contact::kFixed) {
        const Mover& b = movers_[at(cluster_.members[at(contact.b)])];
        recorder_->add(ShotEvent::ball_ball(now_s_, a.id, b.id));
        return;
    }
    const bool is_held = is_leaning(a, contact.fixed);
    if (is_post(shape_, contact.fixed)) {
        const auto post = static_cast<std::uint16_t>(contact.fixed - shape_.walls.size());
        recorder_->add(ShotEvent::jaw(now_s_, a.id, post, is_held));
    } else {
        recorder_->add(ShotEvent::cushion(now_s_, a.id, contact.fixed, is_held));
    }
}

/// Whether the ball was touching it, or the part of the cushion that runs into it, and has not left
/// that. Only along its present plan: earlier plans were looked at as they ended.
bool ShotSolver::is_leaning(const Mover& mover, FixedIndex fixed) const {
    return std::any_of(mover.leanings.begin(), mover.leanings.end(), [&](FixedIndex touched) {
        return (touched == fixed || adjoin(shape_, touched, fixed)) && !has_left(mover, touched);
    });
}

bool ShotSolver::has_left(const Mover& mover, FixedIndex fixed) const {
    const Vec3& start = mover.plan.segment.position_m;
    const Nearness near = nearness(shape_, fixed, start, mover.spec.radius_m);
    return widest_gap_m(mover.plan, near.into, near.gap_m, now_s_) > kLeft_m;
}

void ShotSolver::lean(const Contact& contact) {
    if (!contact.has_struck || contact.b != Contact::kFixed) return;
    mover(cluster_.members[at(contact.a)]).leanings.add(contact.fixed);
}

/// A graze passes no impulse, and its motion goes on: but it has come, and the next is another.
void ShotSolver::look_again(const Contact& contact) {
    for (const int body : {contact.a, contact.b}) {
        if (body == Contact::kFixed) continue;
        const int ball = cluster_.members[at(body)];
        if (std::find(changed_.begin(), changed_.end(), ball) == changed_.end()) {
            changed_.push_back(ball);
        }
    }
}

void ShotSolver::remove(int ball, Motion motion) {
    Mover& gone = mover(ball);
    const timeline::Segment segment{
        .start_s = now_s_, .position_m = position_at(gone.plan.segment, now_s_), .motion = motion};
    gone.plan = {.segment = segment, .end_s = kNever_s};
    recorder_->add_segment(at(ball), segment);
    changed_.push_back(ball);
}

void ShotSolver::set_state(int ball, const BallState& state) {
    Mover& changing = mover(ball);
    changing.leanings.remove_if([&](FixedIndex fixed) { return has_left(changing, fixed); });
    changing.plan = plan_motion(parameters_, changing.spec.radius_m, state, now_s_);
    recorder_->add_segment(at(ball), changing.plan.segment);
    changed_.push_back(ball);
}

/// Behind a nose, or on a cushion or jaw: a ball that comes down there has left the bed.
bool ShotSolver::is_on_rail(const Vec3& position, double radius_m) const {
    std::vector<FixedIndex> touching;
    add_touching(shape_, position, radius_m, touching);
    return is_behind_nose(shape_, base::horizontal(position)) ||
           std::any_of(touching.begin(), touching.end(), [&](FixedIndex fixed) {
               return nearness(shape_, fixed, position, radius_m).gap_m < -kMostOverlap_m;
           });
}

std::optional<int> ShotSolver::pocket_at(const Vec3& position) const {
    for (std::size_t i = 0; i < shape_.pockets.size(); ++i) {
        const Vec2 offset = base::horizontal(position) - shape_.pockets[i].center_m;
        const double radius = shape_.pockets[i].radius_m;
        if (glm::dot(offset, offset) < radius * radius) return static_cast<int>(i);
    }
    return {};
}

}  // namespace billiards::physics
