// Takes a place; gives noise from SplitMix64 on a lattice.
#include "tools/make_assets/noise.h"

#include "common/base/random.h"

#include <cmath>

namespace billiards::make_assets {

namespace {

int wrapped(int cell, int cells) {
    return ((cell % cells) + cells) % cells;
}

double smooth(double t) {
    return t * t * (3.0 - 2.0 * t);
}

double between(double a, double b, double share) {
    return a + (b - a) * share;
}

}  // namespace

double scatter(int x, int y, std::uint64_t seed) {
    const auto cell = static_cast<std::uint64_t>(static_cast<std::uint32_t>(x)) << 32U |
                      static_cast<std::uint32_t>(y);
    base::Random random(cell * 0x9e3779b97f4a7c15U ^ seed);
    random.next();
    return random.uniform(0.0, 1.0);
}

double noise(double u, double v, int cells_u, int cells_v, std::uint64_t seed) {
    const double x = u * cells_u;
    const double y = v * cells_v;
    const int left = static_cast<int>(std::floor(x));
    const int low = static_cast<int>(std::floor(y));
    const auto corner = [&](int right, int up) {
        return scatter(wrapped(left + right, cells_u), wrapped(low + up, cells_v), seed);
    };
    const double across = smooth(x - left);
    return between(between(corner(0, 0), corner(1, 0), across),
                   between(corner(0, 1), corner(1, 1), across), smooth(y - low));
}

double cloudy(double u, double v, int cells_u, int cells_v, int octaves, std::uint64_t seed) {
    double sum = 0.0;
    double all = 0.0;
    double strength = 1.0;
    for (int octave = 0; octave < octaves; ++octave) {
        sum += strength * noise(u, v, cells_u << octave, cells_v << octave,
                                seed + static_cast<std::uint64_t>(octave));
        all += strength;
        strength /= 2;
    }
    return sum / all;
}

}  // namespace billiards::make_assets
