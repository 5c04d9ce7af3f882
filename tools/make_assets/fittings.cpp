// Takes a fitting; gives its cell in a row of eight.
#include "tools/make_assets/fittings.h"

#include <array>
#include <cmath>

namespace billiards::make_assets {

namespace {

constexpr int kCells = 8;
constexpr int kCellPixels = 16;
constexpr std::array<Colour, kCells> kColours{{{0.205, 0.160, 0.130},
                                               {0.095, 0.080, 0.070},
                                               {0.012, 0.012, 0.012},
                                               {0.930, 0.915, 0.865},
                                               {0.030, 0.060, 0.050},
                                               {0.740, 0.590, 0.300},
                                               {0.0, 0.0, 0.0},
                                               {0.0, 0.0, 0.0}}};

}  // namespace

base::Vec2 texture_place(Fitting fitting) {
    return {(static_cast<double>(fitting) + 0.5) / kCells, 0.5};
}

Picture fittings_picture() {
    return draw(kCells * kCellPixels, kCellPixels, [](double u, double) {
        return kColours[static_cast<std::size_t>(std::floor(u * kCells))];
    });
}

}  // namespace billiards::make_assets
