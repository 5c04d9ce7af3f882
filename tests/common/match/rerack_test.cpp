// Takes the last balls of a rack of straight pool; gives whether the others are racked again, and
// those in the way moved, as the rules say.
#include "common/match/rerack.h"

#include "common/model/rack.h"
#include "tests/common/match/layouts.h"
#include "tests/common/match/match_moves.h"

#include <cmath>
#include <gtest/gtest.h>

namespace billiards::match {
namespace {

using base::Vec2;
using model::kCueBall;
using model::Place;
using rules::Rerack;
using rules::Zone;

const Vec2 kFootSpot_m = model::foot_spot(nine_foot());
const Vec2 kHeadSpot_m = model::head_spot(nine_foot());
const Vec2 kCentreSpot_m{0.0, 0.0};
const Vec2 kFree_m{0.1, 0.3};
const Vec2 kElsewhere_m{-0.9, -0.2};
const Vec2 kInRack_m = kFootSpot_m + Vec2{0.05, 0.01};
const Vec2 kAlsoInRack_m = kFootSpot_m + Vec2{0.2, -0.08};
constexpr int kFifteenth = 7;

const std::vector<Vec2>& places() {
    static const std::vector<Vec2> all = model::triangle_positions(nine_foot(), kRadius_m);
    return all;
}

/// The cue ball there, and every object ball down.
model::Layout cleared(Vec2 cue_ball_m) {
    model::Layout layout = layout_of({{0, cue_ball_m}});
    for (int ball = 1; ball <= 15; ++ball) layout.balls.push_back({id(ball), Place::Pocketed, {}});
    return layout;
}

model::Layout one_left(Vec2 cue_ball_m, Vec2 fifteenth_m) {
    model::Layout layout = cleared(cue_ball_m);
    *layout.find(id(kFifteenth)) = {id(kFifteenth), Place::OnTable, fifteenth_m};
    return layout;
}

struct Reracked {
    model::Layout layout;
    Zone zone;

