// Takes points in order; gives the triangles of sheets, turned bodies and flat plates.
#pragma once

#include "client/scene/mesh.h"
#include "common/base/vec.h"

#include <span>
#include <vector>

namespace billiards::make_assets {

struct Point {
    base::Vec3 place_m{};
    base::Vec2 uv{};
};
using Row = std::vector<Point>;

/// A sheet through rows with one number of points. It faces whoever sees the rows go up and their
/// points go right. Triangles without area are left out, so that a row may be one place.
void add_sheet(client::Mesh& mesh, const std::vector<Row>& rows);

/// A flat plate facing up; its outline goes anticlockwise seen from above, does not cross itself,
/// and may have bays.
void add_plate(client::Mesh& mesh, const Row& outline);

/// A ring of a turned body: how far out and how high, and v of the texture there.
struct Turn {
    double radius_m = 0.0;
    double height_m = 0.0;
    double v = 0.0;
};

/// A body turned about the vertical through `foot_m`, its rings from the bottom up; u goes round
/// `times_round` times.
void add_turned(client::Mesh& mesh, const base::Vec3& foot_m, std::span<const Turn> rings,
                int sides, double times_round = 1.0);

}  // namespace billiards::make_assets
