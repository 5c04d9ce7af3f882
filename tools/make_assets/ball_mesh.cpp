// Takes sides and bands; gives a turned sphere.
#include "tools/make_assets/ball_mesh.h"

#include "common/base/elementary.h"
#include "tools/make_assets/surface.h"

namespace billiards::make_assets {

client::Mesh ball_mesh(int sides, int bands) {
    std::vector<Turn> rings;
    for (int band = 0; band <= bands; ++band) {
        const double v = static_cast<double>(band) / bands;
        const double latitude = base::kPi * (v - 0.5);
        const bool is_pole = band == 0 || band == bands;
        rings.push_back({is_pole ? 0.0 : base::cosine(latitude), base::sine(latitude), v});
    }
    client::Mesh mesh{.name = "ball", .vertices = {}, .indices = {}};
    add_turned(mesh, {}, rings, sides);
    return mesh;
}

}  // namespace billiards::make_assets
