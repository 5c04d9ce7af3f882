// Gives a picture of sRGB colours with its first row at the bottom, and what pictures are drawn
// with.
#pragma once

#include "common/base/vec.h"

#include <algorithm>
#include <vector>

namespace billiards::make_assets {

/// Red, green and blue from 0 to 1, as the screen shows them (sRGB).
using Colour = base::Vec3;

struct Picture {
    int width = 0;
    int height = 0;
    std::vector<Colour> pixels;  ///< Rows from the bottom up, each from left to right.
};

/// colour_at(u, v), asked in the middle of each pixel; u and v run from 0 to 1.
template <class ColourAt>
Picture draw(int width, int height, ColourAt colour_at) {
    Picture picture{width, height, {}};
    picture.pixels.reserve(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            picture.pixels.push_back(colour_at((x + 0.5) / width, (y + 0.5) / height));
        }
    }
    return picture;
}

inline Colour mixed(const Colour& from, const Colour& to, double share) {
    return from + (to - from) * std::clamp(share, 0.0, 1.0);
}

/// How much of a pixel lies inside an edge that is `outside` away (negative: within).
inline double coverage(double outside, double pixel) {
    return std::clamp(0.5 - outside / pixel, 0.0, 1.0);
}

}  // namespace billiards::make_assets
