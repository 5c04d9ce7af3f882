// Takes a polynomial; gives its first fall through zero, bracketed by the roots of its derivatives
// and polished by safeguarded Newton steps.
#include "common/physics/roots.h"

#include "common/physics/motion.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>

namespace billiards::physics {

namespace {

int degree_of(const Polynomial& p) {
    int degree = 4;
    while (degree > 0 && p.c[static_cast<std::size_t>(degree)] == 0.0) --degree;
    return degree;
}

Polynomial derivative_of(const Polynomial& p) {
    return {{p.c[1], 2.0 * p.c[2], 3.0 * p.c[3], 4.0 * p.c[4], 0.0}};
}

/// No root of p lies beyond 1 + max |c_k / c_n| (Cauchy).
double root_bound(const Polynomial& p) {
    const double leading = std::abs(p.c[static_cast<std::size_t>(degree_of(p))]);
    double largest = 0.0;
    for (const double coefficient : p.c) largest = std::max(largest, std::abs(coefficient));
    return leading > 0.0 ? 1.0 + largest / leading : 1.0;
}

/// A polynomial lies within the hull of its Bernstein coefficients over [0, horizon]: where all
/// of them are above 0, so is it. (Farouki, "The Bernstein polynomial basis", 2012.)
bool stays_above_zero(const Polynomial& p, double horizon) {
    const double a1 = p.c[1] * horizon;
    const double a2 = p.c[2] * horizon * horizon;
    const double a3 = p.c[3] * horizon * horizon * horizon;
    const double a4 = p.c[4] * horizon * horizon * horizon * horizon;
    const double b1 = p.c[0] + a1 / 4.0;
    const double b2 = p.c[0] + a1 / 2.0 + a2 / 6.0;
    const double b3 = p.c[0] + 0.75 * a1 + a2 / 2.0 + a3 / 4.0;
    const double b4 = p.c[0] + a1 + a2 + a3 + a4;
    return p.c[0] > 0.0 && b1 > 0.0 && b2 > 0.0 && b3 > 0.0 && b4 > 0.0;
}

bool is_convex(const Polynomial& p, double horizon) {
    const auto bend = [&](double t) { return p.c[2] + t * (3.0 * p.c[3] + t * 6.0 * p.c[4]); };
    const double turn = -p.c[3] / (4.0 * p.c[4]);
    const bool turns = turn > 0.0 && turn < horizon;
    return bend(0.0) > 0.0 && bend(horizon) > 0.0 && (!turns || bend(turn) > 0.0);
}

/// On a convex polynomial that starts above 0 Newton's steps from the left never pass the first
/// root.
double convex_descent(const Polynomial& p, double horizon) {
    double t = 0.0;
    for (double slope = p.slope(t); slope < 0.0; slope = p.slope(t)) {
        const double step = -p(t) / slope;
        t += step;
        if (t > horizon) return kNever_s;
        if (step <= 1e-15 + 2e-16 * t) return t;
    }
    return kNever_s;
}

/// The root between two times at which p has opposite signs, p(above) > 0 >= p(below); monotone
/// between them. Newton, and a bisection wherever Newton would leave the bracket.
double root_between(const Polynomial& p, double above, double below) {
    constexpr int kMostSteps = 200;
    double t = 0.5 * (above + below);
    for (int step = 0; step < kMostSteps; ++step) {
        const double value = p(t);
        (value > 0.0 ? above : below) = t;
        double next = t - value / p.slope(t);
        const bool is_inside = next >= std::min(above, below) && next <= std::max(above, below);
        if (!is_inside) next = 0.5 * (above + below);
        if (std::abs(next - t) <= 1e-15 + 2e-16 * t) return next;
        t = next;
    }
    return t;
}

/// Roots in (0, horizon), ascending.
class Roots {
  public:
    void add(double root) { roots_[count_++] = root; }
    std::span<const double> all() const { return {roots_.data(), count_}; }

  private:
    std::array<double, 4> roots_{};
    std::size_t count_ = 0;
};

/// c0 + c1 t + c2 t^2 without cancellation: q = -(c1 + sign(c1) sqrt(D)) / 2, roots q/c2 and c0/q.
Roots quadratic_roots(const Polynomial& p, double horizon) {
    Roots roots;
    const double discriminant = p.c[1] * p.c[1] - 4.0 * p.c[0] * p.c[2];
    if (discriminant < 0.0) return roots;
    const double q = -0.5 * (p.c[1] + std::copysign(std::sqrt(discriminant), p.c[1]));
    double first = q != 0.0 ? p.c[0] / q : kNever_s;
    double second = p.c[2] != 0.0 ? q / p.c[2] : kNever_s;
    if (second < first) std::swap(first, second);
    if (first > 0.0 && first < horizon) roots.add(first);
    if (second > 0.0 && second < horizon) roots.add(second);
    return roots;
}

Roots sign_changes(const Polynomial& p, double horizon) {
    if (degree_of(p) <= 2) return quadratic_roots(p, horizon);
    Roots roots;
    double left = 0.0;
    double value_left = p(left);
    const auto visit = [&](double right) {
        const double value_right = p(right);
        if (value_left > 0.0 && value_right <= 0.0) roots.add(root_between(p, left, right));
        if (value_left <= 0.0 && value_right > 0.0) roots.add(root_between(p, right, left));
        left = right;
        value_left = value_right;
    };
    const Roots turns = sign_changes(derivative_of(p), horizon);
    for (const double turn : turns.all()) visit(turn);
    visit(horizon);
    return roots;
}

}  // namespace

double first_descent(const Polynomial& p, double horizon) {
    if (!std::isfinite(horizon)) horizon = root_bound(p);
    if (stays_above_zero(p, horizon)) return kNever_s;
    if (p.c[0] > 0.0 && is_convex(p, horizon)) return convex_descent(p, horizon);
    double left = 0.0;
    double value_left = p(left);
    const auto falls_before = [&](double right) {
        const double value_right = p(right);
        if (value_left > 0.0 && value_right <= 0.0) return true;
        left = right;
        value_left = value_right;
        return false;
    };
    const Roots turns = sign_changes(derivative_of(p), horizon);
    for (const double turn : turns.all()) {
        if (falls_before(turn)) return root_between(p, left, turn);
    }
    return falls_before(horizon) ? root_between(p, left, horizon) : kNever_s;
}

}  // namespace billiards::physics
