// Gives matches to act on, and the moves that tests make in them: some solved by the engine, some
// told with their outcome.
#pragma once

#include "common/match/match.h"
#include "common/match/placement.h"
#include "common/rules/verdict.h"
#include "tests/common/match/soundness.h"

#include <gtest/gtest.h>
#include <optional>
#include <string>
#include <utility>

namespace billiards::match {

inline MatchState started(const Settings& settings = {}, std::uint64_t seed = 1) {
    auto match = start(settings, seed);
    EXPECT_TRUE(match) << match.error().detail;
    return std::move(match).value();
}

inline Settings race_to(int racks, BreakOrder order = BreakOrder::Alternate) {
    Settings settings;
    settings.race_to = racks;
    settings.break_order = order;
    return settings;
}

inline base::Vec2 free_place(const MatchState& match) {
    return default_placement(model::table_of(match.settings.table), match.layout,
                             match.rack.in_hand);
}

inline Step applied(const MatchState& match, const Command& command) {
    auto step = apply(match, match.to_act, command);
    EXPECT_TRUE(step) << (step ? "" : step.error().detail);
    return std::move(step).value();
}

/// The match with the cue ball set down where it is in hand.
inline MatchState placed(const MatchState& match) {
    if (match.layout.on_table(model::kCueBall)) return match;
    return applied(match, PlaceCueBall{free_place(match)}).next;
}

inline TakeShot shot_at(const MatchState& match, double angle_rad, double power,
                        const model::Call& call = model::NoCall{}) {
    return {match.turn, {.angle_rad = angle_rad, .power = power}, call};
}

/// A shot with the outcome that is told, as if it came from a journal. Balls stay where they are.
inline MatchState told(const MatchState& match, const rules::Verdict& verdict) {
    const MatchState ready = placed(match);
    auto next = refold(ready, ready.to_act, shot_at(ready, 0.0, 0.5), ready.layout, verdict);
    EXPECT_TRUE(next) << (next ? "" : next.error().detail);
    return std::move(next).value();
}

inline rules::Verdict passes_to(model::Seat next, rules::Zone in_hand = rules::Zone::None) {
    rules::Verdict verdict;
    verdict.next_player = next;
    verdict.in_hand = in_hand;
    return verdict;
}

inline rules::Verdict won_by(model::Seat seat) {
    rules::Verdict verdict = passes_to(seat);
    verdict.winner = seat;
    verdict.reason = rules::Reason::EightWon;
    return verdict;
}

inline rules::Verdict offers(model::Seat chooser, std::vector<rules::Choice> choices,
                             rules::Zone in_hand = rules::Zone::None) {
    rules::Verdict verdict = passes_to(chooser, in_hand);
    verdict.chooser = chooser;
    verdict.choices = std::move(choices);
    return verdict;
}

/// The same step, from its journal entry alone.
inline MatchState folded_again(const MatchState& before, model::Seat seat, const Command& command,
                               const Outcome& outcome) {
    std::optional<model::Layout> layout;
    if (outcome.record) layout = outcome.record->final_layout;
    auto again = refold(before, seat, command, layout, outcome.verdict);
    EXPECT_TRUE(again) << (again ? "" : again.error().detail);
    return std::move(again).value();
}

inline void expect_sound(const MatchState& match) {
    EXPECT_EQ(first_fault(match), std::nullopt);
}

}  // namespace billiards::match
