// Takes balls, cue and table; gives transforms and the files that each is drawn from.
#include "client/scene/scene.h"

#include "client/scene/room.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <glm/gtc/matrix_transform.hpp>
#include <limits>
#include <string_view>

namespace billiards::client {

namespace {

constexpr float kCloth = 0.0F;
constexpr float kFloorboards = 0.08F;
constexpr float kPolishedWood = 0.35F;
constexpr float kLeatherAndPearl = 0.06F;
constexpr float kBall = 1.0F;

/// The cue's half thickness where it passes over a rail, and the wood above the nose.
constexpr double kClearance_m = 0.022;

std::string_view name_of(model::TableSize size) {
    switch (size) {
        case model::TableSize::SevenFoot:
            return "7ft";
        case model::TableSize::EightFoot:
            return "8ft";
        case model::TableSize::NineFoot:
            return "9ft";
    }
    CHECK(false);
}

Drawn part_of(model::TableSize size, std::string_view part, float gloss) {
    return {.model = {fmt::format("models/table_{}_{}.3ds", name_of(size), part),
                      fmt::format("textures/{}.bmp", part)},
            .gloss = gloss,
            .is_fixed = true};
}

Drawn shade_of(model::TableSize size) {
    return {.model = {fmt::format("models/table_{}_shade.3ds", name_of(size)),
                      "textures/table_shade.bmp"},
            .casts_shadow = false,
            .is_fixed = true,
            .is_shade = true};
}

/// How far it is from a place on the bed to the noses' rectangle, in a direction.
double way_to_nose_m(const base::Vec2& from, const base::Vec2& direction,
                     const base::Vec2& half_playing_m) {
    double way = std::numeric_limits<double>::infinity();
    for (const glm::length_t axis : {0, 1}) {
        if (direction[axis] == 0.0) continue;
        const double edge = std::copysign(half_playing_m[axis], direction[axis]);
        way = std::min(way, (edge - from[axis]) / direction[axis]);
    }
    return std::max(0.0, way);
}

/// The elevation at which a cue to this ball clears the rail behind it.
double clearing_rail_rad(const HeldCue& cue, const model::TableSpec& table) {
    if (table.half_playing_m.x <= 0.0) return 0.0;
    const base::Vec2 backwards{-std::cos(cue.shot.angle_rad), -std::sin(cue.shot.angle_rad)};
    const double way = way_to_nose_m(cue.ball_m, backwards, table.half_playing_m);
    const double height = cue.ball_radius_m * (1.0 + cue.shot.tip_up);
    const double rise = table.nose_height_m + kClearance_m - height;
    const bool reaches_rail = way < kCueLength_m + cue.ball_radius_m && rise > 0.0;
    return reaches_rail ? std::atan2(rise, std::max(way, cue.ball_radius_m)) : 0.0;
}

/// Where the tip touches the ball: r = R (-c d + a l + b n) with d along the cue, l left of it, n
/// above it, a = tip_left, b = tip_up, c = sqrt(1 - a^2 - b^2), as the engine strikes.
base::Vec3 contact_m(const HeldCue& cue, double elevation_rad) {
    const model::Shot& shot = cue.shot;
    const double cos_angle = std::cos(shot.angle_rad);
    const double sin_angle = std::sin(shot.angle_rad);
    const double level = std::cos(elevation_rad);
    const double down = std::sin(elevation_rad);
    const base::Vec3 along{cos_angle * level, sin_angle * level, -down};
    const base::Vec3 left{-sin_angle, cos_angle, 0.0};
    const base::Vec3 above{cos_angle * down, sin_angle * down, level};
    const double off = shot.tip_left * shot.tip_left + shot.tip_up * shot.tip_up;
    const double depth = std::sqrt(std::max(0.0, 1.0 - off));
    return base::Vec3(cue.ball_m, cue.ball_radius_m) +
           cue.ball_radius_m * (-depth * along + shot.tip_left * left + shot.tip_up * above);
}

}  // namespace

std::vector<Drawn> drawn_table(model::TableSize size) {
    return {part_of(size, "cushion", kCloth),
            part_of(size, "wood", kPolishedWood),
            part_of(size, "fittings", kLeatherAndPearl),
            part_of(size, "cloth", kCloth),
            {.model = {"models/floor.3ds", "textures/floor.bmp"},
             .gloss = kFloorboards,
             .casts_shadow = false,
             .is_fixed = true},
            shade_of(size)};
}

Drawn drawn_ball(const ShownBall& ball, const glm::dquat& orientation, Detail detail) {
    const int number = ball.ball.number;
    const int picture = number <= 15 ? number : 1 + (number - 1) % 15;
    const glm::dmat4 place = glm::translate(glm::dmat4(1.0), ball.state.position_m);
    return {.model = {detail == Detail::Fine ? "models/ball.3ds" : "models/ball_low.3ds",
                      fmt::format("textures/ball_{:02}.bmp", picture)},
            .transform = glm::mat4(place * glm::mat4_cast(orientation) *
                                   glm::scale(glm::dmat4(1.0), glm::dvec3(ball.radius_m))),
            .gloss = kBall};
}

std::optional<Drawn> drawn_shade(const ShownBall& ball) {
    constexpr double kWidth = 1.35;           // Of the picture's half side, in radii.
    constexpr double kAboveCloth_m = 0.0004;  // And above the table's shade.
    const base::Vec3& at_m = ball.state.position_m;
    const double height_m = at_m.z - ball.radius_m;
    if (height_m < -kAboveCloth_m || height_m > ball.radius_m) return std::nullopt;
    const double half_side_m = kWidth * (ball.radius_m - height_m);
    const glm::dmat4 place =
        glm::translate(glm::dmat4(1.0), base::Vec3(at_m.x, at_m.y, kAboveCloth_m));
    return Drawn{.model = {"models/ball_shade.3ds", "textures/ball_shade.bmp"},
                 .transform = glm::mat4(glm::scale(place, glm::dvec3(half_side_m))),
                 .casts_shadow = false,
                 .is_shade = true};
}

Drawn drawn_cue(const HeldCue& cue, const model::TableSpec& table) {
    const double elevation = std::max(cue.shot.elevation_rad, clearing_rail_rad(cue, table));
    // The model points along +x with its tip at the origin.
    glm::dmat4 place = glm::translate(glm::dmat4(1.0), contact_m(cue, elevation));
    place = glm::rotate(place, cue.shot.angle_rad, glm::dvec3(0, 0, 1));
    place = glm::rotate(place, elevation, glm::dvec3(0, 1, 0));
    place = glm::translate(place, glm::dvec3(-cue.drawn_back_m, 0, 0));
    return {.model = {"models/cue.3ds", "textures/cue.bmp"},
            .transform = glm::mat4(place),
            .gloss = kPolishedWood};
}

std::vector<Drawn> scene_of(model::TableSize size, std::span<const ShownBall> balls,
                            const Orientations& orientations, const std::optional<HeldCue>& cue,
                            Detail detail) {
    std::vector<Drawn> scene;
    for (const ShownBall& ball : balls) {
        scene.push_back(drawn_ball(ball, orientations.of(ball.ball), detail));
    }
    if (cue) scene.push_back(drawn_cue(*cue, model::table_of(size)));
    const std::vector<Drawn> table = drawn_table(size);
    scene.insert(scene.end(), table.begin(), table.end());
    for (const ShownBall& ball : balls) {
        if (auto shade = drawn_shade(ball)) scene.push_back(*std::move(shade));
    }
    return scene;
}

}  // namespace billiards::client
