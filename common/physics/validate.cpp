// Takes what a shot starts from; gives the first thing that is wrong with it.
#include "common/physics/validate.h"

#include "common/base/elementary.h"
#include "common/physics/forecast.h"
#include "common/physics/nearness.h"
#include "common/physics/table_shape.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <optional>
#include <string>

namespace billiards::physics {

namespace {

using base::Done;
using base::Vec2;
using base::Vec3;

using Fault = std::optional<Error>;

struct Field {
    const char* name;
    double value;
    double low;
    double high;
};

Fault fault_of(const std::string& of, std::initializer_list<Field> fields) {
    for (const Field& field : fields) {
        if (!std::isfinite(field.value)) return Error{ErrorCode::NotFinite, of + field.name};
    }
    for (const Field& field : fields) {
        if (field.value < field.low || field.value > field.high) {
            return Error{ErrorCode::OutOfRange, of + field.name};
        }
    }
    return {};
}

Fault point_fault(const std::string& name, const Vec2& point) {
    return fault_of(name, {{".x", point.x, -kMostPosition_m, kMostPosition_m},
                           {".y", point.y, -kMostPosition_m, kMostPosition_m}});
}

Result<Done> result_of(Fault fault) {
    if (fault) return *std::move(fault);
    return Done{};
}

std::string name_of(model::BallId ball) {
    return "ball " + std::to_string(ball.number);
}

Fault vector_fault(const std::string& name, const Vec3& vector, double most) {
    return fault_of(name, {{".x", vector.x, -most, most},
                           {".y", vector.y, -most, most},
                           {".z", vector.z, -most, most}});
}

Fault number_fault(const BallStart& ball) {
    const std::string name = name_of(ball.ball);
    if (ball.ball.number >= model::kMaxBalls) return Error{ErrorCode::OutOfRange, name + " id"};
    if (auto fault =
            fault_of(name, {{" radius_m", ball.spec.radius_m, kLeastRadius_m, kMostRadius_m},
                            {" mass_kg", ball.spec.mass_kg, kLeastMass_kg, kMostMass_kg}})) {
        return fault;
    }
    if (auto fault = vector_fault(name + " position_m", ball.position_m, kMostPosition_m))
        return fault;
    if (auto fault = vector_fault(name + " velocity_mps", ball.velocity_mps, kMostSpeed_mps))
        return fault;
    return vector_fault(name + " spin_radps", ball.spin_radps, kMostSpin_radps);
}

Fault pair_fault(std::span<const BallStart> balls) {
    for (std::size_t i = 0; i < balls.size(); ++i) {
        for (std::size_t j = i + 1; j < balls.size(); ++j) {
            const auto names = [&] {
                return name_of(balls[i].ball) + ", " + name_of(balls[j].ball);
            };
            if (balls[i].ball == balls[j].ball) return Error{ErrorCode::DuplicateBall, names()};
            const Vec3 offset = balls[j].position_m - balls[i].position_m;
            const double gap = std::sqrt(glm::dot(offset, offset)) - balls[i].spec.radius_m -
                               balls[j].spec.radius_m;
            if (gap < -kMostOverlap_m) return Error{ErrorCode::Overlap, names()};
        }
    }
    return {};
}

Fault fixed_fault(const TableShape& shape, const BallStart& ball) {
    const double radius = ball.spec.radius_m;
    const double sine = lean_sine(shape, radius, radius);
    if (!shape.walls.empty() && (sine <= -1.0 || sine >= 1.0)) {
        return Error{ErrorCode::OutOfRange, name_of(ball.ball) + " radius_m against nose_height_m"};
    }
    const bool is_on_slate = ball.position_m.z <= radius;
    if (is_on_slate && shape.calm.contains(base::horizontal(ball.position_m))) return {};
    const std::size_t count = shape.walls.size() + shape.posts.size();
    for (std::size_t i = 0; i < count; ++i) {
        const auto fixed = static_cast<FixedIndex>(i);
        const bool is_wall = !is_post(shape, fixed);
        if (is_wall && !faces(shape.walls[i], base::horizontal(ball.position_m))) continue;
        const Nearness near = nearness(shape, fixed, ball.position_m, radius);
        if (near.gap_m >= -kMostOverlap_m) continue;
        const std::size_t index = is_wall ? i : i - shape.walls.size();
        return Error{ErrorCode::Overlap, name_of(ball.ball) + (is_wall ? ", cushion " : ", jaw ") +
                                             std::to_string(index)};
    }
    return {};
}

Fault place_fault(const TableShape& shape, const BallStart& ball) {
    const Vec2 position = base::horizontal(ball.position_m);
    // Cushions in one line, as experiments have them, enclose nothing that one could be outside of.
    const Vec2 extent = shape.cushions.high - shape.cushions.low;
    const bool has_inside = extent.x != 0.0 && extent.y != 0.0;
    if (shape.has_edge && has_inside && !shape.edge.contains(position)) {
        return Error{ErrorCode::OutsideTable, name_of(ball.ball)};
    }
    if (ball.position_m.z < ball.spec.radius_m - kMostOverlap_m) {
        return Error{ErrorCode::Overlap, name_of(ball.ball) + ", slate"};
    }
    if (auto fault = fixed_fault(shape, ball)) return fault;
    if (is_behind_nose(shape, position)) {
        return Error{ErrorCode::OutsideTable, name_of(ball.ball)};
    }
    for (std::size_t i = 0; i < shape.pockets.size(); ++i) {
        const Vec2 offset = position - shape.pockets[i].center_m;
        const double radius = shape.pockets[i].radius_m;
        if (glm::dot(offset, offset) < radius * radius) {
            return Error{ErrorCode::OutsideTable,
                         name_of(ball.ball) + " lies in pocket " + std::to_string(i)};
        }
    }
    return {};
}

}  // namespace

double largest_radius_m(std::span<const BallStart> balls) {
    double largest = 0.0;
    for (const BallStart& ball : balls) largest = std::max(largest, ball.spec.radius_m);
    return largest;
}

Result<Done> validate(const model::Shot& shot) {
    if (auto fault = fault_of("", {{"angle_rad", shot.angle_rad, -kMostAngle_rad, kMostAngle_rad},
                                   {"power", shot.power, 0.0, 1.0},
                                   {"tip_left", shot.tip_left, -kMostOffset, kMostOffset},
                                   {"tip_up", shot.tip_up, -kMostOffset, kMostOffset},
                                   {"elevation_rad", shot.elevation_rad, 0.0, base::kPi / 2}})) {
        return *std::move(fault);
    }
    if (shot.power == 0.0) return Error{ErrorCode::OutOfRange, "power"};
    if (shot.elevation_rad >= base::kPi / 2) return Error{ErrorCode::OutOfRange, "elevation_rad"};
    const double offset_squared = shot.tip_left * shot.tip_left + shot.tip_up * shot.tip_up;
    constexpr double kRounding = 1e-12;  // (0.3, 0.4) is within.
    if (offset_squared > kMostOffset * kMostOffset + kRounding) {
        return Error{ErrorCode::OutOfRange, "tip offset"};
    }
    return Done{};
}

Result<Done> validate(const Parameters& p) {
    constexpr double kMany = 1e6;
    return result_of(
        fault_of("", {{"gravity_mps2", p.gravity_mps2, 0.0, 1000.0},
                      {"sliding_friction", p.sliding_friction, 0.0, 10.0},
                      {"rolling_friction", p.rolling_friction, 0.0, 10.0},
                      {"spin_deceleration_radps2", p.spin_deceleration_radps2, 0.0, kMany},
                      {"ball_ball_restitution", p.ball_ball_restitution, 0.0, 1.0},
                      {"ball_friction_base", p.ball_friction_base, 0.0, 10.0},
                      {"ball_friction_scale", p.ball_friction_scale, 0.0, 10.0},
                      {"ball_friction_decay_spm", p.ball_friction_decay_spm, 0.0, kMany},
                      {"cushion_restitution", p.cushion_restitution, 0.0, 1.0},
                      {"cushion_friction", p.cushion_friction, 0.0, 10.0},
                      {"ball_table_restitution", p.ball_table_restitution, 0.0, 0.99},
                      {"cue_mass_kg", p.cue_mass_kg, kLeastMass_kg, kMostMass_kg},
                      {"cue_end_mass_ratio", p.cue_end_mass_ratio, 1e-6, kMany},
                      {"cue_spring_npm", p.cue_spring_npm, 0.0, 1e9},
                      {"cue_contact_time_s", p.cue_contact_time_s, 0.0, 10.0},
                      {"stop_speed_mps", p.stop_speed_mps, 0.0, kMostSpeed_mps}}));
}

Result<Done> validate(const model::TableSpec& table) {
    for (const auto& [name, count] :
         {std::pair{"cushions", table.cushions.size()}, std::pair{"jaws", table.jaws.size()},
          std::pair{"pockets", table.pockets.size()}}) {
        if (count <= kMostParts) continue;
        return Error{ErrorCode::OutOfRange,
                     std::string(name) + ", more than " + std::to_string(kMostParts)};
    }
    const bool has_bed = table.half_playing_m != Vec2{};
    if (has_bed && table.cushions.empty()) return Error{ErrorCode::OutOfRange, "cushions"};
    for (std::size_t i = 0; i < table.cushions.size(); ++i) {
        const std::string name = "cushions[" + std::to_string(i) + "]";
        const model::CushionSegment& cushion = table.cushions[i];
        if (auto fault = point_fault(name + ".from", cushion.from_m)) return *std::move(fault);
        if (auto fault = point_fault(name + ".to", cushion.to_m)) return *std::move(fault);
        if (cushion.from_m == cushion.to_m) return Error{ErrorCode::OutOfRange, name};
    }
    const auto circle_fault = [](const std::string& name, const auto& circle, double least) {
        if (auto fault = point_fault(name + ".center", circle.center_m)) return fault;
        return fault_of(name, {{".radius", circle.radius_m, least, kMostPosition_m}});
    };
    for (std::size_t i = 0; i < table.jaws.size(); ++i) {
        const std::string name = "jaws[" + std::to_string(i) + "]";
        if (auto fault = circle_fault(name, table.jaws[i], 0.0)) return *std::move(fault);
    }
    for (std::size_t i = 0; i < table.pockets.size(); ++i) {
        const std::string name = "pockets[" + std::to_string(i) + "]";
        if (auto fault = circle_fault(name, table.pockets[i], 1e-6)) return *std::move(fault);
    }
    return result_of(fault_of("", {{"nose_height_m", table.nose_height_m, 0.0, kMostPosition_m}}));
}

Result<Done> validate(const model::TableSpec& table, std::span<const BallStart> balls) {
    if (balls.empty()) return Error{ErrorCode::TooManyBalls, "no balls"};
    if (balls.size() > model::kMaxBalls) {
        return Error{ErrorCode::TooManyBalls, std::to_string(balls.size()) + " balls"};
    }
    for (const BallStart& ball : balls) {
        if (auto fault = number_fault(ball)) return *std::move(fault);
    }
    if (auto fault = pair_fault(balls)) return *std::move(fault);
    const TableShape shape(table, largest_radius_m(balls));
    for (const BallStart& ball : balls) {
        if (auto fault = place_fault(shape, ball)) return *std::move(fault);
    }
    return Done{};
}

}  // namespace billiards::physics
