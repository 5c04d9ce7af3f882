// Takes a match; gives what is wrong with it.
#include "tests/common/match/soundness.h"

#include "common/match/placement.h"
#include "common/model/table_spec.h"

#include <array>
#include <cstdlib>

namespace billiards::match {

namespace {

using model::kCueBall;
using model::Place;
using model::PlacedBall;
using model::Seat;
using rules::Game;
using rules::Zone;

constexpr double kRadius_m = model::BallSpec{}.radius_m;
constexpr double kOverlap_m = 1e-9;
constexpr std::size_t kBallsOfGame[] = {16, 10, 11, 16, 16};

struct Fact {
    bool holds;
    const char* otherwise;
};

bool balls_are_each_there_once(const MatchState& match) {
    const auto& balls = match.layout.balls;
    if (balls.size() != kBallsOfGame[static_cast<std::size_t>(match.settings.game)]) return false;
    for (std::size_t i = 0; i < balls.size(); ++i) {
        if (balls[i].ball.number != i) return false;
        if (i > 0 && balls[i].place == Place::InHand) return false;
    }
    return true;
}

bool balls_are_apart(const model::Layout& layout) {
    for (const PlacedBall& one : layout.balls) {
        for (const PlacedBall& other : layout.balls) {
            const bool both = one.place == Place::OnTable && other.place == Place::OnTable;
            if (!both || one.ball == other.ball) continue;
            const double distance_m = glm::distance(one.position_m, other.position_m);
            if (distance_m < 2 * kRadius_m - kOverlap_m) return false;
        }
    }
    return true;
}

bool balls_are_counted(const MatchState& match) {
    model::BallSet on_table;
    for (const PlacedBall& placed : match.layout.balls) {
        const bool counts = placed.place == Place::OnTable && placed.ball != kCueBall;
        if (counts) on_table.insert(placed.ball);
    }
    const model::TableSpec& table = model::table_of(match.settings.table);
    return match.rack.on_table == on_table &&
           match.rack.behind_head_string == balls_behind_head_string(table, match.layout);
}

bool cue_ball_can_be_played(const MatchState& match) {
    if (match.stage == Stage::Over) return true;
    const Place place = match.layout.find(kCueBall)->place;
    const bool in_hand = place == Place::InHand && match.rack.in_hand != Zone::None;
    return in_hand || place == Place::OnTable;
}

bool groups_fit_the_phase(const MatchState& match) {
    const bool has_groups = match.rack.groups.has_value();
    if (match.settings.game != Game::EightBall) return !has_groups;
    return has_groups == (match.rack.phase == rules::Phase::Groups);
}

bool scores_are_within_the_race(const MatchState& match) {
    int racks = 0;
    for (const Seat seat : model::kSeats) {
        racks += match.racks_won[seat];
        const bool has_won = match.racks_won[seat] == match.settings.race_to;
        if (match.racks_won[seat] > match.settings.race_to) return false;
        if (has_won && match.winner != seat) return false;
        const bool is_running = match.stage != Stage::Over;
        const int points = match.rack.scores[seat];
        if (match.settings.game != Game::StraightPool && points != 0) return false;
        if (is_running && points >= match.settings.options.target_points) return false;
    }
    return racks == match.rack_number - 1 || racks == match.rack_number;
}

bool claim_is_open(const MatchState& match) {
    if (!match.claim) return true;
    const auto& turns = *match.claim;
    return turns[Seat::First] < kTurnsOfClaim || turns[Seat::Second] < kTurnsOfClaim;
}

}  // namespace

std::optional<std::string> first_fault(const MatchState& match) {
    const bool over = match.stage == Stage::Over;
    const bool practice = match.settings.game == Game::Practice;
    const Fact facts[] = {
        {balls_are_each_there_once(match), "not each ball once"},
        {balls_are_apart(match.layout), "balls overlap"},
        {balls_are_counted(match), "the balls are counted wrongly"},
        {cue_ball_can_be_played(match), "the cue ball is lost"},
        {over || match.rack.shooter == match.to_act, "two may act"},
        {!practice || match.to_act == Seat::First, "practice has an opponent"},
        {over || !match.winner, "won before it was over"},
        {match.pending.has_value() == (match.stage == Stage::Choosing), "a choice without a stage"},
        {groups_fit_the_phase(match), "groups do not fit the phase"},
        {match.rack.push_out_allowed == (match.rack.phase == rules::Phase::AfterBreak),
         "a push-out at the wrong time"},
        {scores_are_within_the_race(match), "the score is outside the race"},
        {claim_is_open(match), "a stalemate was not played again"},
        {match.undo.size() <= kMostUndone, "practice remembers too much"},
    };
    for (const Fact& fact : facts) {
        if (!fact.holds) return fact.otherwise;
    }
    return std::nullopt;
}

std::optional<std::string> first_fault(const MatchState& before, Seat seat, const Command& command,
                                       const Step& step) {
    const auto& [next, outcome] = step;
    std::optional<model::Layout> layout;
    if (outcome.record) layout = outcome.record->final_layout;
    const auto again = refold(before, seat, command, layout, outcome.verdict);
    if (!again) return "its journal is refused: " + again.error().detail;
    if (*again != next) return "its journal tells of another match";
    return first_fault(next);
}

}  // namespace billiards::match
