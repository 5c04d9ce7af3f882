// Holds the shot clock over a table: when it runs, what comes just in time, and who it rules
// against.
#include "tests/server/support/game_test.h"

#include <gtest/gtest.h>

namespace billiards::server {
namespace {

class ShotClockTest : public MatchTest {
  protected:
    ShotClockTest() {
        settings.shot_clock_s = 20.0;
        settings.break_shot_clock_s = 30.0;
    }
    /// Up to `left` before the deadline of the turn that is open.
    void pass_until(base::Duration left) {
        const auto deadline = base::Instant{base::Duration{*turn().deadline_us}};
        pass(deadline - left - now);
    }
    told::Turn turn() {
        told::Turn turn;
        for (const Told& one : outbox.told(linus)) {
            if (const auto* m = std::get_if<told::MatchStarted>(&one.message)) turn = m->turn;
            if (const auto* m = std::get_if<told::TurnOpened>(&one.message)) turn = m->turn;
            if (const auto* m = std::get_if<told::MatchMoved>(&one.message)) turn = m->turn;
        }
        return turn;
    }

    match::Settings settings;
};

TEST_F(ShotClockTest, GivesTheBreakItsOwnTime) {
    start_match(settings);
    EXPECT_EQ(*turn().deadline_us - turn().opens_us, 30'000'000);
    take_turn(1);
    let_rest();
    EXPECT_EQ(*turn().deadline_us - turn().opens_us, 20'000'000);
}

TEST_F(ShotClockTest, GivesAChoiceAfterTheBreakTheUsualTime) {
    start_match(settings);
    place_cue_ball();
    auto soft = shot(1);
    soft.shot.power = 0.05;
    say(shooter(), soft);
    let_rest();
    ASSERT_EQ(state().stage, match::Stage::Choosing);
    EXPECT_EQ(*turn().deadline_us - turn().opens_us, 20'000'000);
}

TEST_F(ShotClockTest, WaitsOutTheGraceThoughTheTableIsWokenEarlier) {
    start_match(settings);
    place_cue_ball();
    pass_until(limits.spectator_count_every - limits.shot_grace / 2);
    say(linus, client::Leave{});
    linus = other();
    pass_until(-limits.shot_grace + 1us);
    EXPECT_EQ(count<told::MatchMoved>(linus), 0U);
    pass(1us);
    EXPECT_EQ(count<told::MatchMoved>(linus), 1U);
}

TEST_F(ShotClockTest, TakesAShotThatIsJustLate) {
    start_match(settings);
    place_cue_ball();
    pass_until(-(limits.shot_grace - 1us));
    say(shooter(), shot(1));
    EXPECT_EQ(count<told::ShotPlayed>(linus), 1U);
}

TEST_F(ShotClockTest, TakesNoShotAfterTheGraceThoughTheTableWasNotWokenYet) {
    start_match(settings);
    place_cue_ball();
    pass_until(-(limits.shot_grace - 1us));
    now += 1us;
    say(shooter(), shot(1));
    EXPECT_EQ(count<told::ShotPlayed>(linus), 0U);
    EXPECT_EQ(count<told::MatchMoved>(linus), 1U);
}

TEST_F(ShotClockTest, RulesAgainstWhoLetsItRunOut) {
    start_match(settings);
    take_turn(1);
    let_rest();
    const match::MatchState before = state();
    pass_until(-limits.shot_grace);
    const auto moved = last<told::MatchMoved>(linus);
    EXPECT_EQ(moved.seat, before.to_act);
    ASSERT_TRUE(moved.verdict.has_value());
    EXPECT_EQ(moved.verdict->reason, rules::Reason::ClockRanOut);
    EXPECT_GT(moved.after.turn, before.turn);
    EXPECT_TRUE(moved.turn.deadline_us.has_value());
}

TEST_F(ShotClockTest, RefusesTheShotThatCameAfterTheRuling) {
    start_match(settings);
    place_cue_ball();
    const SessionId who = shooter();
    const auto late = shot(1);
    pass_until(-limits.shot_grace);
    say(who, late);
    EXPECT_EQ(match_refusal(who), match::RefusalCode::StaleTurn);
}

TEST_F(ShotClockTest, JournalsTheRuling) {
    start_match(settings);
    pass_until(-limits.shot_grace);
    ASSERT_EQ(committer.journal({1}).size(), 1U);
    const auto entry = protocol::decode_entry(committer.journal({1}).front().entry);
    ASSERT_TRUE(entry.ok());
    EXPECT_TRUE(std::holds_alternative<match::Timeout>(entry->command));
    EXPECT_TRUE(entry->verdict.has_value());
}

TEST_F(ShotClockTest, DoesNotStartAgainWhenTheCueBallIsSetDown) {
    start_match(settings);
    pass(29s);
    place_cue_ball();
    pass(1s + limits.shot_grace);
    EXPECT_EQ(count<told::MatchMoved>(linus), 1U);
}

TEST_F(ShotClockTest, RunsOnWhileOnePlayerIsAway) {
    start_match(settings);
    const SessionId who = shooter();
    disconnect(who);
    pass_until(-limits.shot_grace);
    EXPECT_EQ(count<told::MatchMoved>(linus), 1U);
}

TEST_F(ShotClockTest, StandsStillWhileBothAreAway) {
    start_match(settings);
    const auto token = token_of(ada);
    pass(10s);
    disconnect(ada);
    disconnect(grace);
    EXPECT_EQ(turn().deadline_us, std::nullopt);
    for (int i = 0; i < 5; ++i) {
        pass(40s);
        say(linus, client::Ping{});
    }
    EXPECT_EQ(count<told::MatchMoved>(linus), 0U);

    const SessionId back = come_back(token);
    const auto deadline = (now + 20s).time_since_epoch().count();
    EXPECT_EQ(last<told::TableSnapshot>(back).turn.deadline_us, deadline);
    EXPECT_EQ(turn().deadline_us, deadline);
}

TEST_F(ShotClockTest, IsNotThereWhereTheSettingsSayNone) {
    settings.shot_clock_s = 0.0;
    settings.break_shot_clock_s = 0.0;
    start_match(settings);
    EXPECT_EQ(turn().deadline_us, std::nullopt);
    for (int i = 0; i < 20; ++i) {
        keep_alive();
        pass(50s);
    }
    EXPECT_EQ(count<told::MatchMoved>(linus), 0U);
}

TEST_F(ShotClockTest, TriesARulingThatCouldNotBeStoredAgainOnlyAfterAFullClock) {
    limits.storage_probe_every = 1h;
    start();
    start_match(settings);
    disk_is_slow = true;
    pass_until(-limits.shot_grace);
    ASSERT_EQ(committer.waiting(), 1U);
    committer.fail();
    EXPECT_EQ(committer.waiting(), 0U);
    EXPECT_GE(*lobby->next_deadline() - now, 29s);
}

}  // namespace
}  // namespace billiards::server
