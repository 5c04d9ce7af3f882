// Takes digits; gives strokes of straight lines and elliptic arcs.
#include "tools/make_assets/digits.h"

#include "common/base/check.h"
#include "common/base/elementary.h"

#include <algorithm>
#include <limits>

namespace billiards::make_assets {

namespace {

using base::Vec2;
using Stroke = std::vector<Vec2>;

constexpr double kDigitWidth = 0.6;
constexpr double kPen = 0.085;

/// Part of an ellipse, anticlockwise where `to` is the larger angle. Angles in degrees from +x.
Stroke arc(Vec2 center, Vec2 radii, double from, double to) {
    constexpr int kPieces = 24;
    Stroke stroke;
    for (int i = 0; i <= kPieces; ++i) {
        const double angle = base::radians(from + (to - from) * i / kPieces);
        stroke.push_back(center + radii * Vec2(base::cosine(angle), base::sine(angle)));
    }
    return stroke;
}

Stroke joined(Stroke first, const Stroke& second) {
    first.insert(first.end(), second.begin(), second.end());
    return first;
}

std::vector<Stroke> six() {
    return {arc({0.30, 0.32}, {0.23, 0.24}, 0, 360), arc({0.50, 0.32}, {0.43, 0.60}, 98, 180)};
}

std::vector<Stroke> nine() {
    std::vector<Stroke> strokes = six();
    for (Stroke& stroke : strokes) {
        for (Vec2& point : stroke) point = Vec2(kDigitWidth, 1.0) - point;
    }
    return strokes;
}

/// In a cell 0.6 wide and 1 high.
std::vector<Stroke> digit(int value) {
    switch (value) {
        case 0:
            return {arc({0.30, 0.50}, {0.21, 0.42}, 0, 360)};
        case 1:
            return {{{0.12, 0.76}, {0.33, 0.92}, {0.33, 0.08}}};
        case 2:
            return {
                joined(arc({0.29, 0.68}, {0.21, 0.24}, 165, -38), {{0.08, 0.08}, {0.54, 0.08}})};
        case 3:
            return {arc({0.28, 0.71}, {0.20, 0.21}, 150, -90),
                    arc({0.28, 0.29}, {0.23, 0.21}, 90, -150)};
        case 4:
            return {{{0.42, 0.08}, {0.42, 0.92}, {0.06, 0.31}, {0.57, 0.31}}};
        case 5:
            return {joined({{0.51, 0.92}, {0.16, 0.92}, {0.12, 0.53}},
                           arc({0.28, 0.33}, {0.25, 0.25}, 120, -140))};
        case 6:
            return six();
        case 7:
            return {{{0.08, 0.92}, {0.54, 0.92}, {0.23, 0.08}}};
        case 8:
            return {arc({0.30, 0.71}, {0.19, 0.21}, 0, 360),
                    arc({0.30, 0.29}, {0.23, 0.21}, 0, 360)};
        case 9:
            return nine();
        default:
            CHECK(false);
    }
}

double distance_to_line(const Vec2& place, const Vec2& from, const Vec2& to) {
    const Vec2 line = to - from;
    const double length_squared = glm::dot(line, line);
    const double share = length_squared > 0
                             ? std::clamp(glm::dot(place - from, line) / length_squared, 0.0, 1.0)
                             : 0.0;
    return glm::distance(place, from + share * line);
}

}  // namespace

Lettering lettering(int number) {
    CHECK(number >= 0 && number < 100);
    const std::vector<int> digits =
        number < 10 ? std::vector{number} : std::vector{number / 10, number % 10};
    Lettering result{{}, kPen};
    double left = -kDigitWidth / 2 * static_cast<double>(digits.size());
    for (const int value : digits) {
        for (Stroke& stroke : digit(value)) {
            for (Vec2& point : stroke) point += Vec2(left, -0.5);
            result.strokes.push_back(std::move(stroke));
        }
        left += kDigitWidth;
    }
    if (number == 6 || number == 9) result.strokes.push_back({{-0.22, -0.68}, {0.22, -0.68}});
    return result;
}

double distance_to_ink(const Lettering& lettering, const Vec2& place) {
    double nearest = std::numeric_limits<double>::infinity();
    for (const Stroke& stroke : lettering.strokes) {
        for (std::size_t i = 0; i + 1 < stroke.size(); ++i) {
            nearest = std::min(nearest, distance_to_line(place, stroke[i], stroke[i + 1]));
        }
    }
    return nearest - lettering.pen;
}

}  // namespace billiards::make_assets
