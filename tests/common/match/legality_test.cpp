// Takes matches and commands that are not allowed in them; gives whether each is refused for its
// reason, and the allowed ones beside it are not.
#include "common/match/match.h"
#include "tests/common/match/match_moves.h"

#include <gtest/gtest.h>
#include <limits>

namespace billiards::match {
namespace {

using model::Seat;
using rules::Choice;
using rules::Zone;

std::optional<Refusal> refusal(const MatchState& match, Seat seat, const Command& command) {
    auto step = apply(match, seat, command);
    if (step) return std::nullopt;
    return step.error();
}

std::optional<RefusalCode> code(const MatchState& match, Seat seat, const Command& command) {
    const std::optional<Refusal> refused = refusal(match, seat, command);
    return refused ? std::optional(refused->code) : std::nullopt;
}

std::optional<RefusalCode> code(const MatchState& match, const Command& command) {
    return code(match, match.to_act, command);
}

Seat other(const MatchState& match) {
    return opponent_of(match.to_act);
}

MatchState open_table() {
    const MatchState match = started();
    return told(match, passes_to(opponent_of(match.to_act)));
}

MatchState choosing() {
    const MatchState match = started();
    return told(match, offers(other(match), {Choice::Accept, Choice::RebreakSelf}));
}

std::optional<std::string> settings_refusal(const Settings& settings) {
    const auto match = start(settings, 1);
    if (match) return std::nullopt;
    EXPECT_EQ(match.error().code, RefusalCode::BadSettings);
    return match.error().detail;
}

std::optional<std::string> clock_refusal(double shot_clock_s, double break_shot_clock_s) {
    Settings settings;
    settings.shot_clock_s = shot_clock_s;
    settings.break_shot_clock_s = break_shot_clock_s;
    return settings_refusal(settings);
}

TEST(MatchSettings, RaceMustBeInItsRange) {
    EXPECT_EQ(settings_refusal(race_to(0)), "race_to must be in [1, 50], was 0");
    EXPECT_EQ(settings_refusal(race_to(51)), "race_to must be in [1, 50], was 51");
    EXPECT_EQ(settings_refusal(race_to(1)), std::nullopt);
    EXPECT_EQ(settings_refusal(race_to(50)), std::nullopt);
}

TEST(MatchSettings, ClocksMustBeInTheirRange) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(clock_refusal(-1, 60), "shot_clock_s must be in [0, 600], was -1");
    EXPECT_EQ(clock_refusal(601, 60), "shot_clock_s must be in [0, 600], was 601");
    EXPECT_EQ(clock_refusal(nan, 60), "shot_clock_s must be in [0, 600], was nan");
    EXPECT_EQ(clock_refusal(45, 601), "break_shot_clock_s must be in [0, 600], was 601");
    EXPECT_EQ(clock_refusal(0, 600), std::nullopt);
}

TEST(Legality, OnlyTheSeatToActMayAct) {
    const MatchState match = placed(started());
    EXPECT_EQ(code(match, other(match), shot_at(match, 0, 0.5)), RefusalCode::NotYourTurn);
    EXPECT_EQ(code(match, other(match), PlaceCueBall{{-1, 0}}), RefusalCode::NotYourTurn);
    EXPECT_EQ(code(match, other(match), Timeout{match.turn}), RefusalCode::NotYourTurn);
    EXPECT_EQ(code(match, shot_at(match, 0, 0.5)), std::nullopt);
}

TEST(Legality, EitherSeatMayConcede) {
    for (const Seat seat : model::kSeats) {
        EXPECT_EQ(code(started(), seat, Concede{}), std::nullopt);
    }
}

TEST(Legality, CommandForAnotherTurnIsRefusedAsStale) {
    const MatchState match = placed(open_table());
    for (const std::uint32_t turn : {match.turn.value - 1, match.turn.value + 1}) {
        const model::TurnNumber stale{turn};
        EXPECT_EQ(code(match, TakeShot{stale, {}, model::NoCall{}}), RefusalCode::StaleTurn);
        EXPECT_EQ(code(match, Timeout{stale}), RefusalCode::StaleTurn);
        EXPECT_EQ(code(choosing(), Choose{stale, Choice::Accept}), RefusalCode::StaleTurn);
    }
    EXPECT_EQ(refusal(match, match.to_act, Timeout{{9}})->detail, "meant for turn 9, it is turn 2");
}

TEST(Legality, NothingButAChoiceIsAllowedWhileOneIsDue) {
    const MatchState match = choosing();
    EXPECT_EQ(code(match, shot_at(match, 0, 0.5)), RefusalCode::WrongStage);
    EXPECT_EQ(code(match, PlaceCueBall{{0, 0}}), RefusalCode::WrongStage);
    EXPECT_EQ(code(match, Choose{match.turn, Choice::Accept}), std::nullopt);
}

TEST(Legality, ChoiceIsRefusedWhereNoneIsDueAndWhereItWasNotOffered) {
    const MatchState shooting = placed(open_table());
    EXPECT_EQ(code(shooting, Choose{shooting.turn, Choice::Accept}), RefusalCode::WrongStage);
    const MatchState match = choosing();
    EXPECT_EQ(code(match, Choose{match.turn, Choice::SpotEight}), RefusalCode::BadChoice);
    EXPECT_EQ(code(match, other(match), Choose{match.turn, Choice::Accept}),
              RefusalCode::NotYourTurn);
}

TEST(Legality, ShotWithTheCueBallInHandIsRefused) {
    const MatchState match = started();
    EXPECT_EQ(code(match, shot_at(match, 0, 0.5)), RefusalCode::CueBallNotPlaced);
}

TEST(Legality, CueBallMayBePlacedAgainWhileInHandAndNotOtherwise) {
    const MatchState match = placed(started());
    EXPECT_EQ(code(match, PlaceCueBall{{-1, 0.2}}), std::nullopt);
    const MatchState lies = open_table();
    EXPECT_EQ(code(lies, PlaceCueBall{{-1, 0.2}}), RefusalCode::NotInHand);
}

TEST(Legality, PlacementMustBeInTheZone) {
    const MatchState match = started();
    EXPECT_EQ(code(match, PlaceCueBall{{0.0, 0.0}}), RefusalCode::BadPlacement);
    EXPECT_EQ(code(match, PlaceCueBall{{-5.0, 0.0}}), RefusalCode::BadPlacement);
    EXPECT_EQ(code(match, PlaceCueBall{{-1.0, 0.0}}), std::nullopt);
}

TEST(Legality, ShotMustMakeSenseAndTheDetailSaysWhatDoesNot) {
    const MatchState match = placed(started());
    const double nan = std::numeric_limits<double>::quiet_NaN();
    struct {
        model::Shot shot;
        const char* detail;
    } const cases[] = {
        {{.power = 0.0}, "power must be in (0, 1], was 0"},
        {{.power = 1.5}, "power must be in (0, 1], was 1.5"},
        {{.power = nan}, "power must be in (0, 1], was nan"},
        {{.angle_rad = nan}, "angle_rad must be within 1000 rad, was nan"},
        {{.tip_left = 0.4, .tip_up = 0.4},
         "tip offset must be within 0.5 of the centre, was (0.4, 0.4)"},
        {{.tip_left = -2}, "tip offset must be within 0.5 of the centre, was (-2, 0)"},
        {{.elevation_rad = -0.1}, "elevation_rad must be in [0, pi/2), was -0.1"},
    };
    for (const auto& each : cases) {
        const auto refused = refusal(match, match.to_act, TakeShot{match.turn, each.shot, {}});
        EXPECT_EQ(refused, (Refusal{RefusalCode::BadShot, each.detail}));
    }
}

TEST(Legality, CallMustBeAllowedByTheGame) {
    const MatchState match = placed(open_table());
    const auto calling = [&](int ball, int pocket) {
        const model::CalledBall call{{static_cast<std::uint8_t>(ball)},
                                     {static_cast<std::uint8_t>(pocket)}};
        return refusal(match, match.to_act, shot_at(match, 0, 0.5, call));
    };
    EXPECT_EQ(calling(3, 5), std::nullopt);
    EXPECT_EQ(calling(8, 5),
              (Refusal{RefusalCode::BadCall, "ball 8 in pocket 5 may not be called now"}));
    EXPECT_EQ(calling(3, 6)->code, RefusalCode::BadCall);
    EXPECT_EQ(calling(200, 0)->code, RefusalCode::BadCall);
    const MatchState breaking = placed(started());
    EXPECT_EQ(code(breaking, shot_at(breaking, 0, 0.5, model::Safety{})), RefusalCode::BadCall);
}

TEST(Legality, NothingIsAllowedOnceTheMatchIsOver) {
    const MatchState match = applied(started(), Concede{}).next;
    const Command commands[] = {PlaceCueBall{{-1, 0}}, shot_at(match, 0, 0.5),
                                Choose{match.turn, Choice::Accept}, Timeout{match.turn}, Concede{}};
    for (const Command& command : commands) {
        for (const Seat seat : model::kSeats) {
            EXPECT_EQ(code(match, seat, command), RefusalCode::MatchOver) << command.index();
        }
    }
}

TEST(Refold, RefusesWhatApplyRefuses) {
    const MatchState match = placed(started());
    const auto stale = refold(match, match.to_act, Timeout{{9}}, std::nullopt, std::nullopt);
    ASSERT_FALSE(stale);
    EXPECT_EQ(stale.error().code, RefusalCode::StaleTurn);
}

struct OutcomeCase {
    const char* what;
    std::optional<model::Layout> layout;
    std::optional<rules::Verdict> verdict;
    const char* detail;
};

TEST(Refold, RefusesAnOutcomeThatDoesNotBelongToTheShot) {
    const MatchState match = placed(started());
    const rules::Verdict pass = passes_to(other(match));
    model::Layout fewer = match.layout;
    fewer.balls.pop_back();
    model::Layout lost = match.layout;
    lost.find(model::kCueBall)->place = model::Place::Pocketed;
    model::Layout held = match.layout;
    held.find(model::kEightBall)->place = model::Place::InHand;
    rules::Verdict spots = pass;
    spots.spotted = {model::kEightBall};
    rules::Verdict spots_unknown = pass;
    spots_unknown.spotted = {{200}};
    rules::Verdict choiceless = pass;
    choiceless.chooser = Seat::First;
    rules::Verdict chooserless = pass;
    chooserless.choices = {Choice::Accept};
    rules::Verdict split = offers(other(match), {Choice::Accept});
    split.next_player = match.to_act;

    rules::Verdict scores = pass;
    scores.score_change[match.to_act] = 1;

    const OutcomeCase cases[] = {
        {"points at eight-ball", match.layout, scores, "more points than a shot can make"},
        {"no verdict", match.layout, std::nullopt, "there is no verdict"},
        {"no layout", std::nullopt, pass, "there is no final layout"},
        {"a ball short", fewer, pass, "the layout has other balls"},
        {"an object ball in hand", held, pass, "a shot left a ball in hand"},
        {"cue ball gone", lost, pass, "the cue ball is lost"},
        {"spots a ball that is up", match.layout, spots, "a ball is spotted that is not down"},
        {"spots no ball at all", match.layout, spots_unknown, "a ball is spotted that is not down"},
        {"nothing to choose", match.layout, choiceless,
         "a chooser without choices, or choices without a chooser"},
        {"nobody to choose", match.layout, chooserless,
         "a chooser without choices, or choices without a chooser"},
        {"somebody else to choose", match.layout, split, "the chooser is not the next to act"},
    };
    for (const OutcomeCase& each : cases) {
        const auto next =
            refold(match, match.to_act, shot_at(match, 0, 0.5), each.layout, each.verdict);
        ASSERT_FALSE(next) << each.what;
        EXPECT_EQ(next.error(), (Refusal{RefusalCode::BadOutcome, each.detail})) << each.what;
    }
    EXPECT_TRUE(refold(match, match.to_act, shot_at(match, 0, 0.5), match.layout, pass));
}

TEST(Refold, RefusesAnOutcomeThatPracticeDoesNotHave) {
    Settings settings;
    settings.game = rules::Game::Practice;
    const MatchState match = placed(started(settings));
    const rules::Verdict outcomes[] = {passes_to(Seat::Second), won_by(Seat::First),
                                       offers(Seat::First, {Choice::Accept})};
    for (const rules::Verdict& verdict : outcomes) {
        const auto next =
            refold(match, match.to_act, shot_at(match, 0, 0.5), match.layout, verdict);
        ASSERT_FALSE(next);
        EXPECT_EQ(next.error(),
                  (Refusal{RefusalCode::BadOutcome, "practice has one player, who goes on"}));
    }
}

TEST(Refold, RefusesATimeoutWithoutItsRuling) {
    const MatchState match = started();
    const auto next = refold(match, match.to_act, Timeout{match.turn}, std::nullopt, std::nullopt);
    ASSERT_FALSE(next);
    EXPECT_EQ(next.error().code, RefusalCode::BadOutcome);
}

}  // namespace
}  // namespace billiards::match
