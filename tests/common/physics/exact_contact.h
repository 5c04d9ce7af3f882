// Takes the relative motion of two balls as doubles; gives when they meet, in 400 bits by Sturm's
// theorem: nothing of the engine's way is in it.
#pragma once

#include "common/physics/detect.h"

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <optional>
#include <vector>

namespace billiards::physics {

using Exact = boost::multiprecision::number<
    boost::multiprecision::cpp_bin_float<400, boost::multiprecision::digit_base_2>,
    boost::multiprecision::et_off>;

/// Coefficients in ascending degree, none leading ones of which are 0.
using ExactPolynomial = std::vector<Exact>;

Exact value_at(const ExactPolynomial& p, const Exact& t);

/// |d + v t + a t^2 / 2|^2 - distance^2.
ExactPolynomial exact_squared_gap(const Course& difference, double distance_m);

/// The first time in (0, horizon] at which p falls from above 0 to below 0.
std::optional<Exact> exact_descent(const ExactPolynomial& p, const Exact& horizon);

/// The gap at a time, and how fast it grows then.
Exact exact_gap_m(const Course& difference, double distance_m, const Exact& t);
Exact exact_rate_mps(const Course& difference, const Exact& t);

}  // namespace billiards::physics
