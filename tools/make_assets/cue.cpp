// Takes the lengths of a cue's parts; gives it turned about its axis, and painted part by part.
#include "tools/make_assets/cue.h"

#include "client/scene/room.h"
#include "common/base/elementary.h"
#include "tools/make_assets/noise.h"
#include "tools/make_assets/surface.h"

#include <array>
#include <cmath>

namespace billiards::make_assets {

namespace {

/// Where a part ends, in metres from the tip's face; each begins where the one before ends.
constexpr double kTip_m = 0.006;
constexpr double kFerrule_m = 0.030;
constexpr double kShaft_m = 0.735;
constexpr double kJoint_m = 0.750;
constexpr double kForearm_m = 1.045;
constexpr double kWrap_m = 1.350;
constexpr double kSleeve_m = 1.445;
constexpr double kButt_m = client::kCueLength_m;

constexpr Colour kChalk{0.13, 0.36, 0.62};
constexpr Colour kFerrule{0.93, 0.91, 0.85};
constexpr Colour kMaple{0.85, 0.69, 0.47};
constexpr Colour kMapleDark{0.74, 0.56, 0.35};
constexpr Colour kSteel{0.66, 0.66, 0.68};
constexpr Colour kEbony{0.085, 0.060, 0.050};
constexpr Colour kLinen{0.11, 0.12, 0.14};
constexpr Colour kLinenFleck{0.55, 0.56, 0.58};
constexpr Colour kRubber{0.05, 0.05, 0.05};

/// Distance from the tip, and radius: from the butt to the tip.
constexpr std::array<base::Vec2, 16> kProfile{{{1.4700, 0.0000},
                                               {1.4700, 0.0095},
                                               {1.4680, 0.0125},
                                               {1.4640, 0.0143},
                                               {1.4450, 0.0146},
                                               {1.2000, 0.0133},
                                               {1.0450, 0.0125},
                                               {0.7500, 0.0108},
                                               {0.7350, 0.0107},
                                               {0.4000, 0.0080},
                                               {0.1500, 0.0066},
                                               {0.0060, 0.0064},
                                               {0.0030, 0.0064},
                                               {0.0014, 0.0055},
                                               {0.0004, 0.0035},
                                               {0.0000, 0.0000}}};

Colour maple(double u, double v) {
    const double fibres = 0.6 * noise(u, v, 8, 32, 41) + 0.4 * noise(u, v, 64, 64, 42);
    return mixed(kMapleDark, kMaple, 0.35 + 0.65 * fibres);
}

/// Four points of ebony reach from the wrap into the maple, with a thin light line around each.
Colour forearm(double at_m, double u, double v) {
    const double reach = (kForearm_m - at_m) / (kForearm_m - kJoint_m - 0.04);
    const double from_middle = 8 * std::fabs(v * 4 - std::floor(v * 4) - 0.5) / 4;
    const double edge = 1.0 - reach - from_middle;
    const Colour inlay = mixed(maple(u, v), kFerrule, edge > -0.07 && edge <= -0.02 ? 1.0 : 0.0);
    return mixed(inlay, kEbony, coverage(-edge, 0.03));
}

Colour wrap(double u, double v) {
    const double flecks = noise(u, v, 512, 32, 43);
    return mixed(kLinen, kLinenFleck, 2.2 * (flecks - 0.55));
}

Colour sleeve(double at_m, double u, double v) {
    const double from_ring =
        std::min(std::fabs(at_m - kWrap_m - 0.012), std::fabs(at_m - kSleeve_m + 0.012));
    const Colour ebony = mixed(kEbony, 1.5 * kEbony, noise(u, v, 64, 32, 44));
    return mixed(kFerrule, ebony, from_ring / 0.002 - 1.0);
}

Colour joint(double at_m) {
    const double from_middle = std::fabs(at_m - (kShaft_m + kJoint_m) / 2);
    return from_middle < 0.004 ? kSteel : kEbony;
}

Colour colour_at(double u, double v) {
    const double at_m = u * kButt_m;
    if (at_m < kTip_m) return kChalk;
    if (at_m < kFerrule_m) return kFerrule;
    if (at_m < kShaft_m) return maple(u, v);
    if (at_m < kJoint_m) return joint(at_m);
    if (at_m < kForearm_m) return forearm(at_m, u, v);
    if (at_m < kWrap_m) return wrap(u, v);
    if (at_m < kSleeve_m) return sleeve(at_m, u, v);
    return kRubber;
}

}  // namespace

client::Mesh cue_mesh() {
    constexpr int kSides = 20;
    std::vector<Turn> rings;
    for (const base::Vec2& ring : kProfile) rings.push_back({ring.y, -ring.x, ring.x / kButt_m});
    client::Mesh mesh{.name = "cue", .vertices = {}, .indices = {}};
    add_turned(mesh, {}, rings, kSides);
    for (client::Vertex& vertex : mesh.vertices) {
        // Turned about z; laid on x by a change of axes that keeps what is outside outside.
        vertex.position_m = {vertex.position_m.z, vertex.position_m.x, vertex.position_m.y};
        vertex.uv = {vertex.uv.y, vertex.uv.x};
    }
    return mesh;
}

Picture cue_picture() {
    return draw(2048, 64, colour_at);
}

}  // namespace billiards::make_assets
