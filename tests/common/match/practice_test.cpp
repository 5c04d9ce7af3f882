// Takes practice move by move; gives whether its player can place, undo, repeat and rack again.
#include "common/match/practice.h"

#include "common/match/match.h"
#include "tests/common/match/match_moves.h"

#include <gtest/gtest.h>

namespace billiards::match {
namespace {

using model::kCueBall;
using model::Place;
using model::Seat;
using rules::Zone;

MatchState practising() {
    Settings settings;
    settings.game = rules::Game::Practice;
    return started(settings, 3);
}

MatchState done(const MatchState& match, const Command& command) {
    const MatchState next = applied(match, command).next;
    expect_sound(next);
    return next;
}

/// The break, solved by the engine.
MatchState broken(const MatchState& match) {
    const MatchState ready = placed(match);
    return done(ready, shot_at(ready, 0.0, 1.0));
}

std::optional<Refusal> refusal(const MatchState& match, Seat seat, const Command& command) {
    const MatchState before = match;
    const auto step = apply(match, seat, command);
    EXPECT_EQ(match, before);
    if (step) return std::nullopt;
    return step.error();
}

TEST(Practice, IsAlwaysTheFirstSeatsTurn) {
    for (std::uint64_t seed = 0; seed < 8; ++seed) {
        Settings settings;
        settings.game = rules::Game::Practice;
        EXPECT_EQ(started(settings, seed).to_act, Seat::First);
    }
    const MatchState match = broken(practising());
    EXPECT_EQ(match.to_act, Seat::First);
    EXPECT_TRUE(match.pending == std::nullopt);
}

TEST(Practice, PlacesAnyBallAnywhereAlsoFromThePocket) {
    MatchState match = broken(practising());
    const base::Vec2 far_m{1.1, 0.5};
    const base::Vec2 near_m{-1.1, -0.5};
    match.layout.find({3})->place = Place::Pocketed;
    const MatchState back = applied(match, PlaceBall{{3}, near_m}).next;
    EXPECT_TRUE(back.layout.on_table({3}));
    EXPECT_EQ(back.layout.find({3})->position_m, near_m);
    EXPECT_TRUE(back.rack.on_table.contains({3}));
    EXPECT_TRUE(back.rack.behind_head_string.contains({3}));
    const MatchState cue = applied(back, PlaceBall{kCueBall, far_m}).next;
    EXPECT_EQ(cue.layout.find(kCueBall)->position_m, far_m);
    EXPECT_EQ(cue.turn, match.turn);
}

TEST(Practice, RefusesAPlaceThatIsNone) {
    const MatchState match = placed(practising());
    const base::Vec2 apex_m = model::foot_spot(model::table_of(match.settings.table));
    const base::Vec2 cue_m = match.layout.find(kCueBall)->position_m;
    const struct {
        PlaceBall place;
        const char* why;
    } cases[] = {{{{3}, {5, 0}}, "(5, 0) m is not inside the cushions"},
                 {{{17}, {0, 0}}, "there is no ball 17"}};
    for (const auto& each : cases) {
        EXPECT_EQ(refusal(match, Seat::First, each.place),
                  (Refusal{RefusalCode::BadPlacement, each.why}));
    }
    for (const auto& [ball, on_m] : {std::pair{kCueBall, apex_m}, {model::BallId{3}, cue_m}}) {
        const auto refused = refusal(match, Seat::First, PlaceBall{ball, on_m});
        ASSERT_TRUE(refused);
        EXPECT_EQ(refused->code, RefusalCode::BadPlacement) << "it overlaps another";
    }
}

TEST(Practice, MayPlaceABallWhereItLies) {
    const MatchState match = placed(practising());
    const base::Vec2 cue_m = match.layout.find(kCueBall)->position_m;
    EXPECT_EQ(refusal(match, Seat::First, PlaceBall{kCueBall, cue_m + 0.001}), std::nullopt);
}

TEST(Practice, IsToldWithoutWhatLiesBehindAnUndo) {
    const MatchState racked = done(broken(practising()), Rerack{});
    ASSERT_FALSE(racked.undo.empty());
    ASSERT_TRUE(racked.before_shot);
    const MatchState told = as_told(racked);
    EXPECT_TRUE(told.undo.empty());
    EXPECT_FALSE(told.before_shot);
    EXPECT_EQ(told.layout, racked.layout);
}

TEST(Practice, UndoesShotsPlacementsAndRacks) {
    const MatchState ready = placed(practising());
    const MatchState shot = done(ready, shot_at(ready, 0.0, 1.0));
    const MatchState moved = done(shot, PlaceBall{kCueBall, {-1.2, 0.5}});
    const MatchState racked = done(moved, Rerack{});
    EXPECT_EQ(racked.layout, practising().layout);
    EXPECT_EQ(racked.rack.phase, rules::Phase::Break);

    const MatchState one_back = done(racked, Undo{});
    EXPECT_EQ(one_back.layout, moved.layout);
    const MatchState two_back = done(one_back, Undo{});
    EXPECT_EQ(two_back.layout, shot.layout);
    const MatchState all_back = done(two_back, Undo{});
    EXPECT_EQ(all_back.layout, ready.layout);
    EXPECT_EQ(all_back.rack, ready.rack) << "the break is to be played again";
    EXPECT_GT(all_back.turn, racked.turn) << "a shot at what lay there is stale";
    EXPECT_EQ(refusal(all_back, Seat::First, Undo{}),
              (Refusal{RefusalCode::NothingToUndo, "there is nothing to undo"}));
}

TEST(Practice, KeepsSoManyPositionsAndNoMore) {
    MatchState match = placed(practising());
    for (std::size_t i = 0; i < kMostUndone + 5; ++i) {
        match = done(match, PlaceBall{kCueBall, {-1.2, 0.02 * static_cast<double>(i)}});
    }
    for (std::size_t i = 0; i < kMostUndone; ++i) match = done(match, Undo{});
    EXPECT_EQ(match.layout.find(kCueBall)->position_m, base::Vec2(-1.2, 0.02 * 4));
    EXPECT_EQ(refusal(match, Seat::First, Undo{})->code, RefusalCode::NothingToUndo);
}

TEST(Practice, RepeatsTheLastShotFromWhereTheBallsLay) {
    const MatchState ready = placed(practising());
    EXPECT_EQ(refusal(ready, Seat::First, Repeat{}),
              (Refusal{RefusalCode::NothingToUndo, "no shot has been played"}));
    const MatchState shot = done(ready, shot_at(ready, 0.0, 1.0));
    const MatchState moved = done(shot, PlaceBall{kCueBall, {-1.2, 0.5}});
    const MatchState again = done(moved, Repeat{});
    EXPECT_EQ(again.layout, ready.layout);
    EXPECT_EQ(again.rack, ready.rack);
    EXPECT_EQ(done(again, shot_at(again, 0.0, 1.0)).layout, shot.layout);
    EXPECT_EQ(done(again, Undo{}).layout, moved.layout);
}

TEST(Practice, HasNoClock) {
    const MatchState match = practising();
    EXPECT_EQ(refusal(match, Seat::First, Timeout{match.turn})->code, RefusalCode::WrongGame);
}

TEST(Practice, EndsWithoutAWinnerWhereItIsConceded) {
    const MatchState over = done(broken(practising()), Concede{});
    EXPECT_EQ(over.stage, Stage::Over);
    EXPECT_EQ(over.winner, std::nullopt);
}

TEST(Practice, IsItsPlayersAlone) {
    const MatchState match = broken(practising());
    const Command commands[] = {PlaceBall{kCueBall, {0, 0.5}}, Undo{}, Repeat{}, Rerack{}};
    for (const Command& command : commands) {
        EXPECT_EQ(refusal(match, Seat::Second, command)->code, RefusalCode::NotYourTurn);
        EXPECT_EQ(refusal(started(), started().to_act, command),
                  (Refusal{RefusalCode::WrongGame, "only in practice"}));
    }
}

}  // namespace
}  // namespace billiards::match
