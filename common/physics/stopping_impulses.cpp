// Takes the closing speeds of simultaneous contacts; gives the impulses that stop them: conjugate
// gradients on the contacts that press, those that would pull left out.
#include "common/physics/stopping_impulses.h"

#include "common/physics/order_free_sum.h"

#include <algorithm>
#include <cmath>

namespace billiards::physics {

namespace {

/// Relative to the largest closing speed: what is smaller is rounding.
constexpr double kAccuracy = 1e-14;

}  // namespace

std::span<const double> StoppingImpulses::solve(std::span<const double> closing_mps,
                                                std::span<const double> mobility) {
    const std::size_t count = closing_mps.size();
    closing_ = closing_mps;
    mobility_ = mobility;
    is_active_.assign(count, 1);
    impulse_.assign(count, 0.0);
    // Each revision changes who presses; a few always suffice, and the scaling below makes the
    // result safe where they do not.
    for (std::size_t revision = 0; revision < count + 4; ++revision) {
        solve_active();
        if (!revise_active()) return impulse_;
    }
    scale_to_best();
    return impulse_;
}

/// Conjugate gradients (Hestenes, Stiefel 1952) for A l = c over the active contacts, from l = 0.
/// With c in the range of A a singular A does no harm.
void StoppingImpulses::solve_active() {
    const std::size_t count = closing_.size();
    impulse_.assign(count, 0.0);
    residual_.assign(count, 0.0);
    mapped_.assign(count, 0.0);
    for (std::size_t i = 0; i < count; ++i) residual_[i] = is_active_[i] ? closing_[i] : 0.0;
    direction_ = residual_;
    double squared = dot(residual_, residual_);
    const double enough = squared * kAccuracy * kAccuracy;
    for (std::size_t step = 0; step < 2 * count + 4 && squared > enough; ++step) {
        for (std::size_t i = 0; i < count; ++i) {
            mapped_[i] = is_active_[i] ? row_times(i, direction_) : 0.0;
        }
        const double curvature = dot(direction_, mapped_);
        if (curvature <= 0.0) return;
        const double length = squared / curvature;
        for (std::size_t i = 0; i < count; ++i) {
            impulse_[i] += length * direction_[i];
            residual_[i] -= length * mapped_[i];
        }
        const double before = squared;
        squared = dot(residual_, residual_);
        for (std::size_t i = 0; i < count; ++i) {
            direction_[i] = residual_[i] + (squared / before) * direction_[i];
        }
    }
}

/// Lets go of contacts that pull and takes back those that still close. False: nothing to revise.
bool StoppingImpulses::revise_active() {
    const double largest = *std::max_element(closing_.begin(), closing_.end());
    bool is_revised = false;
    for (std::size_t i = 0; i < closing_.size(); ++i) {
        if (is_active_[i] && impulse_[i] < 0.0) {
            is_active_[i] = 0;
            is_revised = true;
        } else if (!is_active_[i] && closing_[i] - row_times(i, impulse_) > kAccuracy * largest) {
            is_active_[i] = 1;
            is_revised = true;
        }
    }
    return is_revised;
}

/// Any impulses l >= 0 conserve or lose energy at restitution <= 1 when scaled to the least of
/// l A l / 2 - c l: what they miss, the next round of contacts mends.
void StoppingImpulses::scale_to_best() {
    for (double& impulse : impulse_) impulse = std::max(0.0, impulse);
    mapped_.resize(impulse_.size());
    for (std::size_t i = 0; i < impulse_.size(); ++i) mapped_[i] = row_times(i, impulse_);
    const double curvature = dot(impulse_, mapped_);
    if (curvature <= 0.0) return;
    const double scale = dot(impulse_, closing_) / curvature;
    for (double& impulse : impulse_) impulse *= scale;
}

double StoppingImpulses::row_times(std::size_t row, std::span<const double> vector) {
    const std::size_t count = closing_.size();
    return dot(mobility_.subspan(row * count, count), vector);
}

double StoppingImpulses::dot(std::span<const double> a, std::span<const double> b) {
    terms_.clear();
    for (std::size_t i = 0; i < a.size(); ++i) {
        const double term = a[i] * b[i];
        if (term != 0.0) terms_.push_back(term);
    }
    return order_free_sum(terms_);
}

}  // namespace billiards::physics
