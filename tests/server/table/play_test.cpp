// Holds a match over the table: who may do what when, and who is told.
#include "tests/server/support/game_test.h"

#include <cmath>
#include <gtest/gtest.h>
#include <limits>

namespace billiards::server {
namespace {

using model::Seat;

class PlayTest : public MatchTest {};

TEST_F(PlayTest, StartsWhenBothAreReady) {
    seat_players();
    say(ada, client::Ready{});
    EXPECT_TRUE(last<told::SeatChanged>(grace).seats[Seat::First].ready);
    EXPECT_EQ(count<told::MatchStarted>(ada), 0U);
    say(grace, client::Ready{});
    for (const SessionId session : {ada, grace, linus}) {
        EXPECT_EQ(count<told::MatchStarted>(session), 1U);
    }
    EXPECT_EQ(lobby->stats().matches_running, 1U);
}

TEST_F(PlayTest, NeverTellsTheSeed) {
    start_match();
    EXPECT_EQ(last<told::MatchStarted>(ada).state.seed, 0U);
    take_turn(1);
    EXPECT_EQ(last<told::ShotPlayed>(ada).after.seed, 0U);
    const SessionId late = greet("Late");
    say(late, client::Join{table, Role::Spectator});
    EXPECT_EQ(last<told::TableSnapshot>(late).match->seed, 0U);
}

TEST_F(PlayTest, RefusesReadyDuringAMatch) {
    start_match();
    say(ada, client::Ready{});
    EXPECT_EQ(refusal(ada), RefusedCode::MatchRunning);
}

TEST_F(PlayTest, RefusesAShotBeforeAMatch) {
    seat_players();
    say(ada, client::TakeShot{});
    EXPECT_EQ(refusal(ada), RefusedCode::NotInThisPhase);
}

TEST_F(PlayTest, GivesEveryoneTheSameShotInTheSameFrame) {
    start_match();
    take_turn(17);
    const auto frames = outbox.frames<told::ShotPlayed>(ada);
    ASSERT_EQ(frames.size(), 1U);
    EXPECT_EQ(outbox.frames<told::ShotPlayed>(grace), frames);
    EXPECT_EQ(outbox.frames<told::ShotPlayed>(linus), frames);

    const auto played = last<told::ShotPlayed>(linus);
    EXPECT_EQ(played.shot_id, 17U);
    EXPECT_GT(played.record.duration_s, 0.0);
    EXPECT_EQ(played.after.shots_played, 1);
    EXPECT_EQ(played.commit_us, 3000U);
    EXPECT_EQ(lobby->stats().shots, 1U);
}

TEST_F(PlayTest, OpensTheNextTurnWhenTheBallsRest) {
    start_match();
    take_turn(1);
    const auto played = last<told::ShotPlayed>(ada);
    EXPECT_EQ(played.turn.opens_us - played.struck_us,
              base::duration_of(played.record.duration_s).count());
    EXPECT_EQ(played.turn.deadline_us, std::nullopt);
    pass(base::Instant{base::Duration{played.turn.opens_us}} - now - 1us);
    EXPECT_EQ(count<told::TurnOpened>(ada), 0U);
    pass(1us);
    const auto opened = last<told::TurnOpened>(ada);
    EXPECT_EQ(opened.number, played.after.turn);
    EXPECT_EQ(opened.turn.opens_us, played.turn.opens_us);
    EXPECT_TRUE(opened.turn.deadline_us.has_value());
}

TEST_F(PlayTest, TakesAShotOnceTheBallsRestThoughTheTableWasNotWokenYet) {
    start_match();
    take_turn(1);
    now = base::Instant{base::Duration{last<told::ShotPlayed>(ada).turn.opens_us}};
    take_turn(2);
    EXPECT_EQ(state().shots_played, 2);
}

TEST_F(PlayTest, OpensTheNextTurnEarlyWhenBothHaveSeenTheShot) {
    start_match();
    take_turn(1);
    const auto sequence = last<told::ShotPlayed>(ada).sequence;
    say(ada, client::Seen{sequence});
    say(linus, client::Seen{sequence});
    say(grace, client::Seen{sequence - 1});
    EXPECT_EQ(count<told::TurnOpened>(ada), 0U);
    say(grace, client::Seen{sequence});
    EXPECT_EQ(count<told::TurnOpened>(linus), 1U);
}

TEST_F(PlayTest, DoesNotWaitForThePlayerWhoIsAwayToSeeTheShot) {
    start_match();
    take_turn(1);
    say(ada, client::Seen{last<told::ShotPlayed>(ada).sequence});
    disconnect(grace);
    EXPECT_EQ(count<told::TurnOpened>(ada), 1U);
}

TEST_F(PlayTest, DoesNotTakeItForSeenWhenNobodyIsThere) {
    start_match();
    take_turn(1);
    disconnect(ada);
    disconnect(grace);
    EXPECT_EQ(count<told::TurnOpened>(linus), 0U);
    pass(base::Instant{base::Duration{last<told::ShotPlayed>(linus).turn.opens_us}} - now);
    EXPECT_EQ(last<told::TurnOpened>(linus).turn.deadline_us, std::nullopt);
}

TEST_F(PlayTest, RefusesWhateverComesWhileTheBallsRoll) {
    start_match();
    take_turn(1);
    say(shooter(), shot(2));
    EXPECT_EQ(refusal(shooter()), RefusedCode::TooEarly);
    say(shooter(), client::PlaceCueBall{state().turn, {}});
    EXPECT_EQ(refusal(shooter()), RefusedCode::TooEarly);
    say(shooter(), client::Choose{state().turn, rules::Choice::Accept});
    EXPECT_EQ(refusal(shooter()), RefusedCode::TooEarly);
    EXPECT_EQ(lobby->stats().shots, 1U);
}

TEST_F(PlayTest, RefusesAShotOutOfTurn) {
    start_match();
    place_cue_ball();
    say(other(), shot(1));
    EXPECT_EQ(match_refusal(other()), match::RefusalCode::NotYourTurn);
}

TEST_F(PlayTest, RefusesAShotMeantForAnotherTurn) {
    start_match();
    place_cue_ball();
    auto late = shot(1);
    ++late.turn.value;
    say(shooter(), late);
    EXPECT_EQ(match_refusal(shooter()), match::RefusalCode::StaleTurn);
}

TEST_F(PlayTest, RefusesAPlacementMeantForAnotherTurn) {
    start_match();
    say(shooter(), client::PlaceCueBall{{state().turn.value + 1}, free_place()});
    EXPECT_EQ(match_refusal(shooter()), match::RefusalCode::StaleTurn);
}

TEST_F(PlayTest, RefusesAShotWithoutACueBall) {
    start_match();
    say(shooter(), shot(1));
    EXPECT_EQ(match_refusal(shooter()), match::RefusalCode::CueBallNotPlaced);
}

TEST_F(PlayTest, RefusesShotsWhoseNumbersMakeNoSense) {
    start_match();
    place_cue_ball();
    std::uint64_t shot_id = 0;
    for (const double power :
         {0.0, -0.5, 1.5, std::nan(""), 1e300, std::numeric_limits<double>::infinity()}) {
        auto bad = shot(++shot_id);
        bad.shot.power = power;
        say(shooter(), bad);
        EXPECT_EQ(match_refusal(shooter()), match::RefusalCode::BadShot) << power;
    }
    EXPECT_EQ(lobby->stats().shots, 0U);
    say(shooter(), shot(++shot_id));
    EXPECT_EQ(lobby->stats().shots, 1U);
}

TEST_F(PlayTest, RefusesAShotWhoseRecordFitsIntoNoFrame) {
    limits.record_bytes = 1000;
    start();
    start_match();
    place_cue_ball();
    const match::MatchState before = state();
    say(shooter(), shot(1));
    EXPECT_EQ(match_refusal(shooter()), match::RefusalCode::Unsolvable);
    EXPECT_EQ(state(), before);
    EXPECT_EQ(lobby->stats().shots, 0U);
}

TEST_F(PlayTest, RefusesACueBallOnAnotherBallOutsideOrNowhere) {
    start_match();
    const base::Vec2 on_ball = state().layout.balls[1].position_m;
    for (const base::Vec2 place : {on_ball, base::Vec2{50.0, 0.0}, base::Vec2{std::nan(""), 0.0}}) {
        say(shooter(), client::PlaceCueBall{state().turn, place});
        EXPECT_EQ(match_refusal(shooter()), match::RefusalCode::BadPlacement);
    }
    EXPECT_EQ(count<told::CueBallPlaced>(linus), 0U);
}

TEST_F(PlayTest, ShowsEveryoneWhereTheCueBallWasSetDown) {
    start_match();
    place_cue_ball();
    for (const SessionId session : {ada, grace, linus}) {
        EXPECT_EQ(count<told::CueBallPlaced>(session), 1U);
    }
}

TEST_F(PlayTest, LimitsHowOftenTheCueBallIsSetDown) {
    start_match();
    for (int i = 0; i < limits.placements_per_10s; ++i) place_cue_ball();
    EXPECT_EQ(refusal(shooter()), std::nullopt);
    place_cue_ball();
    EXPECT_EQ(refusal(shooter()), RefusedCode::TooMany);
}

TEST_F(PlayTest, LetsNobodySpendTheOpponentsPlacements) {
    start_match();
    for (int i = 0; i < 2 * limits.placements_per_10s; ++i) {
        say(other(), client::PlaceCueBall{state().turn, free_place()});
        EXPECT_EQ(match_refusal(other()), match::RefusalCode::NotYourTurn);
    }
    place_cue_ball();
    EXPECT_EQ(count<told::CueBallPlaced>(linus), 1U);
}

TEST_F(PlayTest, RefusesEverythingOfTheMatchToSpectators) {
    start_match();
    const protocol::ClientMessageBody messages[] = {
        shot(1),         client::PlaceCueBall{}, client::Choose{},
        client::Ready{}, client::Concede{},      client::Aim{},
    };
    for (const auto& message : messages) {
        say(linus, message);
        EXPECT_EQ(refusal(linus), RefusedCode::NotInThisPhase);
    }
}

TEST_F(PlayTest, AnswersARepeatedShotToWhoAsksAndPlaysItOnce) {
    start_match();
    place_cue_ball();
    const SessionId who = shooter();
    const auto taken = shot(5);
    say(who, taken);
    say(who, taken);
    const auto frames = outbox.frames<told::ShotPlayed>(who);
    ASSERT_EQ(frames.size(), 2U);
    EXPECT_EQ(frames[0], frames[1]);
    EXPECT_EQ(count<told::ShotPlayed>(linus), 1U);
    EXPECT_EQ(lobby->stats().shots, 1U);
}

TEST_F(PlayTest, DoesNotTakeTheOpponentsShotForARepeat) {
    start_match();
    take_turn(5);
    const SessionId opponent = last<told::ShotPlayed>(linus).seat == Seat::First ? grace : ada;
    auto same_id = shot(5);
    say(opponent, same_id);
    EXPECT_EQ(refusal(opponent), RefusedCode::TooEarly);
}

TEST_F(PlayTest, LetsOneClientPlayBothSeats) {
    ada = greet("Ada");
    grace = ada;
    linus = greet("Linus");
    say(ada, client::CreateTable{.name = "Home", .settings = {}, .role = Role::BothSeats});
    const auto snapshot = last<told::TableSnapshot>(ada);
    EXPECT_EQ(snapshot.your_seats, (std::vector{Seat::First, Seat::Second}));
    say(linus, client::Join{snapshot.row.table, Role::Spectator});
    say(ada, client::Ready{});
    ASSERT_EQ(count<told::MatchStarted>(ada), 1U);
    std::set<Seat> shot_by;
    for (std::uint64_t shot_id = 1; shot_by.size() < 2 && shot_id < 10; ++shot_id) {
        take_turn(shot_id);
        shot_by.insert(last<told::ShotPlayed>(ada).seat);
        let_rest();
    }
    EXPECT_EQ(shot_by.size(), 2U);
    EXPECT_EQ(count<told::ShotPlayed>(ada), count<told::ShotPlayed>(linus));
}

TEST_F(PlayTest, PlaysEveryGame) {
    for (const rules::Game game :
         {rules::Game::EightBall, rules::Game::NineBall, rules::Game::TenBall,
          rules::Game::StraightPool, rules::Game::Practice}) {
        ada = greet("Ada");
        client::CreateTable create{.name = "", .settings = {}, .role = Role::BothSeats};
        create.settings.game = game;
        create.settings.aim_help = false;
        create.settings.spectator_delay_s = 5.0;
        say(ada, create);
        say(ada, client::Ready{});
        ASSERT_EQ(count<told::MatchStarted>(ada), 1U);
        EXPECT_EQ(last<told::MatchStarted>(ada).state.settings, create.settings);
        say(ada, client::Concede{});
        EXPECT_EQ(last<told::MatchOver>(ada).winner.has_value(), game != rules::Game::Practice);
    }
}

TEST_F(PlayTest, EndsWithAConcessionAndStartsAgainWhenBothAreReady) {
    start_match();
    say(grace, client::Concede{});
    for (const SessionId session : {ada, grace, linus}) {
        const auto over = last<told::MatchOver>(session);
        EXPECT_EQ(over.winner, Seat::First);
        EXPECT_EQ(over.ending, told::Ending::Conceded);
    }
    EXPECT_EQ(last<told::MatchMoved>(ada).after.stage, match::Stage::Over);
    EXPECT_EQ(lobby->stats().matches_running, 0U);

    say(ada, client::Ready{});
    say(grace, client::Ready{});
    EXPECT_EQ(count<told::MatchStarted>(linus), 2U);
    EXPECT_EQ(lobby->stats().matches_running, 1U);
}

TEST_F(PlayTest, StartsNoMatchOnceTheServerGoesDownButLetsOthersPlayOn) {
    start_match();
    lobby->shut_down(now);
    take_turn(1);
    EXPECT_EQ(count<told::ShotPlayed>(linus), 1U);
    say(ada, client::Concede{});
    say(ada, client::Ready{});
    EXPECT_EQ(refusal(ada), RefusedCode::ShuttingDown);
}

TEST_F(PlayTest, TakesAConcessionWhileTheBallsRoll) {
    start_match();
    take_turn(1);
    say(ada, client::Concede{});
    EXPECT_EQ(last<told::MatchOver>(linus).winner, Seat::Second);
}

TEST_F(PlayTest, RefusesShotsAfterTheMatch) {
    start_match();
    say(grace, client::Concede{});
    say(ada, client::TakeShot{});
    EXPECT_EQ(match_refusal(ada), match::RefusalCode::MatchOver);
}

TEST_F(PlayTest, LetsPlayersLeaveAfterTheMatchButNotDuringIt) {
    start_match();
    say(ada, client::Leave{});
    EXPECT_EQ(refusal(ada), RefusedCode::MatchRunning);
    say(linus, client::Leave{});
    EXPECT_EQ(refusal(linus), std::nullopt);
    say(ada, client::Concede{});
    say(ada, client::Leave{});
    EXPECT_EQ(refusal(ada), std::nullopt);
    EXPECT_FALSE(last<told::SeatChanged>(grace).seats[Seat::First].taken);
}

TEST_F(PlayTest, CountsEverySequencedEventOfATableUpwards) {
    start_match();
    take_turn(1);
    let_rest();
    say(ada, client::Concede{});
    std::uint64_t before = 0;
    const auto check = [&](std::uint64_t sequence) {
        EXPECT_GT(sequence, before);
        before = sequence;
    };
    for (const Told& one : outbox.told(linus)) {
        if (const auto* m = std::get_if<told::TableSnapshot>(&one.message)) check(m->sequence);
        if (const auto* m = std::get_if<told::SeatChanged>(&one.message)) check(m->sequence);
        if (const auto* m = std::get_if<told::MatchStarted>(&one.message)) check(m->sequence);
        if (const auto* m = std::get_if<told::CueBallPlaced>(&one.message)) check(m->sequence);
        if (const auto* m = std::get_if<told::ShotPlayed>(&one.message)) check(m->sequence);
        if (const auto* m = std::get_if<told::TurnOpened>(&one.message)) check(m->sequence);
        if (const auto* m = std::get_if<told::MatchMoved>(&one.message)) check(m->sequence);
        if (const auto* m = std::get_if<told::MatchOver>(&one.message)) check(m->sequence);
    }
    EXPECT_GT(before, 5U);
}

TEST_F(PlayTest, PlaysManyTurnsAndEveryoneSeesTheSame) {
    match::Settings settings;
    settings.race_to = 1;
    start_match(settings);
    for (std::uint64_t shot_id = 1; shot_id <= 12 && count<told::MatchOver>(linus) == 0;
         ++shot_id) {
        take_turn(shot_id);
        ASSERT_EQ(count<told::ShotPlayed>(linus), shot_id);
        let_rest();
    }
    EXPECT_EQ(outbox.frames<told::ShotPlayed>(ada), outbox.frames<told::ShotPlayed>(linus));
    EXPECT_EQ(outbox.frames<told::ShotPlayed>(grace), outbox.frames<told::ShotPlayed>(linus));
}

}  // namespace
}  // namespace billiards::server
