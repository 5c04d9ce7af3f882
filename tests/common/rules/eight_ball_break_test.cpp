// Takes told breaks at eight-ball; gives whether the ruling, and what follows from each choice, is
// that of the rules.
#include "tests/common/rules/eight_ball_state.h"

#include <gtest/gtest.h>

namespace billiards::rules {
namespace {

using model::NoCall;

const std::vector<Choice> kNoChoice;
const std::vector<Choice> kRebreakChoices{Choice::Accept, Choice::RebreakSelf,
                                          Choice::RebreakOpponent};
const std::vector<Choice> kEightChoices{Choice::SpotEight, Choice::RebreakSelf};
const std::vector<Choice> kBreakFoulChoices{Choice::Accept, Choice::BallInHandBehindHeadString};

ToldShot break_driving(int object_balls) {
    ToldShot shot;
    shot.hits(1);
    for (int ball = 1; ball <= object_balls; ++ball) shot.cushion(ball);
    return shot;
}

struct BreakCase {
    const char* what;
    ToldShot shot;
    Reason reason;
    std::vector<Foul> fouls;
    model::Seat next_player;
    Zone in_hand;
    std::vector<Choice> choices;
};

void expect_rulings(std::initializer_list<BreakCase> cases) {
    for (const BreakCase& each : cases) {
        SCOPED_TRACE(each.what);
        const Verdict verdict = judged(at_break(), NoCall{}, each.shot);
        EXPECT_EQ(verdict.reason, each.reason);
        EXPECT_EQ(verdict.fouls, each.fouls);
        EXPECT_EQ(verdict.next_player, each.next_player);
        EXPECT_EQ(verdict.in_hand, each.in_hand);
        EXPECT_EQ(verdict.choices, each.choices);
        std::optional<model::Seat> chooser;
        if (!each.choices.empty()) chooser = each.next_player;
        EXPECT_EQ(verdict.chooser, chooser);
        const bool plays_on = each.next_player == kShooter && each.choices.empty();
        EXPECT_EQ(verdict.turn_continues, plays_on);
        EXPECT_EQ(verdict.groups, std::nullopt);
        EXPECT_EQ(verdict.winner, std::nullopt);
    }
}

TEST(EightBallBreak, IsLegalWithFourObjectBallsToCushionsOrAPot) {
    expect_rulings({
        {"four to cushions",
         break_driving(4),
         Reason::LegalBreak,
         {},
         kOther,
         Zone::None,
         kNoChoice},
        {"one pocketed",
         break_driving(0).pots(5),
         Reason::BreakPot,
         {},
         kShooter,
         Zone::None,
         kNoChoice},
    });
}

TEST(EightBallBreak, AnyBallMayBeHitFirst) {
    expect_rulings({
        {"the 8",
         ToldShot().hits(8).pots(5),
         Reason::BreakPot,
         {},
         kShooter,
         Zone::None,
         kNoChoice},
        {"a stripe",
         ToldShot().hits(12).pots(5),
         Reason::BreakPot,
         {},
         kShooter,
         Zone::None,
         kNoChoice},
    });
}

TEST(EightBallBreak, IsIllegalWithThreeToCushionsAndTheOpponentChooses) {
    expect_rulings({
        {"three to cushions",
         break_driving(3),
         Reason::IllegalBreak,
         {Foul::IllegalBreak},
         kOther,
         Zone::None,
         kRebreakChoices},
        {"the cue ball is not an object ball",
         break_driving(3).cushion(0),
         Reason::IllegalBreak,
         {Foul::IllegalBreak},
         kOther,
         Zone::None,
         kRebreakChoices},
        {"the same ball counts once",
         break_driving(3).cushion(1).cushion(1),
         Reason::IllegalBreak,
         {Foul::IllegalBreak},
         kOther,
         Zone::None,
         kRebreakChoices},
        {"nothing hit",
         ToldShot().cushion(0),
         Reason::IllegalBreak,
         {Foul::NoBallHit, Foul::IllegalBreak},
         kOther,
         Zone::None,
         kRebreakChoices},
    });
}

TEST(EightBallBreak, BallOffTheTableCountsAsDrivenToACushion) {
    expect_rulings({
        {"with three others",
         break_driving(3).leaves(4),
         Reason::BreakFoul,
         {Foul::BallOffTable},
         kOther,
         Zone::None,
         kBreakFoulChoices},
        {"with two others",
         break_driving(2).leaves(4),
         Reason::IllegalBreak,
         {Foul::BallOffTable, Foul::IllegalBreak},
         kOther,
         Zone::None,
         kRebreakChoices},
    });
}

TEST(EightBallBreak, IllegalBreakOutranksAScratchAndTheCueBallIsInHandBehindTheHeadString) {
    expect_rulings({
        {"scratch",
         break_driving(3).pots(0),
         Reason::IllegalBreak,
         {Foul::Scratch, Foul::IllegalBreak},
         kOther,
         Zone::BehindHeadString,
         kRebreakChoices},
    });
}

TEST(EightBallBreak, ScratchGivesBallInHandBehindTheHeadStringAndNoChoice) {
    expect_rulings({
        {"cue ball pocketed",
         break_driving(4).pots(0),
         Reason::Foul,
         {Foul::Scratch},
         kOther,
         Zone::BehindHeadString,
         kNoChoice},
        {"cue ball off the table",
         break_driving(4).leaves(0),
         Reason::Foul,
         {Foul::Scratch},
         kOther,
         Zone::BehindHeadString,
         kNoChoice},
        {"after a pot",
         break_driving(0).pots(5).pots(0),
         Reason::Foul,
         {Foul::Scratch},
         kOther,
         Zone::BehindHeadString,
         kNoChoice},
        {"with an object ball off",
         break_driving(4).leaves(5).pots(0),
         Reason::Foul,
         {Foul::Scratch, Foul::BallOffTable},
         kOther,
         Zone::BehindHeadString,
         kNoChoice},
    });
}

TEST(EightBallBreak, ObjectBallOffTheTableLetsTheOpponentAcceptOrTakeTheCueBallInHand) {
    expect_rulings({
        {"four to cushions",
         break_driving(4).leaves(5),
         Reason::BreakFoul,
         {Foul::BallOffTable},
         kOther,
         Zone::None,
         kBreakFoulChoices},
        {"after a pot",
         break_driving(0).pots(5).leaves(6),
         Reason::BreakFoul,
         {Foul::BallOffTable},
         kOther,
         Zone::None,
         kBreakFoulChoices},
    });
}

TEST(EightBallBreak, EightDownLegallyLetsTheBreakerSpotItOrBreakAgain) {
    expect_rulings({
        {"alone",
         break_driving(0).pots(8),
         Reason::EightOnBreak,
         {},
         kShooter,
         Zone::None,
         kEightChoices},
        {"with others",
         break_driving(4).pots(8).pots(3),
         Reason::EightOnBreak,
         {},
         kShooter,
         Zone::None,
         kEightChoices},
    });
}

TEST(EightBallBreak, EightDownWithAFoulLetsTheOpponentSpotItOrBreak) {
    expect_rulings({
        {"scratch",
         break_driving(0).pots(8).pots(0),
         Reason::EightOnFoulBreak,
         {Foul::Scratch},
         kOther,
         Zone::BehindHeadString,
         kEightChoices},
        {"ball off the table",
         break_driving(0).pots(8).leaves(3),
         Reason::EightOnFoulBreak,
         {Foul::BallOffTable},
         kOther,
         Zone::BehindHeadString,
         kEightChoices},
    });
}

TEST(EightBallBreak, EightThatIsLostIsLeftOutOfTheSpottedWhileAChoiceIsOpen) {
    EXPECT_TRUE(judged(at_break(), NoCall{}, break_driving(0).pots(8)).spotted.empty());
    EXPECT_TRUE(judged(at_break(), NoCall{}, break_driving(4).leaves(8)).spotted.empty());
    EXPECT_TRUE(judged(at_break(), NoCall{}, break_driving(2).leaves(8)).spotted.empty());
}

TEST(EightBallBreak, EightOffTheTableIsSpottedAndThenAsAnyBallOffTheTable) {
    expect_rulings({
        {"no scratch",
         break_driving(4).leaves(8),
         Reason::BreakFoul,
         {Foul::BallOffTable},
         kOther,
         Zone::None,
         kBreakFoulChoices},
    });
    const std::vector<model::BallId> eight{model::kEightBall};
    EXPECT_EQ(judged(at_break(), NoCall{}, break_driving(4).leaves(8).pots(0)).spotted, eight);
    EXPECT_TRUE(judged(at_break(), NoCall{}, break_driving(4).leaves(7).pots(0)).spotted.empty());
}

TEST(EightBallBreak, LeavesTheTableOpenWhateverFell) {
    const Verdict verdict = judged(at_break(), NoCall{}, break_driving(0).pots(1).pots(2));
    EXPECT_EQ(verdict.groups, std::nullopt);
}

TEST(EightBallBreak, NothingMayBeCalled) {
    EXPECT_TRUE(eight_ball().is_call_allowed(at_break(), {}, NoCall{}));
    EXPECT_FALSE(eight_ball().is_call_allowed(at_break(), {}, model::Safety{}));
    EXPECT_FALSE(eight_ball().is_call_allowed(at_break(), {}, call(1)));
}

TEST(EightBallBreak, ClockRunOutBeforeItLetsTheOtherPlayerBreak) {
    const Verdict verdict = eight_ball().judge_timeout(at_break());
    EXPECT_EQ(verdict.reason, Reason::ClockRanOut);
    EXPECT_EQ(verdict.fouls, std::vector{Foul::Clock});
    EXPECT_EQ(verdict.next_player, kOther);
    EXPECT_EQ(verdict.in_hand, Zone::BehindHeadString);
    EXPECT_FALSE(verdict.turn_continues);
}

struct ChoiceCase {
    const char* what;
    ToldShot shot;
    Choice choice;
    Resolution expected;
};

TEST(EightBallBreak, EachChoiceLeadsWhereItSays) {
    const Zone behind = Zone::BehindHeadString;
    const std::vector<model::BallId> none;
    const std::vector<model::BallId> eight{model::kEightBall};
    const ChoiceCase cases[] = {
        {"accept in position",
         break_driving(3),
         Choice::Accept,
         {false, kOther, Zone::None, eight}},
        {"accept after a scratch",
         break_driving(3).pots(0),
         Choice::Accept,
         {false, kOther, behind, eight}},
        {"break oneself", break_driving(3), Choice::RebreakSelf, {true, kOther, behind, none}},
        {"let the breaker break again",
         break_driving(3),
         Choice::RebreakOpponent,
         {true, kShooter, behind, none}},
        {"breaker spots the 8",
         break_driving(0).pots(8),
         Choice::SpotEight,
         {false, kShooter, Zone::None, eight}},
        {"breaker breaks again",
         break_driving(0).pots(8),
         Choice::RebreakSelf,
         {true, kShooter, behind, none}},
        {"opponent spots the 8",
         break_driving(0).pots(8).pots(0),
         Choice::SpotEight,
         {false, kOther, behind, eight}},
        {"opponent breaks",
         break_driving(0).pots(8).pots(0),
         Choice::RebreakSelf,
         {true, kOther, behind, none}},
        {"accept a ball off the table",
         break_driving(4).leaves(5),
         Choice::Accept,
         {false, kOther, Zone::None, eight}},
        {"take the cue ball in hand",
         break_driving(4).leaves(5),
         Choice::BallInHandBehindHeadString,
         {false, kOther, behind, eight}},
    };
    for (const ChoiceCase& each : cases) {
        const Verdict verdict = judged(at_break(), NoCall{}, each.shot);
        EXPECT_EQ(eight_ball().resolve(at_break(), verdict, each.choice), each.expected)
            << each.what;
    }
}

}  // namespace
}  // namespace billiards::rules
