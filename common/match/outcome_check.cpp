// Takes a journalled outcome; gives done, or what in it does not fit.
#include "common/match/outcome_check.h"

#include <algorithm>
#include <cstdlib>

namespace billiards::match {

namespace {

using Checked = Result<base::Done>;

/// At straight pool: what the third foul in a row costs; fifteen balls make one less.
constexpr int kMostPointsOfAShot = 16;

Checked does_not_fit(const char* what) {
    return Refusal{RefusalCode::BadOutcome, what};
}

bool has_the_balls_of(const model::Layout& layout, const model::Layout& expected) {
    using model::PlacedBall;
    return std::ranges::equal(layout.balls, expected.balls, {}, &PlacedBall::ball,
                              &PlacedBall::ball);
}

Checked check_layout(const model::Layout& layout, const model::Layout& before) {
    if (!has_the_balls_of(layout, before)) return does_not_fit("the layout has other balls");
    if (std::ranges::count(layout.balls, model::Place::InHand, &model::PlacedBall::place) > 0) {
        return does_not_fit("a shot left a ball in hand");
    }
    return base::Done{};
}

bool can_be_spotted(const model::Layout& layout, model::BallId ball) {
    return ball != model::kCueBall && layout.find(ball) != nullptr && !layout.on_table(ball);
}

Checked check_verdict(const rules::Verdict& verdict, const model::Layout& layout) {
    const auto may_be = [&](model::BallId ball) { return can_be_spotted(layout, ball); };
    const auto& spotted = verdict.spotted;
    const bool each_once =
        std::ranges::adjacent_find(spotted, std::ranges::greater_equal{}) == spotted.end();
    if (!each_once || !std::ranges::all_of(spotted, may_be)) {
        return does_not_fit("a ball is spotted that is not down");
    }
    if (verdict.choices.empty() == verdict.chooser.has_value()) {
        return does_not_fit("a chooser without choices, or choices without a chooser");
    }
    if (verdict.chooser && verdict.chooser != verdict.next_player) {
        return does_not_fit("the chooser is not the next to act");
    }
    const bool over = verdict.winner.has_value();
    const bool playable = layout.on_table(model::kCueBall) || verdict.in_hand != rules::Zone::None;
    return over || playable ? Checked(base::Done{}) : does_not_fit("the cue ball is lost");
}

/// Fourteen are racked where one ball is left, fifteen whatever is left.
Checked check_rerack(const MatchState& state, const rules::Verdict& verdict,
                     const model::Layout& layout) {
    if (verdict.rerack == rules::Rerack::None) return base::Done{};
    if (state.settings.game != rules::Game::StraightPool) {
        return does_not_fit("only straight pool goes on with balls racked again");
    }
    const auto is_up = [](const model::PlacedBall& placed) {
        return placed.ball != model::kCueBall && placed.place == model::Place::OnTable;
    };
    const auto left = static_cast<std::size_t>(std::ranges::count_if(layout.balls, is_up));
    const bool fits =
        verdict.rerack == rules::Rerack::Fifteen || left + verdict.spotted.size() == 1;
    return fits ? Checked(base::Done{}) : does_not_fit("fourteen are racked, but not one is left");
}

/// A score cannot run away, whatever a journal says.
Checked check_scores(const MatchState& state, const rules::Verdict& verdict) {
    for (const model::Seat seat : model::kSeats) {
        const int change = verdict.score_change[seat];
        const bool counts = state.settings.game == rules::Game::StraightPool;
        if (std::abs(change) > (counts ? kMostPointsOfAShot : 0)) {
            return does_not_fit("more points than a shot can make");
        }
    }
    return base::Done{};
}

Checked check_practice(const MatchState& state, const rules::Verdict& verdict) {
    const bool goes_on = verdict.next_player == state.to_act && !verdict.chooser && !verdict.winner;
    const bool fits = state.settings.game != rules::Game::Practice || goes_on;
    return fits ? Checked(base::Done{}) : does_not_fit("practice has one player, who goes on");
}

Checked check_ruling(const MatchState& state, const rules::Verdict& verdict,
                     const model::Layout& layout) {
    if (Checked checked = check_verdict(verdict, layout); !checked) return checked;
    if (Checked checked = check_practice(state, verdict); !checked) return checked;
    if (Checked checked = check_scores(state, verdict); !checked) return checked;
    return check_rerack(state, verdict, layout);
}

}  // namespace

Checked check_outcome(const MatchState& state, const Command& command,
                      const std::optional<model::Layout>& final_layout,
                      const std::optional<rules::Verdict>& verdict) {
    const bool shot = std::holds_alternative<TakeShot>(command);
    const bool ruled_timeout =
        std::holds_alternative<Timeout>(command) && state.stage == Stage::Shooting;
    if (!shot && !ruled_timeout) return base::Done{};
    if (!verdict) return does_not_fit("there is no verdict");
    if (!shot) return check_ruling(state, *verdict, state.layout);
    if (!final_layout) return does_not_fit("there is no final layout");
    if (Checked layout = check_layout(*final_layout, state.layout); !layout) return layout;
    return check_ruling(state, *verdict, *final_layout);
}

}  // namespace billiards::match
