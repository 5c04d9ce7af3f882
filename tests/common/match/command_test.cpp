// Takes extensions, offers, claims and nearest balls; gives whether each does what it should, and
// is refused by name where it may not be.
#include "common/match/match.h"
#include "tests/common/match/match_moves.h"

#include <gtest/gtest.h>
#include <vector>

namespace billiards::match {
namespace {

using model::Seat;
using rules::Choice;
using rules::Zone;

Seat other(const MatchState& match) {
    return opponent_of(match.to_act);
}

/// What the command is refused with; none where it is taken. The match is the same either way.
std::optional<Refusal> refusal(const MatchState& match, Seat seat, const Command& command) {
    const MatchState before = match;
    const auto step = apply(match, seat, command);
    EXPECT_EQ(match, before);
    if (step) return std::nullopt;
    return step.error();
}

MatchState done(const MatchState& match, Seat seat, const Command& command) {
    auto step = apply(match, seat, command);
    EXPECT_TRUE(step) << (step ? "" : step.error().detail);
    EXPECT_EQ(folded_again(match, seat, command, step->outcome), step->next);
    expect_sound(step->next);
    return std::move(step).value().next;
}

MatchState open_table(const Settings& settings = {}) {
    return told(started(settings), passes_to(Seat::First));
}

Settings practice() {
    Settings settings;
    settings.game = rules::Game::Practice;
    return settings;
}

struct RefusalCase {
    const char* what;
    MatchState match;
    Seat seat;
    Command command;
    Refusal refusal;
};

void expect_refused(const std::vector<RefusalCase>& cases) {
    for (const RefusalCase& each : cases) {
        EXPECT_EQ(refusal(each.match, each.seat, each.command), each.refusal) << each.what;
    }
}

TEST(MatchExtension, IsRefusedByNameWhereThereIsNone) {
    const MatchState match = open_table();
    const model::TurnNumber turn = match.turn;
    Settings off;
    off.extension_s = 0;
    Settings no_clock;
    no_clock.shot_clock_s = 0;
    const MatchState used = done(match, match.to_act, Extend{turn});
    const MatchState practising = started(practice());
    const RefusalCode none = RefusalCode::NoExtension;
    expect_refused({
        {"of another turn",
         match,
         match.to_act,
         Extend{{9}},
         {RefusalCode::StaleTurn, "meant for turn 9, it is turn 2"}},
        {"of the other seat",
         match,
         other(match),
         Extend{turn},
         {RefusalCode::NotYourTurn, "the other player is to act"}},
        {"switched off",
         open_table(off),
         match.to_act,
         Extend{turn},
         {none, "this match is played without extensions"}},
        {"no clock", open_table(no_clock), match.to_act, Extend{turn}, {none, "no clock runs"}},
        {"practice", practising, Seat::First, Extend{practising.turn}, {none, "no clock runs"}},
        {"used", used, match.to_act, Extend{turn}, {none, "this rack's extension has been used"}},
    });
}

TEST(MatchExtension, IsEachSeatsOnceARack) {
    MatchState match = open_table(race_to(2));
    match = done(match, Seat::First, Extend{match.turn});
    match = told(match, passes_to(Seat::Second));
    match = done(match, Seat::Second, Extend{match.turn});
    match = told(match, passes_to(Seat::First));
    EXPECT_EQ(refusal(match, Seat::First, Extend{match.turn})->code, RefusalCode::NoExtension);
    match = told(match, won_by(Seat::First));
    EXPECT_EQ(refusal(match, match.to_act, Extend{match.turn}), std::nullopt);
}

TEST(MatchOffer, IsRefusedByNameWhereItMayNotBeMadeOrAnswered) {
    const MatchState match = open_table();
    const model::TurnNumber turn = match.turn;
    const Offer draw{turn, OfferKind::Draw};
    const MatchState offered = done(match, Seat::Second, draw);
    const MatchState unbroken = started();
    const MatchState practising = started(practice());
    const RefusalCode bad = RefusalCode::BadOffer;
    const Refusal no_offer{RefusalCode::NoOffer, "there is no offer to answer"};
    expect_refused({
        {"of another turn",
         match,
         Seat::First,
         Offer{{9}, OfferKind::Draw},
         {RefusalCode::StaleTurn, "meant for turn 9, it is turn 2"}},
        {"a second", offered, Seat::First, draw, {bad, "another offer stands"}},
        {"nothing to play again",
         unbroken,
         Seat::First,
         Offer{unbroken.turn, OfferKind::Stalemate},
         {bad, "the rack has not been broken"}},
        {"to nobody",
         practising,
         Seat::First,
         Offer{practising.turn, OfferKind::Draw},
         {RefusalCode::WrongGame, "there is neither an opponent nor a clock"}},
        {"answer to none", match, Seat::First, Answer{turn, true}, no_offer},
        {"answer to oneself", offered, Seat::Second, Answer{turn, true}, no_offer},
        {"answer of another turn",
         offered,
         Seat::First,
         Answer{{9}, true},
         {RefusalCode::StaleTurn, "meant for turn 9, it is turn 2"}},
    });
}

TEST(MatchOffer, OfADrawThatIsAcceptedEndsTheMatchWithoutAWinner) {
    for (const Seat by : model::kSeats) {
        const MatchState match = open_table();
        const MatchState offered = done(match, by, Offer{match.turn, OfferKind::Draw});
        EXPECT_EQ(offered.turn, match.turn) << "the turn goes on";
        const MatchState drawn = done(offered, opponent_of(by), Answer{match.turn, true});
        EXPECT_EQ(drawn.stage, Stage::Over);
        EXPECT_EQ(drawn.winner, std::nullopt);
        EXPECT_EQ(drawn.offer, std::nullopt);
    }
}

TEST(MatchOffer, OfAStalemateThatIsAcceptedHasTheRackPlayedAgainByTheSameBreaker) {
    const MatchState broken = started();
    rules::Verdict fouled = passes_to(opponent_of(broken.breaker));
    fouled.consecutive_fouls = {{1, 2}};
    const MatchState match = told(broken, fouled);
    const Offer offer{match.turn, OfferKind::Stalemate};
    const MatchState again =
        done(done(match, Seat::First, offer), Seat::Second, Answer{match.turn, true});
    EXPECT_EQ(again.breaker, broken.breaker);
    EXPECT_EQ(again.to_act, broken.breaker);
    EXPECT_EQ(again.layout, broken.layout);
    EXPECT_EQ(again.rack, broken.rack) << "nobody's fouls are left";
    EXPECT_EQ(again.rack_number, broken.rack_number);
    EXPECT_GT(again.turn, match.turn);
}

TEST(MatchOffer, ThatIsDeclinedIsGoneAndNothingElse) {
    const MatchState match = open_table();
    const MatchState offered = done(match, Seat::First, Offer{match.turn, OfferKind::Draw});
    EXPECT_EQ(done(offered, Seat::Second, Answer{match.turn, false}), match);
}

TEST(MatchOffer, LapsesWithTheTurn) {
    const MatchState match = open_table();
    const MatchState offered = done(match, Seat::Second, Offer{match.turn, OfferKind::Draw});
    EXPECT_NE(placed(offered).offer, std::nullopt);
    EXPECT_EQ(told(offered, passes_to(Seat::First)).offer, std::nullopt);
    EXPECT_EQ(done(offered, match.to_act, Timeout{match.turn}).offer, std::nullopt);
    const MatchState choosing = told(started(), offers(Seat::First, {Choice::Accept}));
    const MatchState pending =
        done(choosing, Seat::Second, Offer{choosing.turn, OfferKind::Stalemate});
    EXPECT_EQ(done(pending, Seat::First, Choose{choosing.turn, Choice::Accept}).offer,
              std::nullopt);
}

TEST(MatchClaim, IsRefusedByNameWhereItMayNotBeMade) {
    const MatchState match = open_table();
    const MatchState claimed = done(match, match.to_act, ClaimStalemate{match.turn});
    const MatchState unbroken = started();
    const MatchState choosing = told(started(), offers(Seat::First, {Choice::Accept}));
    const MatchState practising = started(practice());
    const RefusalCode bad = RefusalCode::BadClaim;
    expect_refused({
        {"of another turn",
         match,
         match.to_act,
         ClaimStalemate{{9}},
         {RefusalCode::StaleTurn, "meant for turn 9, it is turn 2"}},
        {"of the other seat",
         match,
         other(match),
         ClaimStalemate{match.turn},
         {RefusalCode::NotYourTurn, "the other player is to act"}},
        {"while a choice is due",
         choosing,
         Seat::First,
         ClaimStalemate{choosing.turn},
         {RefusalCode::WrongStage, "a choice is due first"}},
        {"before the break",
         unbroken,
         unbroken.to_act,
         ClaimStalemate{unbroken.turn},
         {bad, "the rack has not been broken"}},
        {"twice",
         claimed,
         match.to_act,
         ClaimStalemate{match.turn},
         {bad, "a stalemate is claimed already"}},
        {"alone",
         practising,
         Seat::First,
         ClaimStalemate{practising.turn},
         {RefusalCode::WrongGame, "there is neither an opponent nor a clock"}},
    });
}

MatchState claimed() {
    const MatchState match = open_table();
    return done(match, match.to_act, ClaimStalemate{match.turn});
}

/// Each seat plays that many quiet turns.
MatchState quiet(MatchState match, int turns) {
    for (int i = 0; i < 2 * turns; ++i) match = told(match, passes_to(other(match)));
    return match;
}

TEST(MatchClaim, HasTheRackPlayedAgainAfterThreeQuietTurnsOfEach) {
    const MatchState almost = told(quiet(claimed(), 2), passes_to(Seat::Second));
    ASSERT_TRUE(almost.claim);
    EXPECT_EQ(*almost.claim, (model::PerSeat<int>{{3, 2}}));
    const MatchState again = told(almost, passes_to(Seat::First));
    EXPECT_EQ(again.claim, std::nullopt);
    EXPECT_EQ(again.rack.phase, rules::Phase::Break);
    EXPECT_EQ(again.to_act, almost.breaker);
    EXPECT_EQ(again.rack_number, almost.rack_number);
    expect_sound(again);
}

TEST(MatchClaim, IsVoidAfterAPotAFoulOrATimeout) {
    const MatchState match = placed(quiet(claimed(), 2));
    model::Layout potted = match.layout;
    potted.find({3})->place = model::Place::Pocketed;
    const auto after_pot =
        refold(match, match.to_act, shot_at(match, 0, 0.5), potted, passes_to(Seat::First));
    ASSERT_TRUE(after_pot);
    EXPECT_EQ(after_pot->claim, std::nullopt);
    rules::Verdict foul = passes_to(Seat::Second);
    foul.fouls = {rules::Foul::NoBallHit};
    EXPECT_EQ(told(match, foul).claim, std::nullopt);
    EXPECT_EQ(done(match, match.to_act, Timeout{match.turn}).claim, std::nullopt);
}

TEST(MatchClaim, EndsWithTheRack) {
    EXPECT_EQ(told(quiet(claimed(), 1), won_by(Seat::First)).claim, std::nullopt);
}

/// In hand behind the head string; the legal balls lie there.
MatchState blocked(std::vector<std::pair<int, base::Vec2>> behind) {
    MatchState match = placed(open_table());
    model::Layout layout = match.layout;
    for (model::PlacedBall& placed : layout.balls) {
        if (placed.ball > model::kCueBall) placed.place = model::Place::Pocketed;
    }
    for (const auto& [ball, position_m] : behind) {
        model::PlacedBall* placed = layout.find({static_cast<std::uint8_t>(ball)});
        *placed = {placed->ball, model::Place::OnTable, position_m};
    }
    auto next = refold(match, match.to_act, shot_at(match, 0, 0.5), layout,
                       passes_to(Seat::Second, Zone::BehindHeadString));
    EXPECT_TRUE(next);
    return std::move(next).value();
}

TEST(MatchSpotNearest, PutsTheLegalBallNextToTheHeadStringOnTheFootSpot) {
    const MatchState match = blocked({{3, {-1.0, 0.1}}, {11, {-0.7, -0.2}}, {8, {-0.66, 0.3}}});
    const MatchState next = done(match, Seat::Second, SpotNearest{match.turn});
    const base::Vec2 spot_m = model::foot_spot(model::table_of(match.settings.table));
    EXPECT_EQ(next.layout.find({11})->position_m, spot_m);
    EXPECT_EQ(next.layout.find({8})->position_m, base::Vec2(-0.66, 0.3)) << "not legal yet";
    EXPECT_FALSE(next.rack.behind_head_string.contains({11}));
    EXPECT_EQ(next.turn, match.turn);
    EXPECT_EQ(refusal(next, Seat::Second, SpotNearest{match.turn})->code,
              RefusalCode::NotSpottable);
}

TEST(MatchSpotNearest, IsRefusedWhereALegalBallCanBeShotAtOrTheCueBallLies) {
    const MatchState free = blocked({{3, {-1.0, 0.1}}, {11, {0.2, 0.0}}});
    const MatchState lies = open_table();
    const MatchState behind = blocked({{3, {-1.0, 0.1}}});
    const RefusalCode none = RefusalCode::NotSpottable;
    expect_refused({
        {"one is before it",
         free,
         Seat::Second,
         SpotNearest{free.turn},
         {none, "a legal ball lies before the head string"}},
        {"not in hand",
         lies,
         lies.to_act,
         SpotNearest{lies.turn},
         {none, "the cue ball is not in hand behind the head string"}},
        {"of the other seat",
         behind,
         Seat::First,
         SpotNearest{behind.turn},
         {RefusalCode::NotYourTurn, "the other player is to act"}},
        {"of another turn",
         behind,
         Seat::Second,
         SpotNearest{{9}},
         {RefusalCode::StaleTurn, "meant for turn 9, it is turn 3"}},
    });
}

TEST(MatchRematch, IsANewMatchOfTheSameSettings) {
    const MatchState over = done(open_table(race_to(5)), Seat::First, Concede{});
    const MatchState rematch = started(over.settings, over.seed + 1);
    EXPECT_EQ(rematch.settings, over.settings);
    EXPECT_EQ(rematch.racks_won, model::PerSeat<int>{});
    EXPECT_NE(rematch.layout, over.layout);
}

}  // namespace
}  // namespace billiards::match
