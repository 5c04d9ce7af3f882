// Takes a relative motion; gives the time of meeting by counting roots.
#include "tests/common/physics/exact_contact.h"

#include <array>

namespace billiards::physics {

namespace {

void drop_zeros(ExactPolynomial& p) {
    while (!p.empty() && p.back() == 0) p.pop_back();
}

ExactPolynomial derivative_of(const ExactPolynomial& p) {
    ExactPolynomial derivative;
    for (std::size_t k = 1; k < p.size(); ++k) derivative.push_back(p[k] * k);
    return derivative;
}

ExactPolynomial negated_remainder(ExactPolynomial p, const ExactPolynomial& divisor) {
    // What cancels to less than this of what it came from is 0: a multiple root.
    const Exact rounding = ldexp(Exact(1), -300);
    while (p.size() >= divisor.size()) {
        const Exact factor = p.back() / divisor.back();
        const std::size_t shift = p.size() - divisor.size();
        for (std::size_t k = 0; k < divisor.size(); ++k) {
            const Exact taken = factor * divisor[k];
            const Exact scale = abs(p[k + shift]) + abs(taken);
            p[k + shift] -= taken;
            if (abs(p[k + shift]) <= rounding * scale) p[k + shift] = 0;
        }
        p.pop_back();
    }
    drop_zeros(p);
    for (Exact& coefficient : p) coefficient = -coefficient;
    return p;
}

/// p, p', and each the negated remainder of the two before: the changes of sign along it at a less
/// those at b are the roots in (a, b].
class SturmChain {
  public:
    explicit SturmChain(const ExactPolynomial& p) : chain_{p, derivative_of(p)} {
        while (chain_.back().size() > 1) {
            auto next = negated_remainder(chain_[chain_.size() - 2], chain_.back());
            if (next.empty()) break;
            chain_.push_back(std::move(next));
        }
    }

    int roots(const Exact& a, const Exact& b) const { return changes_at(a) - changes_at(b); }

  private:
    int changes_at(const Exact& t) const {
        int changes = 0;
        int sign = 0;
        for (const ExactPolynomial& p : chain_) {
            const int next = value_at(p, t).sign();
            if (next != 0 && sign != 0 && next != sign) ++changes;
            if (next != 0) sign = next;
        }
        return changes;
    }

    std::vector<ExactPolynomial> chain_;
};

/// Of an interval with roots in it, the first part that has just one.
std::array<Exact, 2> first_alone(const SturmChain& chain, Exact a, Exact b) {
    for (int halving = 0; chain.roots(a, b) > 1 && halving < 350; ++halving) {
        const Exact middle = (a + b) / 2;
        (chain.roots(a, middle) > 0 ? b : a) = middle;
    }
    return {a, b};
}

}  // namespace

Exact value_at(const ExactPolynomial& p, const Exact& t) {
    Exact value = 0;
    for (std::size_t k = p.size(); k > 0; --k) value = value * t + p[k - 1];
    return value;
}

ExactPolynomial exact_squared_gap(const Course& difference, double distance_m) {
    ExactPolynomial p(5, Exact(0));
    for (int axis = 0; axis < 3; ++axis) {
        const Exact d = difference.position_m[axis];
        const Exact v = difference.velocity_mps[axis];
        const Exact half_a = Exact(difference.acceleration_mps2[axis]) / 2;
        p[0] += d * d;
        p[1] += 2 * d * v;
        p[2] += v * v + 2 * d * half_a;
        p[3] += 2 * v * half_a;
        p[4] += half_a * half_a;
    }
    p[0] -= Exact(distance_m) * distance_m;
    drop_zeros(p);
    return p;
}

std::optional<Exact> exact_descent(const ExactPolynomial& p, const Exact& horizon) {
    if (p.size() < 2) return {};
    const SturmChain chain(p);
    Exact left = 0;
    while (chain.roots(left, horizon) > 0) {
        auto [a, b] = first_alone(chain, left, horizon);
        left = b;
        // A root at the very start is no fall from above; one that only touches 0 is none either.
        if (value_at(p, a) <= 0 || value_at(p, b) >= 0) continue;
        for (int halving = 0; halving < 200; ++halving) {
            const Exact middle = (a + b) / 2;
            (value_at(p, middle) > 0 ? a : b) = middle;
        }
        return b;
    }
    return {};
}

Exact exact_gap_m(const Course& difference, double distance_m, const Exact& t) {
    return sqrt(value_at(exact_squared_gap(difference, distance_m), t) +
                Exact(distance_m) * distance_m) -
           Exact(distance_m);
}

Exact exact_rate_mps(const Course& difference, const Exact& t) {
    const ExactPolynomial squared = exact_squared_gap(difference, 0.0);
    return value_at(derivative_of(squared), t) / (2 * sqrt(value_at(squared, t)));
}

}  // namespace billiards::physics
