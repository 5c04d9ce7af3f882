// Takes a shot; solves it, and reads off its way up to the first contact of balls.
#include "client/play/aim_help.h"

#include "common/match/match.h"
#include "common/model/table_spec.h"
#include "common/physics/simulate.h"
#include "common/timeline/evaluate.h"

#include <algorithm>

namespace billiards::client {

namespace {

constexpr int kPointsOfWay = 48;
/// As far after the contact the object ball has a direction.
constexpr double kAfterContact_s = 1e-6;

const timeline::BallTrack* track_of(const timeline::ShotRecord& record, model::BallId ball) {
    const auto& tracks = record.timeline.tracks;
    const auto track = std::ranges::find(tracks, ball, &timeline::BallTrack::ball);
    return track == tracks.end() ? nullptr : &*track;
}

const model::ShotEvent* first_contact(const timeline::ShotRecord& record) {
    const auto event = std::ranges::find_if(record.events, [](const model::ShotEvent& each) {
        return each.kind == model::EventKind::BallBall && each.ball == model::kCueBall;
    });
    return event == record.events.end() ? nullptr : &*event;
}

void add_object_ball(AimHelp& help, const timeline::ShotRecord& record,
                     const model::ShotEvent& contact, base::Vec2 cue_ball_m) {
    const timeline::BallTrack* object = track_of(record, contact.other);
    if (object == nullptr) return;
    const model::BallState after = timeline::evaluate(*object, contact.time_s + kAfterContact_s);
    const base::Vec2 velocity(after.velocity_mps);
    const double speed_mps = glm::length(velocity);
    if (speed_mps == 0.0) return;
    help.ghost_ball_m = cue_ball_m;
    help.object_ball_m = base::Vec2(after.position_m);
    help.object_ball_way = velocity / speed_mps;
}

}  // namespace

std::optional<AimHelp> aim_help(const match::MatchState& match, base::Vec2 cue_ball_m,
                                const model::Shot& shot) {
    model::Layout layout = match.layout;
    model::PlacedBall* cue_ball = layout.find(model::kCueBall);
    if (cue_ball == nullptr) return std::nullopt;
    cue_ball->place = model::Place::OnTable;
    cue_ball->position_m = cue_ball_m;
    const auto record =
        physics::simulate_shot(model::table_of(match.settings.table),
                               match::parameters_of(match.settings.physics), layout, shot);
    if (!record) return std::nullopt;
    const timeline::BallTrack* track = track_of(*record, model::kCueBall);
    if (track == nullptr) return std::nullopt;

    const model::ShotEvent* contact = first_contact(*record);
    const double until_s = contact != nullptr ? contact->time_s : record->duration_s;
    AimHelp help;
    for (int i = 0; i <= kPointsOfWay; ++i) {
        const double time_s = until_s * i / kPointsOfWay;
        help.cue_ball_way_m.emplace_back(timeline::evaluate(*track, time_s).position_m);
    }
    if (contact != nullptr) {
        add_object_ball(help, *record, *contact, help.cue_ball_way_m.back());
    }
    return help;
}

}  // namespace billiards::client