    Vec2 position_of(model::BallId ball) const { return layout.find(ball)->position_m; }
    Vec2 fifteenth() const { return position_of(id(kFifteenth)); }
    Vec2 cue_ball() const { return position_of(kCueBall); }
};

Reracked reracked(model::Layout layout, Rerack which, std::uint64_t seed = 1) {
    base::Random random(seed);
    const Zone zone = rerack(nine_foot(), layout, which, random);
    return {layout, zone};
}

/// How many of the rack's places, from that one on, have a ball.
int filled_from(const model::Layout& layout, std::size_t first) {
    int filled = 0;
    for (std::size_t place = first; place < places().size(); ++place) {
        const auto is_here = [&](const model::PlacedBall& placed) {
            return placed.place == Place::OnTable && placed.position_m == places()[place];
        };
        filled += static_cast<int>(std::ranges::count_if(layout.balls, is_here));
    }
    return filled;
}

void expect_fourteen_racked(const model::Layout& layout) {
    EXPECT_EQ(filled_from(layout, 0), 14);
    EXPECT_EQ(filled_from(layout, 1), 14) << "the apex is free";
    EXPECT_TRUE(layout.on_table(id(kFifteenth)));
}

void expect_cue_ball_in_hand(const Reracked& after) {
    EXPECT_EQ(after.zone, Zone::BehindHeadString);
    EXPECT_EQ(after.layout.find(kCueBall)->place, Place::InHand);
}

void expect_cue_ball_at(const Reracked& after, Vec2 position_m) {
    EXPECT_EQ(after.zone, Zone::None);
    EXPECT_TRUE(after.layout.on_table(kCueBall));
    EXPECT_EQ(after.cue_ball(), position_m);
}

TEST(RackOutline, IsTheTriangleTightAroundFifteenBalls) {
    const double row_m = std::sqrt(3.0) * kRadius_m;
    const Vec2 tip_m = kFootSpot_m - Vec2{2 * kRadius_m, 0};
    const Vec2 base_m = kFootSpot_m + Vec2{4 * row_m + kRadius_m, 0};
    // Half way along a side, and away from the rack.
    const Vec2 side_m =
        (places()[3] + places()[6]) / 2.0 + kRadius_m * Vec2{-0.5, -row_m / (2 * kRadius_m)};
    const Vec2 away{-0.5, -std::sqrt(0.75)};
    const struct {
        const char* what;
        Vec2 touches_m;
        Vec2 outwards;
    } cases[] = {
        {"tip", tip_m - Vec2{kRadius_m, 0}, {-1, 0}},
        {"base", base_m + Vec2{kRadius_m, 0}, {1, 0}},
        {"side", side_m + kRadius_m * away, away},
    };
    for (const auto& each : cases) {
        EXPECT_TRUE(is_in_rack(nine_foot(), each.touches_m - 1e-9 * each.outwards)) << each.what;
        EXPECT_FALSE(is_in_rack(nine_foot(), each.touches_m + 1e-9 * each.outwards)) << each.what;
    }
}

TEST(RackOutline, HasEveryRackedBallWithinAndTheSpotsOutside) {
    for (const Vec2& place : places()) EXPECT_TRUE(is_in_rack(nine_foot(), place));
    EXPECT_FALSE(is_in_rack(nine_foot(), kHeadSpot_m));
    EXPECT_FALSE(is_in_rack(nine_foot(), kCentreSpot_m));
    EXPECT_FALSE(is_in_rack(nine_foot(), kFootSpot_m + Vec2{0, 0.2}));
    EXPECT_FALSE(is_in_rack(nine_foot(), kFootSpot_m - Vec2{0, 0.2}));
}

TEST(RerackFourteen, LeavesTheApexFreeAndBothBallsWhereTheyAre) {
    const Reracked after = reracked(one_left(kFree_m, kElsewhere_m), Rerack::Fourteen);
    expect_fourteen_racked(after.layout);
    expect_cue_ball_at(after, kFree_m);
    EXPECT_EQ(after.fifteenth(), kElsewhere_m);
}

TEST(RerackFourteen, PutsTheFifteenthThatIsInTheRackOnTheHeadSpot) {
    const Reracked after = reracked(one_left(kFree_m, kInRack_m), Rerack::Fourteen);
    expect_fourteen_racked(after.layout);
    expect_cue_ball_at(after, kFree_m);
    EXPECT_EQ(after.fifteenth(), kHeadSpot_m);
}

TEST(RerackFourteen, PutsTheFifteenthOnTheCentreSpotWhereTheCueBallBlocksTheHeadSpot) {
    const Vec2 blocks_m = kHeadSpot_m + Vec2{0.03, 0.03};
    const Reracked after = reracked(one_left(blocks_m, kInRack_m), Rerack::Fourteen);
    expect_fourteen_racked(after.layout);
    expect_cue_ball_at(after, blocks_m);
    EXPECT_EQ(after.fifteenth(), kCentreSpot_m);

    const Vec2 beside_m = kHeadSpot_m + Vec2{0.0, 2.1 * kRadius_m};
    EXPECT_EQ(reracked(one_left(beside_m, kInRack_m), Rerack::Fourteen).fifteenth(), kHeadSpot_m);
}

TEST(RerackFourteen, TakesTheCueBallThatIsInTheRackBehindTheHeadString) {
    const Vec2 on_the_line_m{*nine_foot().head_string_m, 0.2};
    for (const Vec2& fifteenth_m : {kFree_m, on_the_line_m, kHeadSpot_m}) {
        const Reracked after = reracked(one_left(kInRack_m, fifteenth_m), Rerack::Fourteen);
        expect_fourteen_racked(after.layout);
        expect_cue_ball_in_hand(after);
        EXPECT_EQ(after.fifteenth(), fifteenth_m);
    }
}

TEST(RerackFourteen, PutsTheCueBallOnTheHeadSpotWhereTheFifteenthIsBehindTheHeadString) {
    const Reracked after = reracked(one_left(kInRack_m, kElsewhere_m), Rerack::Fourteen);
    expect_fourteen_racked(after.layout);
    expect_cue_ball_at(after, kHeadSpot_m);
    EXPECT_EQ(after.fifteenth(), kElsewhere_m);
}

TEST(RerackFourteen, PutsTheCueBallOnTheCentreSpotWhereTheFifteenthBlocksTheHeadSpot) {
    const Vec2 blocks_m = kHeadSpot_m - Vec2{0.01, 0.02};
    const Reracked after = reracked(one_left(kInRack_m, blocks_m), Rerack::Fourteen);
    expect_fourteen_racked(after.layout);
    expect_cue_ball_at(after, kCentreSpot_m);
    EXPECT_EQ(after.fifteenth(), blocks_m);
}

TEST(RerackFourteen, RacksAllFifteenWhereBothAreInTheRack) {
    const Reracked after = reracked(one_left(kInRack_m, kAlsoInRack_m), Rerack::Fourteen);
    EXPECT_EQ(filled_from(after.layout, 0), 15);
    expect_cue_ball_in_hand(after);
}

TEST(RerackFourteen, NeverLetsTwoBallsOverlap) {
    base::Random random(11);
    for (int i = 0; i < 2000; ++i) {
        const Vec2 reach_m = nine_foot().half_playing_m - kRadius_m;
        const auto anywhere = [&] {
            return Vec2{random.uniform(-reach_m.x, reach_m.x),
                        random.uniform(-reach_m.y, reach_m.y)};
        };
        const Vec2 cue_ball_m = anywhere();
        const Vec2 fifteenth_m = anywhere();
        if (glm::distance(cue_ball_m, fifteenth_m) < 2 * kRadius_m) continue;
        const model::Layout after =
            reracked(one_left(cue_ball_m, fifteenth_m), Rerack::Fourteen).layout;
        for (std::size_t a = 0; a < after.balls.size(); ++a) {
            for (std::size_t b = a + 1; b < after.balls.size(); ++b) {
                if (after.balls[a].place == Place::InHand) continue;
                const double apart_m =
                    glm::distance(after.balls[a].position_m, after.balls[b].position_m);
                ASSERT_GT(apart_m, 2 * kRadius_m - 1e-12) << i;
            }
        }
    }
}

TEST(RerackFifteen, LeavesTheCueBallUnlessItIsInTheRack) {
    const Reracked stays = reracked(cleared(kFree_m), Rerack::Fifteen);
    EXPECT_EQ(filled_from(stays.layout, 0), 15);
    expect_cue_ball_at(stays, kFree_m);

    const Reracked lifted = reracked(cleared(kInRack_m), Rerack::Fifteen);
    EXPECT_EQ(filled_from(lifted.layout, 0), 15);
    expect_cue_ball_in_hand(lifted);
}

TEST(RerackFifteen, TakesBallsFromTheTableAndLeavesACueBallInHandThere) {
    model::Layout layout = one_left(kFree_m, kElsewhere_m);
    *layout.find(id(3)) = {id(3), Place::OnTable, kInRack_m};
    *layout.find(kCueBall) = {kCueBall, Place::InHand, {}};
    const Reracked after = reracked(layout, Rerack::Fifteen);
    EXPECT_EQ(filled_from(after.layout, 0), 15);
    EXPECT_EQ(after.zone, Zone::None);
    EXPECT_EQ(after.layout.find(kCueBall)->place, Place::InHand);
}

TEST(Rerack, IsTheSameForTheSameRandomOrderAndAnotherForAnother) {
    const model::Layout layout = cleared(kFree_m);
    EXPECT_EQ(reracked(layout, Rerack::Fifteen, 5).layout,
              reracked(layout, Rerack::Fifteen, 5).layout);
    EXPECT_NE(reracked(layout, Rerack::Fifteen, 5).layout,
              reracked(layout, Rerack::Fifteen, 6).layout);
}

MatchState straight_pool() {
    Settings settings;
    settings.game = rules::Game::StraightPool;
    return placed(started(settings));
}

rules::Verdict racks(Rerack which, Zone in_hand = Zone::None) {
    rules::Verdict verdict = passes_to(model::Seat::First, in_hand);
    verdict.phase = rules::Phase::Groups;
    verdict.rerack = which;
    return verdict;
}

Result<MatchState> played(const MatchState& match, const model::Layout& layout,
                          const rules::Verdict& verdict) {
    return refold(match, match.to_act, shot_at(match, 0.0, 0.5), layout, verdict);
}

TEST(MatchRerack, GoesOnWithFifteenBallsFromWhereTheCueBallLies) {
    const MatchState match = straight_pool();
    const auto next = played(match, one_left(kFree_m, kElsewhere_m), racks(Rerack::Fourteen));
    ASSERT_TRUE(next) << next.error().detail;
    EXPECT_EQ(next->rack.on_table.size(), 15);
    EXPECT_EQ(next->rack.behind_head_string, model::BallSet{id(kFifteenth)});
    EXPECT_EQ(next->rack.in_hand, Zone::None);
    EXPECT_EQ(next->rack_number, 1);
}

TEST(MatchRerack, GivesTheCueBallInHandWhereItWasInTheRack) {
    const MatchState match = straight_pool();
    const auto next = played(match, one_left(kInRack_m, kFree_m), racks(Rerack::Fourteen));
    ASSERT_TRUE(next) << next.error().detail;
    EXPECT_EQ(next->rack.in_hand, Zone::BehindHeadString);
    EXPECT_EQ(next->layout.find(kCueBall)->place, Place::InHand);
}

TEST(MatchRerack, KeepsTheCueBallInHandThatWasRuledSo) {
    const MatchState match = straight_pool();
    const auto next = played(match, one_left(kFree_m, kElsewhere_m),
                             racks(Rerack::Fifteen, Zone::BehindHeadString));
    ASSERT_TRUE(next) << next.error().detail;
    EXPECT_EQ(filled_from(next->layout, 0), 15);
    EXPECT_EQ(next->rack.in_hand, Zone::BehindHeadString);
}

TEST(MatchRerack, HasAnotherOrderEachTime) {
    const MatchState match = straight_pool();
    const auto first = played(match, cleared(kFree_m), racks(Rerack::Fifteen));
    ASSERT_TRUE(first);
    const auto second = played(*first, cleared(kFree_m), racks(Rerack::Fifteen));
    ASSERT_TRUE(second);
    EXPECT_NE(first->layout, match.layout);
    EXPECT_NE(first->layout, second->layout);
}

TEST(MatchRerack, AnotherBreakThatWasOrderedKeepsThePointsAndTheFoulsInARow) {
    const MatchState match = straight_pool();
    rules::Verdict breaking_foul =
        offers(opponent_of(match.to_act), {rules::Choice::Accept, rules::Choice::RebreakOpponent});
    breaking_foul.phase = rules::Phase::Groups;
    breaking_foul.score_change[match.to_act] = -2;
    breaking_foul.consecutive_fouls[match.to_act] = 1;
    const auto choosing = played(match, match.layout, breaking_foul);
    ASSERT_TRUE(choosing) << choosing.error().detail;
    const Choose again{choosing->turn, rules::Choice::RebreakOpponent};
    const MatchState next = applied(*choosing, again).next;
    EXPECT_EQ(next.to_act, match.to_act);
    EXPECT_EQ(next.rack.phase, rules::Phase::Break);
    EXPECT_EQ(next.rack.scores[match.to_act], -2);
    EXPECT_EQ(next.rack.consecutive_fouls[match.to_act], 1);
    EXPECT_EQ(filled_from(next.layout, 0), 15);
}

TEST(MatchRerack, IsRefusedWhereTheJournalsBallsOrGameDoNotFit) {
    const MatchState match = straight_pool();
    const MatchState eight_ball = placed(started());
    const auto code_of = [](const Result<MatchState>& next) {
        return next ? std::nullopt : std::optional(next.error().code);
    };
    EXPECT_EQ(code_of(played(match, cleared(kFree_m), racks(Rerack::Fourteen))),
              RefusalCode::BadOutcome);
    EXPECT_EQ(code_of(played(match, match.layout, racks(Rerack::Fourteen))),
              RefusalCode::BadOutcome);
    EXPECT_EQ(code_of(played(eight_ball, eight_ball.layout, racks(Rerack::Fifteen))),
              RefusalCode::BadOutcome);
}

}  // namespace
}  // namespace billiards::match
