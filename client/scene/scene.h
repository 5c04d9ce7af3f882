// Takes the balls and the cue as they are shown; gives the list of what is drawn, where, and from
// which files. Knows no OpenGL.
#pragma once

#include "client/playback/playback.h"
#include "client/scene/model.h"
#include "client/scene/orientation.h"
#include "common/model/shot.h"
#include "common/model/table_spec.h"

#include <cstdint>
#include <glm/mat4x4.hpp>
#include <optional>
#include <span>
#include <vector>

namespace billiards::client {

/// Balls of 1,856 triangles, or of 480 for machines that draw without a graphics card.
enum class Detail : std::uint8_t { Fine, Coarse };

/// One object: the model's meshes, placed by the transform into the physics' coordinates.
struct Drawn {
    Model model;
    glm::mat4 transform{1.0F};
    float gloss = 0.0F;  ///< 0 dull as cloth, 1 as polished as a ball.
    bool casts_shadow = true;
    bool is_fixed = false;  ///< The same in every frame, as long as the table is.
    bool is_shade = false;  ///< Unlit; its picture darkens what lies under it.

    friend bool operator==(const Drawn&, const Drawn&) = default;
};

/// The cue in a player's hands, behind the ball that it is going to strike.
struct HeldCue {
    base::Vec2 ball_m{};
    model::Shot shot;
    double drawn_back_m = 0.0;  ///< From where the tip touches the ball.
    double ball_radius_m = model::BallSpec{}.radius_m;

    friend bool operator==(const HeldCue&, const HeldCue&) = default;
};

/// The table's parts and the floor. The same as long as the table is.
std::vector<Drawn> drawn_table(model::TableSize size);

/// A ball, turned as it is. Ids above 15 have the object balls' pictures again.
Drawn drawn_ball(const ShownBall& ball, const glm::dquat& orientation, Detail detail);

/// The dark spot on the cloth under a ball, smaller the higher it is; none where it is far
/// above the bed or below it.
std::optional<Drawn> drawn_shade(const ShownBall& ball);

/// The tip is where the shot's offsets say. The butt is raised as far as the shot says, and for
/// the eye as far as the cue needs to clear the rail behind it.
Drawn drawn_cue(const HeldCue& cue, const model::TableSpec& table);

/// All of it, what is likely to hide something first, and shades last: the table, the balls as
/// `orientations` has them turned, the cue where there is one.
std::vector<Drawn> scene_of(model::TableSize size, std::span<const ShownBall> balls,
                            const Orientations& orientations, const std::optional<HeldCue>& cue,
                            Detail detail = Detail::Fine);

}  // namespace billiards::client
