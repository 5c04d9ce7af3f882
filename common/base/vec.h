// Gives the two vectors that everything is measured with: doubles, right-handed, z up.
#pragma once

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace billiards::base {

using Vec2 = glm::dvec2;
using Vec3 = glm::dvec3;

inline Vec2 horizontal(const Vec3& v) {
    return {v.x, v.y};
}

}  // namespace billiards::base
