// Holds the return of a client that says how far it had followed: it is told what it missed, in the
// frames that the others got, or a snapshot where that is forgotten.
#include "tests/server/support/game_test.h"

#include <gtest/gtest.h>

namespace billiards::server {
namespace {

using model::Seat;

class ResumeTest : public MatchTest {
  protected:
    client::Followed followed(SessionId session) {
        client::Followed followed{.table = table, .stream = 0, .sequence = 0};
        for (const Told& one : outbox.told(session)) {
            if (const auto* snapshot = std::get_if<told::TableSnapshot>(&one.message)) {
                followed.stream = snapshot->stream;
            }
            if (const auto sequence = sequence_of(one.message)) followed.sequence = *sequence;
        }
        return followed;
    }
    SessionId come_back_following(SessionId before, const client::Followed& followed) {
        const SessionId session = connect();
        say(session, client::Hello{.name = {}, .token = token_of(before), .followed = followed});
        return session;
    }
    /// The frames with a number that this session was told, after `first`.
    std::vector<protocol::SharedFrame> frames_after(SessionId session, std::uint64_t first) {
        std::vector<protocol::SharedFrame> frames;
        for (const Told& one : outbox.told(session)) {
            const auto sequence = sequence_of(one.message);
            if (sequence && *sequence > first) frames.push_back(one.frame);
        }
        return frames;
    }
};

TEST_F(ResumeTest, TellsWhatWasMissedInTheFramesOfTheOthers) {
    start_match();
    const auto known = followed(ada);
    disconnect(ada);
    if (shooter() == grace) take_turn(1);
    const SessionId back = come_back_following(ada, known);
    EXPECT_EQ(last<told::Welcome>(back).table, table);
    EXPECT_EQ(last<told::Resumed>(back).your_seats, std::vector{Seat::First});
    EXPECT_EQ(last<told::Resumed>(back).table, table);
    EXPECT_EQ(last<told::Resumed>(back).server_time_us, now.time_since_epoch().count());
    EXPECT_EQ(count<told::TableSnapshot>(back), 0U);
    EXPECT_EQ(frames_after(back, 0), frames_after(linus, known.sequence));
    EXPECT_GE(frames_after(back, 0).size(), 2U);
}

TEST_F(ResumeTest, TellsOfATurnThatTheReturnOpensOnlyAfterWhatWasMissed) {
    start_match();
    take_turn(1);
    say(ada, client::Seen{last<told::ShotPlayed>(ada).sequence});
    const auto known = followed(ada);
    disconnect(ada);
    disconnect(grace);
    const SessionId back = come_back_following(ada, known);
    EXPECT_EQ(count<told::TurnOpened>(back), 1U);
    EXPECT_EQ(frames_after(back, 0), frames_after(linus, known.sequence));
}

TEST_F(ResumeTest, TellsNothingAgainToWhoMissedNothingElse) {
    start_match();
    const SessionId back = come_back_following(ada, followed(ada));
    EXPECT_EQ(count<told::Resumed>(back), 1U);
    EXPECT_EQ(count<told::MatchStarted>(back), 0U);
    EXPECT_TRUE(last<told::SeatChanged>(back).seats[Seat::First].connected);
}

TEST_F(ResumeTest, BringsASpectatorBackLikewise) {
    start_match();
    const auto known = followed(linus);
    disconnect(linus);
    take_turn(1);
    const SessionId back = come_back_following(linus, known);
    EXPECT_EQ(count<told::Resumed>(back), 1U);
    EXPECT_TRUE(last<told::Resumed>(back).your_seats.empty());
    EXPECT_EQ(outbox.frames<told::ShotPlayed>(back), outbox.frames<told::ShotPlayed>(ada));
}

TEST_F(ResumeTest, SendsASnapshotWhereTheEventsAreForgotten) {
    limits.kept_events = 3;
    start();
    start_match();
    auto known = followed(ada);
    known.sequence -= 3;
    const SessionId back = come_back_following(ada, known);  // Its return is the fourth.
    EXPECT_EQ(count<told::Resumed>(back), 0U);
    EXPECT_EQ(count<told::TableSnapshot>(back), 1U);
}

TEST_F(ResumeTest, SendsASnapshotWhereTheFramesAreTooLarge) {
    limits.kept_event_bytes = 100;
    start();
    start_match();
    const SessionId back = come_back_following(ada, followed(ada));
    EXPECT_EQ(count<told::TableSnapshot>(back), 1U);
}

TEST_F(ResumeTest, SendsASnapshotForAnotherStreamTableOrNumber) {
    start_match();
    auto other_stream = followed(ada);
    ++other_stream.stream;
    ada = come_back_following(ada, other_stream);
    EXPECT_EQ(count<told::TableSnapshot>(ada), 1U);
    auto other_table = followed(ada);
    ++other_table.table.value;
    ada = come_back_following(ada, other_table);
    EXPECT_EQ(count<told::TableSnapshot>(ada), 1U);
    auto never_told = followed(ada);
    never_told.sequence += 10;
    ada = come_back_following(ada, never_told);
    EXPECT_EQ(count<told::TableSnapshot>(ada), 1U);
}

TEST_F(ResumeTest, HasAnotherStreamAfterARestart) {
    start_match();
    const auto known = followed(ada);
    restart();
    const SessionId back = come_back_following(ada, known);
    EXPECT_EQ(count<told::TableSnapshot>(back), 1U);
    EXPECT_NE(last<told::TableSnapshot>(back).stream, known.stream);
}

TEST_F(ResumeTest, SendsSpectatorsWhatMayBeShedAndPlayersWhatMayNot) {
    start_match();
    take_turn(1);
    const auto delivery_of_shot = [&](SessionId session) {
        Delivery delivery{};
        for (const Told& one : outbox.told(session)) {
            if (std::holds_alternative<told::ShotPlayed>(one.message)) delivery = one.delivery;
        }
        return delivery;
    };
    EXPECT_EQ(delivery_of_shot(ada), Delivery::Ordered);
    EXPECT_EQ(delivery_of_shot(linus), Delivery::Sheddable);
    EXPECT_EQ(outbox.told(linus)[1].delivery, Delivery::Fresh);
    EXPECT_TRUE(std::holds_alternative<told::TableSnapshot>(outbox.told(linus)[1].message));
}

}  // namespace
}  // namespace billiards::server
