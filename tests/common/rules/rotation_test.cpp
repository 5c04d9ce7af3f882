// Takes told shots at nine- and ten-ball alike; gives whether push-outs and fouls in a row are
// ruled as the rules say.
#include "common/rules/rotation.h"

#include "tests/common/rules/rotation_state.h"
#include "tests/common/rules/ruling_case.h"

#include <gtest/gtest.h>

namespace billiards::rules {
namespace {

using model::NoCall;
using model::PushOut;

using Counts = model::PerSeat<int>;

/// Both games, each with the ball that wins it.
class Rotation : public testing::TestWithParam<Game> {
  protected:
    const Ruleset& rules() const { return ruleset_of(GetParam()); }
    int key_ball() const { return GetParam() == Game::NineBall ? 9 : 10; }
    model::BallSet all() const { return GetParam() == Game::NineBall ? kNineBalls : kTenBalls; }
    Verdict judged(const RackState& state, const model::Call& said, const ToldShot& shot) const {
        return rules().judge(state, {}, said, shot.facts());
    }
};

INSTANTIATE_TEST_SUITE_P(Games, Rotation, testing::Values(Game::NineBall, Game::TenBall));

const std::vector<Choice> kPlayOrPassBack{Choice::Play, Choice::PassBack};

TEST_P(Rotation, PushOutMayFollowABreakWithoutAFoulWhoeverPlaysNext) {
    const RackState state = before_break_of(all());
    EXPECT_EQ(judged(state, NoCall{}, break_driving(4)).phase, Phase::AfterBreak);
    EXPECT_EQ(judged(state, NoCall{}, break_driving(0).pots(5)).phase, Phase::AfterBreak);
    EXPECT_EQ(judged(state, NoCall{}, break_driving(4).pots(0)).phase, Phase::Groups);
    EXPECT_EQ(judged(state, NoCall{}, break_driving(3)).phase, Phase::Groups);
}

TEST_P(Rotation, PushOutIsGoneAfterTheShotThatMayBeOne) {
    const RackState state = after_break_of(all());
    EXPECT_EQ(judged(state, NoCall{}, ToldShot().hits(1).pots(1)).phase, Phase::Groups);
    EXPECT_EQ(judged(state, NoCall{}, ToldShot().pots(0)).phase, Phase::Groups);
    EXPECT_EQ(judged(state, PushOut{}, ToldShot().cushion(0)).phase, Phase::Groups);
    EXPECT_EQ(rules().judge_timeout(state).phase, Phase::Groups);
}

TEST_P(Rotation, PushOutMayBeSaidOnlyWhereItIsAllowed) {
    EXPECT_TRUE(rules().is_call_allowed(after_break_of(all()), {}, PushOut{}));
    EXPECT_FALSE(rules().is_call_allowed(with_balls(all()), {}, PushOut{}));
    EXPECT_FALSE(rules().is_call_allowed(before_break_of(all()), {}, PushOut{}));
}

TEST_P(Rotation, PushOutWaivesTheHitTheLowestBallAndTheCushion) {
    const RackState state = after_break_of(all());
    const Ruled clean = offers(Reason::PushOut, kPlayOrPassBack);
    expect_rulings(rules(),
                   {
                       {"nothing hit", state, PushOut{}, ToldShot().cushion(0), clean},
                       {"wrong ball", state, PushOut{}, ToldShot().hits(5).cushion(5), clean},
                       {"no cushion", state, PushOut{}, ToldShot().hits(1), clean},
                       {"a legal shot", state, PushOut{}, ToldShot().hits(1).cushion(1), clean},
                       {"a pot", state, PushOut{}, ToldShot().hits(1).pots(1), clean},
                   });
}

TEST_P(Rotation, OtherFoulsStandOnAPushOut) {
    const RackState state = after_break_of(all());
    expect_rulings(
        rules(),
        {
            {"scratch", state, PushOut{}, ToldShot().hits(5).pots(0), foul({Foul::Scratch})},
            {"scratch without a hit", state, PushOut{}, ToldShot().pots(0), foul({Foul::Scratch})},
            {"ball off the table", state, PushOut{}, ToldShot().leaves(5),
             foul({Foul::BallOffTable})},
        });
}

TEST_P(Rotation, BallThatWinsIsSpottedAfterAPushOutAndOthersStayDown) {
    const RackState state = after_break_of(all());
    const Verdict verdict = judged(state, PushOut{}, ToldShot().hits(1).pots(1).pots(key_ball()));
    expect_ruled(verdict, offers(Reason::PushOut, kPlayOrPassBack).spotting({key_ball()}));
}

TEST_P(Rotation, PushOutThatIsNotAllowedIsAnOrdinaryShot) {
    expect_rulings(rules(), {
                                {"later", with_balls(all()), PushOut{}, ToldShot().cushion(0),
                                 foul({Foul::NoBallHit})},
                                {"on the break", before_break_of(all()), PushOut{},
                                 break_driving(4), passes(Reason::LegalBreak)},
                                {"legal hit", with_balls(all()), PushOut{},
                                 ToldShot().hits(1).cushion(1), passes(Reason::NothingPotted)},
                            });
}

TEST_P(Rotation, PushOutThatIsAllowedButNotSaidIsNone) {
    expect_rulings(rules(), {
                                {"nothing hit", after_break_of(all()), NoCall{},
                                 ToldShot().cushion(0), foul({Foul::NoBallHit})},
                            });
}

TEST_P(Rotation, OpponentPlaysOnOrPassesBackFromWhereTheBallsLie) {
    const RackState state = after_break_of(all());
    const Verdict verdict = judged(state, PushOut{}, ToldShot().cushion(0));
    const Resolution plays{false, kOther, Zone::None, {}};
    const Resolution passes_back{false, kShooter, Zone::None, {}};
    EXPECT_EQ(rules().resolve(state, verdict, Choice::Play), plays);
    EXPECT_EQ(rules().resolve(state, verdict, Choice::PassBack), passes_back);
}

TEST_P(Rotation, CueBallInHandAsTheOfferSaysStaysSoForWhoeverPlaysOn) {
    Verdict offer = judged(after_break_of(all()), PushOut{}, ToldShot().cushion(0));
    offer.in_hand = Zone::Anywhere;
    for (const Choice choice : {Choice::Play, Choice::PassBack}) {
        EXPECT_EQ(rules().resolve({}, offer, choice).in_hand, Zone::Anywhere);
    }
}

struct CountCase {
    const char* what;
    RackState state;
    model::Call said;
    ToldShot shot;
    Counts after;
};

TEST_P(Rotation, FoulsInARowAreCountedForTheShooterAndResetByALegalShot) {
    const RackState full = with_fouls(with_balls(all()), 1, 2);
    const RackState opened = with_fouls(after_break_of(all()), 1, 2);
    const CountCase cases[] = {
        {"foul", full, NoCall{}, ToldShot().pots(0), {{2, 2}}},
        {"two fouls in one shot count once", full, NoCall{}, ToldShot().hits(5), {{2, 2}}},
        {"miss", full, NoCall{}, ToldShot().hits(1).cushion(1), {{0, 2}}},
        {"pot", full, NoCall{}, ToldShot().hits(1).pots(1), {{0, 2}}},
        {"clean push-out", opened, PushOut{}, ToldShot().cushion(0), {{0, 2}}},
        {"foul on a push-out", opened, PushOut{}, ToldShot().pots(0), {{2, 2}}},
        {"break", before_break_of(all()), NoCall{}, break_driving(4).pots(0), {{1, 0}}},
        {"illegal break", before_break_of(all()), NoCall{}, break_driving(3), {{1, 0}}},
    };
    for (const CountCase& each : cases) {
        EXPECT_EQ(judged(each.state, each.said, each.shot).consecutive_fouls, each.after)
            << each.what;
    }
}

TEST_P(Rotation, ThirdFoulInARowLosesTheRack) {
    const RackState third = with_fouls(with_balls(all()), 2);
    const RackState second = with_fouls(with_balls(all()), 1, 2);
    expect_rulings(rules(),
                   {
                       {"third", third, NoCall{}, ToldShot().pots(0),
                        loses(Reason::ThreeFouls, {Foul::Scratch, Foul::NoBallHit})},
                       {"third, and the ball that wins fell", third, NoCall{},
                        ToldShot().hits(1).pots(key_ball()).pots(0),
                        loses(Reason::ThreeFouls, {Foul::Scratch})},
                       {"on a push-out", with_fouls(after_break_of(all()), 2), PushOut{},
                        ToldShot().hits(5).pots(0), loses(Reason::ThreeFouls, {Foul::Scratch})},
                       {"second", second, NoCall{}, ToldShot().hits(1).cushion(1).pots(0),
                        foul({Foul::Scratch})},
                       {"clean after two", third, NoCall{}, ToldShot().hits(1).cushion(1),
                        passes(Reason::NothingPotted)},
                   });
}

TEST_P(Rotation, ThirdFoulInARowMayBeTheClocks) {
    const RackState third = with_fouls(with_balls(all()), 2);
    expect_ruled(rules().judge_timeout(third), loses(Reason::ThreeFouls, {Foul::Clock}));
    expect_ruled(rules().judge_timeout(with_fouls(before_break_of(all()), 2)),
                 loses(Reason::ThreeFouls, {Foul::Clock}));
}

TEST(LowestBall, IsTheOneWithTheLowestNumberAndNoneOfNone) {
    EXPECT_EQ(lowest_ball(balls({3, 7, 9})), balls({3}));
    EXPECT_EQ(lowest_ball(balls({9})), balls({9}));
    EXPECT_EQ(lowest_ball({}), balls({}));
}

}  // namespace
}  // namespace billiards::rules
