// Takes a polynomial of degree four at most; gives the first time at which it falls through zero.
#pragma once

#include <array>

namespace billiards::physics {

/// c[0] + c[1] t + ... + c[4] t^4.
struct Polynomial {
    std::array<double, 5> c{};

    double operator()(double t) const {
        return c[0] + t * (c[1] + t * (c[2] + t * (c[3] + t * c[4])));
    }
    double slope(double t) const {
        return c[1] + t * (2.0 * c[2] + t * (3.0 * c[3] + t * (4.0 * c[4])));
    }
};

/// The first t in (0, horizon] at which p comes from above 0 to 0 or below; kNever_s where there is
/// none. A polynomial that starts at or below 0 has to rise above it first: this is what "the gap
/// closes" means for two bodies that touch and part. Good to rounding.
double first_descent(const Polynomial& p, double horizon);

}  // namespace billiards::physics
