// Takes a ball's number; gives for each direction from its centre the colour there.
#include "tools/make_assets/ball_picture.h"

#include "common/base/check.h"
#include "common/base/elementary.h"
#include "tools/make_assets/digits.h"

#include <array>
#include <cmath>

namespace billiards::make_assets {

namespace {

using base::Vec2;
using base::Vec3;

constexpr int kWidth = 512;
constexpr int kHeight = 256;
constexpr double kPixel = base::kPi / kHeight;  // On the unit sphere.

constexpr Colour kIvory{0.965, 0.945, 0.885};
constexpr Colour kInk{0.06, 0.06, 0.065};
constexpr Colour kDot{0.78, 0.10, 0.12};
/// Of balls 1 to 8; 9 to 15 are 1 to 7 again.
constexpr std::array<Colour, 8> kColours{{{0.965, 0.760, 0.050},
                                          {0.050, 0.200, 0.620},
                                          {0.820, 0.090, 0.100},
                                          {0.330, 0.130, 0.500},
                                          {0.945, 0.430, 0.060},
                                          {0.020, 0.430, 0.220},
                                          {0.470, 0.080, 0.130},
                                          {0.060, 0.060, 0.070}}};

/// All on the unit sphere.
constexpr double kDotRadius = 0.115;
constexpr double kStripeHalfWidth = 0.53;
constexpr double kCircleRadius = 0.40;
constexpr double kDigitHeight = 0.40;

Vec3 direction(double u, double v) {
    const double longitude = 2 * base::kPi * u;
    const double latitude = base::kPi * (v - 0.5);
    const double ring = base::cosine(latitude);
    return {ring * base::cosine(longitude), ring * base::sine(longitude), base::sine(latitude)};
}

Colour cue_ball(const Vec3& at) {
    const Vec3 size = glm::abs(at);
    const double towards_axis = std::max({size.x, size.y, size.z});
    const double away = std::sqrt(std::max(0.0, 1 - towards_axis * towards_axis));
    return mixed(kIvory, kDot, coverage(away - kDotRadius, kPixel));
}

/// A white disc with the number, on +y and on -y.
Colour with_number(Colour colour, const Vec3& at, const Lettering& number) {
    const Vec2 on_disc{at.y > 0 ? -at.x : at.x, at.z};
    const double outside = glm::length(on_disc) - kCircleRadius;
    if (outside > kPixel) return colour;
    colour = mixed(colour, kIvory, coverage(outside, kPixel));
    const double from_ink = kDigitHeight * distance_to_ink(number, on_disc / kDigitHeight);
    return mixed(colour, kInk, coverage(from_ink, kPixel));
}

}  // namespace

Picture ball_picture(int number) {
    CHECK(number >= 0 && number <= 15);
    if (number == 0) {
        return draw(kWidth, kHeight, [](double u, double v) { return cue_ball(direction(u, v)); });
    }
    const Colour& colour = kColours[static_cast<std::size_t>(number > 8 ? number - 9 : number - 1)];
    const double stripe = number > 8 ? kStripeHalfWidth : 2.0;
    const Lettering digits = lettering(number);
    return draw(kWidth, kHeight, [&](double u, double v) {
        const Vec3 at = direction(u, v);
        const double in_stripe = coverage(std::fabs(at.z) - stripe, kPixel);
        return with_number(mixed(kIvory, colour, in_stripe), at, digits);
    });
}

}  // namespace billiards::make_assets
