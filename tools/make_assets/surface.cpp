// Takes points; gives triangles: two a field of a sheet, and ears cut from a plate until nothing
// is left.
#include "tools/make_assets/surface.h"

#include "common/base/check.h"
#include "common/base/elementary.h"

#include <array>
#include <numeric>

namespace billiards::make_assets {

namespace {

using base::Vec2;
using base::Vec3;

std::uint32_t add_points(client::Mesh& mesh, const Row& points) {
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    for (const Point& point : points) {
        mesh.vertices.push_back(
            {.position_m = glm::vec3(point.place_m), .normal = {}, .uv = glm::vec2(point.uv)});
    }
    return first;
}

void add_triangle(client::Mesh& mesh, const std::array<std::uint32_t, 3>& corners) {
    const auto place = [&](std::size_t i) { return mesh.vertices[corners[i]].position_m; };
    if (place(0) == place(1) || place(1) == place(2) || place(2) == place(0)) return;
    mesh.indices.insert(mesh.indices.end(), corners.begin(), corners.end());
}

/// Twice the area of a triangle; positive where it goes anticlockwise.
double turn(const Vec2& a, const Vec2& b, const Vec2& c) {
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

bool is_within(const Vec2& point, const std::array<Vec2, 3>& triangle) {
    const auto& [a, b, c] = triangle;
    return turn(a, b, point) >= 0 && turn(b, c, point) >= 0 && turn(c, a, point) >= 0;
}

/// Whether the corner `at` of what is left can be cut off: it bends outwards, and no other corner
/// lies in its triangle.
bool is_ear(const Row& outline, const std::vector<std::size_t>& left, std::size_t at) {
    const auto corner = [&](std::size_t i) {
        return base::horizontal(outline[left[i % left.size()]].place_m);
    };
    const std::size_t before = at + left.size() - 1;
    const std::array triangle{corner(before), corner(at), corner(at + 1)};
    if (turn(triangle[0], triangle[1], triangle[2]) <= 1e-12) return false;
    for (std::size_t i = at + 2; i < before; ++i) {
        if (is_within(corner(i), triangle)) return false;
    }
    return true;
}

}  // namespace

void add_sheet(client::Mesh& mesh, const std::vector<Row>& rows) {
    std::vector<std::uint32_t> starts;
    for (const Row& row : rows) {
        CHECK(row.size() == rows.front().size());
        starts.push_back(add_points(mesh, row));
    }
    for (std::size_t row = 0; row + 1 < rows.size(); ++row) {
        for (std::uint32_t i = 0; i + 1 < rows[row].size(); ++i) {
            const std::uint32_t low = starts[row] + i;
            const std::uint32_t high = starts[row + 1] + i;
            add_triangle(mesh, {low, low + 1, high + 1});
            add_triangle(mesh, {low, high + 1, high});
        }
    }
}

void add_plate(client::Mesh& mesh, const Row& outline) {
    const std::uint32_t first = add_points(mesh, outline);
    std::vector<std::size_t> left(outline.size());
    std::iota(left.begin(), left.end(), std::size_t{0});
    while (left.size() > 2) {
        std::size_t at = 0;
        while (at < left.size() && !is_ear(outline, left, at)) ++at;
        if (at == left.size()) return;  // What is left has no area.
        const auto corner = [&](std::size_t i) {
            return first + static_cast<std::uint32_t>(left[i % left.size()]);
        };
        add_triangle(mesh, {corner(at + left.size() - 1), corner(at), corner(at + 1)});
        left.erase(left.begin() + static_cast<std::ptrdiff_t>(at));
    }
}

void add_turned(client::Mesh& mesh, const Vec3& foot_m, std::span<const Turn> rings, int sides,
                double times_round) {
    std::vector<Row> rows;
    for (const Turn& ring : rings) {
        Row row;
        for (int side = 0; side <= sides; ++side) {
            // The last place is the first one to the bit, so that the seam has one normal.
            const double angle = 2 * base::kPi * (side % sides) / sides;
            row.push_back({foot_m + Vec3(ring.radius_m * base::cosine(angle),
                                         ring.radius_m * base::sine(angle), ring.height_m),
                           {times_round * side / sides, ring.v}});
        }
        rows.push_back(std::move(row));
    }
    add_sheet(mesh, rows);
}

}  // namespace billiards::make_assets
