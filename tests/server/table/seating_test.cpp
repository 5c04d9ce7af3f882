// Holds who may sit where, and what a lost connection leaves behind.
#include "server/table/seating.h"

#include <gtest/gtest.h>

namespace billiards::server {
namespace {

using model::Seat;

const Visitor kAda{.session = {1}, .player = {10}, .name = "Ada#0001"};
const Visitor kGrace{.session = {2}, .player = {20}, .name = "Grace#0002"};

std::vector<std::uint64_t> players_of(const Seating& seating) {
    std::vector<std::uint64_t> sessions;
    seating.for_each_player([&](SessionId session) { sessions.push_back(session.value); });
    return sessions;
}

TEST(Seating, GivesTheFirstSeatFirst) {
    Seating seating;
    EXPECT_EQ(seating.free_seat(false), Seat::First);
    seating.sit(Seat::First, kAda);
    EXPECT_EQ(seating.free_seat(false), Seat::Second);
    seating.sit(Seat::Second, kGrace);
    EXPECT_EQ(seating.free_seat(true), std::nullopt);
}

TEST(Seating, KeepsTheSeatOfALostConnectionForItsPlayer) {
    Seating seating;
    seating.sit(Seat::First, kAda);
    seating.lose(kAda.session);
    EXPECT_TRUE(seating.is_seated(kAda.player));
    EXPECT_FALSE(seating.is_connected(Seat::First));
    EXPECT_EQ(seating.free_seat(false), Seat::Second);

    seating.come_back({.session = {9}, .player = kAda.player, .name = kAda.name});
    EXPECT_EQ(seating.seats_of({9}), std::vector{Seat::First});
}

TEST(Seating, OffersAnAbsentPlayersSeatOnlyAfterTheEmptyOne) {
    Seating seating;
    seating.sit(Seat::First, kAda);
    seating.lose(kAda.session);
    EXPECT_EQ(seating.free_seat(true), Seat::Second);
    seating.sit(Seat::Second, kGrace);
    EXPECT_EQ(seating.free_seat(true), Seat::First);
    EXPECT_FALSE(seating.are_both_free(true));
}

TEST(Seating, NamesASessionOnBothSeatsOnce) {
    Seating seating;
    seating.sit(Seat::First, kAda);
    seating.sit(Seat::Second, kAda);
    EXPECT_EQ(players_of(seating), std::vector<std::uint64_t>{1});
    seating.leave(kAda.session);
    EXPECT_TRUE(seating.are_both_free(false));
}

TEST(Seating, IsReadyWhenBothSeatsAreTakenAndReady) {
    Seating seating;
    seating.sit(Seat::First, kAda);
    EXPECT_TRUE(seating.set_ready(kAda.session));
    EXPECT_FALSE(seating.set_ready(kAda.session));
    EXPECT_FALSE(seating.are_all_ready());
    seating.sit(Seat::Second, kGrace);
    seating.set_ready(kGrace.session);
    EXPECT_TRUE(seating.are_all_ready());
}

TEST(Seating, DoesNotCountAnAbsentPlayerAsReady) {
    Seating seating;
    seating.sit(Seat::First, kAda);
    seating.set_ready(kAda.session);
    seating.lose(kAda.session);
    EXPECT_EQ(seating.views()[Seat::First],
              (protocol::server::SeatView{
                  .taken = true, .connected = false, .ready = false, .name = kAda.name}));
}

TEST(Seating, ForgetsASpectatorWhoseConnectionIsLost) {
    Seating seating;
    seating.watch({5});
    EXPECT_EQ(seating.spectators(), 1U);
    seating.lose({5});
    EXPECT_EQ(seating.spectators(), 0U);
}

}  // namespace
}  // namespace billiards::server
