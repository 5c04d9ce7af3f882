// Takes a match of practice; gives it with the balls where its player wants them.
#include "common/match/practice.h"

#include "common/base/check.h"
#include "common/match/racks.h"

#include <utility>

namespace billiards::match {

namespace {

void go_to(MatchState& match, MatchState::Position position) {
    match.rack = std::move(position.rack);
    match.layout = std::move(position.layout);
}

}  // namespace

void remember(MatchState& match) {
    match.undo.push_back({match.rack, match.layout});
    if (match.undo.size() > kMostUndone) match.undo.erase(match.undo.begin());
}

void undo(MatchState& match) {
    CHECK(!match.undo.empty());
    go_to(match, std::move(match.undo.back()));
    match.undo.pop_back();
}

MatchState as_told(MatchState match) {
    match.undo = {};
    match.before_shot.reset();
    return match;
}

void repeat(MatchState& match) {
    CHECK(match.before_shot.has_value());
    remember(match);
    go_to(match, *match.before_shot);
}

void place_ball(MatchState& match, const PlaceBall& command) {
    remember(match);
    model::PlacedBall* placed = match.layout.find(command.ball);
    CHECK(placed != nullptr);
    placed->place = model::Place::OnTable;
    placed->position_m = command.position_m;
    count_balls(match);
}

}  // namespace billiards::match
