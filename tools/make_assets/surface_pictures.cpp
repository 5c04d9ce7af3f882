// Takes nothing but seeds; gives surfaces made of noise that is stretched along threads and fibres.
#include "tools/make_assets/surface_pictures.h"

#include "common/base/elementary.h"
#include "tools/make_assets/noise.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace billiards::make_assets {

namespace {

constexpr Colour kClothDark{0.048, 0.268, 0.192};
constexpr Colour kClothLight{0.085, 0.376, 0.276};
/// The cushions' cloth is stretched, and a little darker.
constexpr double kStretched = 0.84;
constexpr Colour kWoodDark{0.165, 0.062, 0.030};
constexpr Colour kWoodLight{0.455, 0.205, 0.095};
constexpr Colour kFloorDark{0.150, 0.098, 0.066};
constexpr Colour kFloorLight{0.345, 0.238, 0.160};

double wave(double turns) {
    return 0.5 + 0.5 * base::sine(2 * base::kPi * turns);
}

/// 0 in a fine gap around whole numbers, 1 elsewhere.
double off_seam(double place, double width) {
    const double from_seam = std::fabs(place - std::floor(place + 0.5));
    return std::clamp(from_seam / width, 0.0, 1.0);
}

Colour cloth_at(double u, double v) {
    const double warp = noise(u, v, 16, 256, 11);
    const double weft = noise(u, v, 256, 16, 12);
    const double fluff = noise(u, v, 256, 256, 13);
    return mixed(kClothDark, kClothLight, 0.25 * warp + 0.25 * weft + 0.5 * fluff);
}

/// 0 to 1, without an edge at either end.
double smooth(double share) {
    const double within = std::clamp(share, 0.0, 1.0);
    return within * within * (3.0 - 2.0 * within);
}

}  // namespace

Picture cloth_picture() {
    return draw(512, 512, cloth_at);
}

Picture cushion_picture() {
    return draw(512, 512, [](double u, double v) { return kStretched * cloth_at(u, v); });
}

Picture ball_shade_picture() {
    constexpr double kDarkest = 0.22;
    return draw(64, 64, [](double u, double v) {
        const double out = 2.0 * glm::length(base::Vec2(u - 0.5, v - 0.5));
        return Colour(kDarkest + (1.0 - kDarkest) * smooth((out - 0.1) / 0.85));
    });
}

Picture table_shade_picture() {
    constexpr double kDarkest = 0.38;
    return draw(4, 128, [](double, double v) {
        const double out = 2.0 * std::fabs(v - 0.5);
        return Colour(kDarkest + (1.0 - kDarkest) * smooth((out + 0.12) / 1.1));
    });
}

Picture wood_picture() {
    return draw(1024, 512, [](double u, double v) {
        const double wander = cloudy(u, v, 2, 3, 4, 21);
        const double rings = wave(5 * v + 3.2 * wander);
        const double bands = cloudy(u, v, 2, 24, 3, 22);
        const double fibres = noise(u, v, 24, 256, 23);
        const double pores = noise(u, v, 64, 256, 24);
        const double tone = 0.36 * rings + 0.40 * bands + 0.24 * fibres;
        const Colour colour = mixed(kWoodDark, kWoodLight, tone);
        return mixed(colour, 0.6 * colour, 3.0 * (pores - 0.72));
    });
}

Picture floor_picture() {
    constexpr int kPlanks = 8;
    return draw(1024, 512, [](double u, double v) {
        const int plank = static_cast<int>(std::floor(v * kPlanks));
        // Each plank ends elsewhere; two lengths a picture.
        const double along = 2 * u + scatter(plank, 1, 31);
        const int board = static_cast<int>(std::floor(along)) % 2;
        const double tint = scatter(plank, 2 + board, 32);
        const double shift = scatter(plank, 8 + board, 33);
        const double wander = cloudy(u, v + shift, 2, 8, 3, 34);
        const double rings = wave(24 * v + 4 * wander + 5 * shift);
        const double fibres = noise(u, v, 32, 256, 35);
        const double tone = 0.45 * tint + 0.30 * rings * wander + 0.25 * fibres;
        const double seam = std::min(off_seam(v * kPlanks, 0.035), off_seam(along, 0.006));
        return mixed(kFloorDark, kFloorLight, tone) * (0.45 + 0.55 * seam);
    });
}

}  // namespace billiards::make_assets
