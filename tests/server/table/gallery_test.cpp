// Holds the gallery whose spectators are delayed: all that leaves the table towards them is late,
// in order, and bounded.
#include "server/table/gallery.h"

#include "tests/server/support/game_test.h"

#include <algorithm>
#include <gtest/gtest.h>

namespace billiards::server {
namespace {

using model::Seat;

class GalleryTest : public MatchTest {
  protected:
    static constexpr base::Duration kLate = 20s;

    GalleryTest() {
        settings.spectator_delay_s = base::seconds(kLate);
        settings.shot_clock_s = settings.break_shot_clock_s = 600.0;
        committer.takes = 0s;
    }
    /// Everybody stays connected.
    void wait(base::Duration duration) {
        const base::Instant end = now + duration;
        while (now < end) {
            keep_alive();
            pass(std::min<base::Duration>(30s, end - now));
        }
    }
    match::MatchState live() { return state(ada); }
    void shoot(std::uint64_t shot_id) {
        const SessionId spectator = linus;
        linus = ada;  // Whose state the fixture goes by.
        take_turn(shot_id);
        linus = spectator;
    }
    static std::int64_t wire(base::Instant instant) { return instant.time_since_epoch().count(); }

    match::Settings settings;
};

TEST_F(GalleryTest, ShowsSpectatorsEverythingSoMuchLater) {
    start_match(settings);
    EXPECT_EQ(count<told::MatchStarted>(ada), 1U);
    wait(kLate - 1us);
    EXPECT_EQ(count<told::MatchStarted>(linus), 0U);
    pass(1us);
    const auto started = last<told::MatchStarted>(linus);
    const auto earlier = last<told::MatchStarted>(ada);
    EXPECT_EQ(started.state, earlier.state);
    EXPECT_EQ(started.sequence, earlier.sequence);
    EXPECT_EQ(started.turn.opens_us, earlier.turn.opens_us + kLate.count());
    EXPECT_EQ(started.turn.deadline_us, *earlier.turn.deadline_us + kLate.count());
}

TEST_F(GalleryTest, MovesTheStrikeOfAShotAndEncodesItOnceForAll) {
    start_match(settings);
    const SessionId barbara = greet("Barbara");
    say(barbara, client::Join{table, Role::Spectator});
    wait(kLate);
    shoot(1);
    const auto played = last<told::ShotPlayed>(ada);
    say(barbara, client::Ping{});
    wait(kLate);
    const auto frames = outbox.frames<told::ShotPlayed>(linus);
    ASSERT_EQ(frames.size(), 1U);
    EXPECT_EQ(outbox.frames<told::ShotPlayed>(barbara), frames);
    EXPECT_EQ(last<told::ShotPlayed>(linus).struck_us, played.struck_us + kLate.count());
    EXPECT_EQ(last<told::ShotPlayed>(linus).record, played.record);
}

TEST_F(GalleryTest, ShowsALatecomerTheTableAsItWasWithTheShotThatRolledThen) {
    start_match(settings);
    wait(kLate);
    shoot(1);
    const auto played = last<told::ShotPlayed>(ada);
    wait(1s);
    const SessionId early = greet("Early");
    say(early, client::Join{table, Role::Spectator});
    EXPECT_EQ(last<told::TableSnapshot>(early).match->shots_played, 0);
    EXPECT_EQ(last<told::TableSnapshot>(early).rolling, std::nullopt);
    wait(kLate - 1s + base::duration_of(played.record.duration_s / 2));
    const SessionId late = greet("Late");
    say(late, client::Join{table, Role::Spectator});
    const auto snapshot = last<told::TableSnapshot>(late);
    EXPECT_EQ(snapshot.match, played.after);
    ASSERT_TRUE(snapshot.rolling.has_value());
    EXPECT_EQ(snapshot.rolling->struck_us, played.struck_us + kLate.count());
    EXPECT_EQ(snapshot.server_time_us, wire(now));
    EXPECT_EQ(snapshot.turn.opens_us, played.turn.opens_us + kLate.count());
}

TEST_F(GalleryTest, DelaysRowsOfTheListToo) {
    start_match(settings);
    const SessionId barbara = greet("Barbara");
    const auto playing = [&] {
        pass(limits.table_list_kept + 1us);
        say(barbara, client::ListTables{});
        return last<told::TableList>(barbara).tables.front().playing;
    };
    EXPECT_FALSE(playing());
    wait(kLate);
    EXPECT_TRUE(playing());
}

TEST_F(GalleryTest, DelaysChatAndAimsForSpectatorsAlone) {
    start_match(settings);
    wait(kLate);
    say(ada, client::Chat{"nice"});
    say(session_of(live().to_act), client::Aim{.turn = live().turn, .shot = {}});
    const SessionId opponent = session_of(opponent_of(live().to_act));
    EXPECT_EQ(count<told::ChatSaid>(grace), 1U);
    EXPECT_EQ(count<told::AimShown>(opponent), 1U);
    EXPECT_EQ(count<told::ChatSaid>(linus) + count<told::AimShown>(linus), 0U);
    wait(kLate);
    EXPECT_EQ(count<told::ChatSaid>(linus), 1U);
    EXPECT_EQ(count<told::AimShown>(linus), 1U);
}

TEST_F(GalleryTest, DelaysWhoIsThereAndFromWhenTheyMayBeClaimed) {
    start_match(settings);
    wait(kLate);
    disconnect(grace);
    const auto before = count<told::SeatChanged>(linus);
    const auto claimable = last<told::SeatChanged>(ada).seats[Seat::Second].claimable_us;
    EXPECT_TRUE(last<told::SeatChanged>(linus).seats[Seat::Second].connected);
    for (const SessionId session : {ada, linus}) say(session, client::Ping{});
    pass(kLate);
    EXPECT_GT(count<told::SeatChanged>(linus), before);
    EXPECT_EQ(last<told::SeatChanged>(linus).seats[Seat::Second].claimable_us,
              *claimable + kLate.count());
}

TEST_F(GalleryTest, LetsPlayersSeeAtOnceWhatSpectatorsSeeLate) {
    start_match(settings);
    wait(kLate);
    shoot(1);
    disconnect(ada);
    const SessionId back = come_back(token_of(ada));
    EXPECT_EQ(last<told::TableSnapshot>(back).match->shots_played, 1);
}

TEST_F(GalleryTest, HasASpectatorResumeInAStreamOfItsOwn) {
    start_match(settings);
    wait(kLate);
    const auto known = last<told::TableSnapshot>(linus).stream;
    EXPECT_NE(known, last<told::TableSnapshot>(ada).stream);
    const auto sequence = last<told::MatchStarted>(linus).sequence;
    disconnect(linus);
    shoot(1);
    const auto played = last<told::ShotPlayed>(ada);
    for (const SessionId session : {ada, grace}) say(session, client::Ping{});
    pass(kLate);
    const SessionId back = connect();
    say(back, client::Hello{.name = {},
                            .token = token_of(linus),
                            .followed = client::Followed{table, known, sequence}});
    EXPECT_EQ(count<told::Resumed>(back), 1U);
    EXPECT_EQ(last<told::ShotPlayed>(back).struck_us, played.struck_us + kLate.count());
}

TEST_F(GalleryTest, ShowsRightAfterARestartWhoPlaysAndNothingOfTheMatch) {
    start_match(settings);
    shoot(1);
    restart();
    const SessionId late = greet("Late");
    say(late, client::ListTables{});
    const auto listed = last<told::TableList>(late).tables.front();
    EXPECT_TRUE(listed.playing);
    for (const Seat seat : model::kSeats) EXPECT_TRUE(listed.seats[seat].taken);
    say(late, client::Join{table, Role::Spectator});
    EXPECT_EQ(last<told::TableSnapshot>(late).match, std::nullopt);
    EXPECT_EQ(last<told::TableSnapshot>(late).row, listed);
    pass(kLate);
    EXPECT_EQ(last<told::TableSnapshot>(late).match->shots_played, 1);
    EXPECT_EQ(outbox.told(late).back().delivery, Delivery::Fresh);
}

TEST_F(GalleryTest, HidesTheResultFromTheHistoryForAsLong) {
    start_match(settings);
    say(ada, client::Concede{});
    EXPECT_EQ(committer.result({1})->hidden_for, kLate);
}

// The gallery alone.

protocol::SharedFrame remark(const std::string& text) {
    return protocol::encode(told::ChatSaid{.name = "Ada", .text = text});
}
protocol::SharedFrame event(std::uint64_t sequence) {
    return protocol::encode(told::SeatChanged{.sequence = sequence, .seats = {}, .spectators = 0});
}
Picture picture(std::uint64_t sequence) {
    Picture picture;
    picture.sequence = sequence;
    return picture;
}
base::Instant at(base::Duration time) {
    return base::Instant{time};
}

TEST(Gallery, IsLiveUntilItHasADelay) {
    Gallery gallery{LobbyLimits{}};
    gallery.set_delay(0s, picture(3), 7);
    EXPECT_FALSE(gallery.is_delayed());
    gallery.set_delay(5s, picture(3), 7);
    EXPECT_TRUE(gallery.is_delayed());
    EXPECT_EQ(gallery.stream(), 7U);
    EXPECT_EQ(gallery.snapshot(at(1s)).sequence, 3U);
    gallery.set_delay(8s, picture(9), 8);
    EXPECT_EQ(gallery.stream(), 7U);
}

TEST(Gallery, NeverLetsAShorterDelayOvertake) {
    Gallery gallery{LobbyLimits{}};
    gallery.set_delay(10s, picture(0), 1);
    gallery.add(at(0s), event(1), picture(1));
    gallery.set_delay(2s, picture(1), 1);
    gallery.add(at(1s), event(2), picture(2));
    EXPECT_TRUE(gallery.take_due(at(10s) - 1us).empty());
    EXPECT_EQ(gallery.take_due(at(10s)).size(), 2U);
    EXPECT_EQ(gallery.shown().sequence, 2U);
    gallery.add(at(11s), event(3), picture(3));
    EXPECT_EQ(gallery.next_deadline(), at(13s));
}

TEST(Gallery, IsLiveAgainOnceAllIsShownThatWaitedForADelayThatIsNoMore) {
    Gallery gallery{LobbyLimits{}};
    gallery.set_delay(10s, picture(0), 1);
    gallery.add(at(0s), event(1), picture(1));
    gallery.set_delay(0s, picture(1), 2);
    gallery.add(at(3s), event(2), picture(2));
    EXPECT_TRUE(gallery.take_due(at(10s) - 1us).empty());
    EXPECT_TRUE(gallery.is_delayed());
    EXPECT_EQ(gallery.take_due(at(10s)).size(), 2U);
    EXPECT_FALSE(gallery.is_delayed());
}

TEST(Gallery, DropsRemarksAndJumpsOverEventsWhereTooMuchWaits) {
    LobbyLimits limits;
    limits.delayed_events = 3;
    Gallery gallery{limits};
    gallery.set_delay(10s, picture(0), 1);
    gallery.add(at(0s), event(1), picture(1));
    for (int i = 0; i < 5; ++i) gallery.add(at(1s), remark("hi"), Delivery::Sheddable);
    gallery.add(at(2s), event(2), picture(2));
    const auto due = gallery.take_due(at(20s));
    ASSERT_EQ(due.size(), 1U);
    EXPECT_EQ(due[0].delivery, Delivery::Fresh);
    EXPECT_EQ(gallery.shown().sequence, 2U);
    EXPECT_EQ(gallery.log().since(1), std::nullopt);
    EXPECT_TRUE(gallery.log().since(2).has_value());
}

TEST(Gallery, ShowsAJumpInItsTimeThoughTooMuchWaitsAgain) {
    LobbyLimits limits;
    limits.delayed_events = 3;
    Gallery gallery{limits};
    gallery.set_delay(10s, picture(0), 1);
    for (std::uint64_t i = 1; i <= 4; ++i) gallery.add(at(0s), event(i), picture(i));
    for (std::uint64_t i = 5; i <= 7; ++i) gallery.add(at(2s), event(i), picture(i));
    ASSERT_EQ(gallery.take_due(at(10s)).size(), 1U);
    EXPECT_EQ(gallery.shown().sequence, 4U);
    ASSERT_EQ(gallery.take_due(at(12s)).size(), 1U);
    EXPECT_EQ(gallery.shown().sequence, 7U);
}

TEST(Gallery, CountsTheBytesThatWait) {
    LobbyLimits limits;
    limits.delayed_bytes = 2 * (kWaitingEventBytes + event(1)->size());
    Gallery gallery{limits};
    gallery.set_delay(10s, picture(0), 1);
    gallery.add(at(0s), event(1), picture(1));
    gallery.add(at(0s), event(2), picture(2));
    gallery.add(at(0s), remark("hi"), Delivery::Sheddable);
    EXPECT_EQ(gallery.take_due(at(10s)).size(), 2U);
    for (std::uint64_t i = 3; i <= 5; ++i) gallery.add(at(11s), event(i), picture(i));
    EXPECT_EQ(gallery.take_due(at(21s)).size(), 1U);
    EXPECT_EQ(gallery.shown().sequence, 5U);
}

}  // namespace
}  // namespace billiards::server
