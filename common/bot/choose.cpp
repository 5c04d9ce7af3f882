// Takes a match; gives the next command of its seat to act: a choice, a placement or a shot.
#include "common/bot/choose.h"

#include "common/base/check.h"
#include "common/bot/candidates.h"
#include "common/bot/evaluate.h"
#include "common/bot/shot_search.h"
#include "common/match/placement.h"
#include "common/model/table_spec.h"
#include "common/rules/ruleset.h"

#include <algorithm>

namespace billiards::bot {

namespace {

using base::Vec2;
using match::MatchState;
using rules::Choice;

/// The least outlook at which the table is taken as it lies.
constexpr double kGoodOutlook = 0.5;
/// Places looked at with the cue ball in hand, besides those for straight pots.
constexpr int kGridColumns = 8;
constexpr int kGridRows = 5;

Choice choose_choice(const MatchState& state) {
    const std::vector<Choice>& offered = state.pending->verdict.choices;
    const auto is_offered = [&](Choice choice) {
        return std::ranges::find(offered, choice) != offered.end();
    };
    for (const Choice as_it_lies : {Choice::Accept, Choice::Play}) {
        if (is_offered(as_it_lies) && outlook(state) >= kGoodOutlook) return as_it_lies;
    }
    const Choice preferred[] = {Choice::SpotEight, Choice::BallInHandBehindHeadString,
                                Choice::RebreakSelf, Choice::PassBack};
    const auto first = std::ranges::find_if(preferred, is_offered);
    return first != std::end(preferred) ? *first : offered.front();
}

std::vector<Vec2> grid_places(const model::TableSpec& table) {
    std::vector<Vec2> places_m;
    for (int column = 0; column < kGridColumns; ++column) {
        for (int row = 0; row < kGridRows; ++row) {
            const Vec2 part{(2.0 * column + 1) / kGridColumns - 1, (2.0 * row + 1) / kGridRows - 1};
            places_m.push_back(part * table.half_playing_m);
        }
    }
    return places_m;
}

/// The allowed place that sees the easiest pot.
Vec2 choose_place(const MatchState& state) {
    const model::TableSpec& table = model::table_of(state.settings.table);
    Vec2 best_m = match::default_placement(table, state.layout, state.rack.in_hand);
    if (state.rack.phase == rules::Phase::Break) return best_m;
    const rules::Ruleset& rules = rules::ruleset_of(state.settings.game);
    const model::BallSet targets = rules.legal_first_balls(state.rack);
    std::vector<Vec2> places_m = straight_in_places(table, state.layout, targets);
    const std::vector<Vec2> grid_m = grid_places(table);
    places_m.insert(places_m.end(), grid_m.begin(), grid_m.end());
    double best_margin_rad = 0.0;
    for (const Vec2 place_m : places_m) {
        if (!match::check_placement(table, state.layout, state.rack.in_hand, place_m)) continue;
        const std::vector<Pot> pots = pots_from(table, state.layout, targets, place_m);
        if (pots.empty() || pots.front().margin_rad <= best_margin_rad) continue;
        best_margin_rad = pots.front().margin_rad;
        best_m = place_m;
    }
    return best_m;
}

}  // namespace

match::Command choose(const MatchState& state, base::Random& random) {
    CHECK(state.stage != match::Stage::Over);
    if (state.stage == match::Stage::Choosing) {
        return match::Choose{state.turn, choose_choice(state)};
    }
    if (state.rack.on_table.empty()) return match::Concede{};  // Practice is done.
    if (!state.layout.on_table(model::kCueBall)) return match::PlaceCueBall{choose_place(state)};
    if (state.rack.phase == rules::Phase::Break) return break_shot(state, random);
    return best_shot(state);
}

}  // namespace billiards::bot
