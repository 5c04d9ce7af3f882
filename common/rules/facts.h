// Takes the events of a shot; gives the few facts that rulings rest on, each documented once.
#pragma once

#include "common/model/ball.h"
#include "common/model/shot.h"
#include "common/model/shot_event.h"

#include <optional>
#include <span>
#include <vector>

namespace billiards::rules {

struct PocketedBall {
    model::BallId ball;
    model::PocketId pocket;

    friend bool operator==(const PocketedBall&, const PocketedBall&) = default;
};

struct Facts {
    /// The balls that the cue ball met first: several when it met them at the same instant.
    model::BallSet first_contacts;
    std::vector<PocketedBall> pocketed;  ///< Object balls, in the order in which they fell.
    bool cue_ball_lost = false;          ///< Pocketed or off the table.
    model::BallSet off_table;            ///< Object balls.
    /// Object balls driven to a cushion during the shot: a cushion or jaw event that is not held,
    /// or pocketed, or off the table.
    model::BallSet driven_to_cushion;
    /// Any ball, the cue ball too, driven to a cushion at or after the first contact.
    model::BallSet driven_after_contact;
    /// The cue ball crossed the head string towards +x before its first contact.
    bool crossed_head_string = false;

    friend bool operator==(const Facts&, const Facts&) = default;
};

/// Events in order of time. Motion and landing say nothing to the rules.
Facts facts_of(std::span<const model::ShotEvent> events);

/// The object balls that were pocketed.
model::BallSet fallen_balls(const Facts& facts);

}  // namespace billiards::rules
