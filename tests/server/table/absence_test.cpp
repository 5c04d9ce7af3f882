// Holds the grace of a seat: it is spent only while it counts, and stays spent.
#include "server/table/absence.h"

#include <chrono>
#include <gtest/gtest.h>

namespace billiards::server {
namespace {

using model::Seat;
using namespace std::chrono_literals;

base::Instant at(base::Duration time) {
    return base::Instant{time};
}

TEST(Absence, IsUsedUpOnceItHasCountedForTheWholeGrace) {
    Absence absence(60s);
    EXPECT_EQ(absence.ends(Seat::First), std::nullopt);
    absence.count(at(10s), Seat::First, true);
    EXPECT_EQ(absence.ends(Seat::First), at(70s));
    EXPECT_FALSE(absence.is_used_up(at(70s) - 1us, Seat::First));
    EXPECT_TRUE(absence.is_used_up(at(70s), Seat::First));
    EXPECT_FALSE(absence.is_used_up(at(70s), Seat::Second));
}

TEST(Absence, GoesOnWithWhatIsLeftTheNextTime) {
    Absence absence(60s);
    absence.count(at(0s), Seat::Second, true);
    absence.count(at(45s), Seat::Second, false);
    EXPECT_EQ(absence.ends(Seat::Second), std::nullopt);
    absence.count(at(100s), Seat::Second, true);
    EXPECT_EQ(absence.ends(Seat::Second), at(115s));
}

TEST(Absence, HasNothingLeftAfterALongOne) {
    Absence absence(60s);
    absence.count(at(0s), Seat::First, true);
    absence.count(at(500s), Seat::First, false);
    EXPECT_FALSE(absence.is_used_up(at(500s), Seat::First));
    absence.count(at(600s), Seat::First, true);
    EXPECT_TRUE(absence.is_used_up(at(600s), Seat::First));
}

TEST(Absence, IsNotCountedTwiceWhereItIsSaidTwice) {
    Absence absence(60s);
    absence.count(at(0s), Seat::First, true);
    absence.count(at(30s), Seat::First, true);
    EXPECT_EQ(absence.ends(Seat::First), at(60s));
}

TEST(Absence, IsGivenBackInFullWhetherItCountsOrNot) {
    Absence absence(60s);
    absence.count(at(0s), Seat::First, true);
    absence.give_back(at(50s), Seat::First);
    EXPECT_EQ(absence.ends(Seat::First), at(110s));
    absence.count(at(100s), Seat::First, false);
    absence.give_back(at(100s), Seat::First);
    absence.count(at(200s), Seat::First, true);
    EXPECT_EQ(absence.ends(Seat::First), at(260s));
}

}  // namespace
}  // namespace billiards::server
