// Takes hands; gives a place for the cue ball, by the same rules as the server.
#include "client/play/placing.h"

#include "common/match/placement.h"
#include "common/model/table_spec.h"

namespace billiards::client {

namespace {

const model::TableSpec& table_of(const match::MatchState& match) {
    return model::table_of(match.settings.table);
}

}  // namespace

Placing::Placing(const match::MatchState& match)
    : match_(match),
      position_m_(
          match.layout.on_table(model::kCueBall)
              ? match.layout.find(model::kCueBall)->position_m
              : match::default_placement(table_of(match), match.layout, match.rack.in_hand)) {}

void Placing::hold_at(base::Vec2 position_m) {
    const base::Vec2 reach = table_of(match_).half_playing_m - model::BallSpec{}.radius_m;
    position_m_ = glm::clamp(position_m, -reach, reach);
}

bool Placing::is_legal() const {
    return match::check_placement(table_of(match_), match_.layout, match_.rack.in_hand, position_m_)
        .ok();
}

bool Placing::is_down() const {
    const model::PlacedBall* cue_ball = match_.layout.find(model::kCueBall);
    return cue_ball != nullptr && cue_ball->place == model::Place::OnTable &&
           cue_ball->position_m == position_m_;
}

}  // namespace billiards::client
