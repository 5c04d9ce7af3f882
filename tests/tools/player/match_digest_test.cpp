// Holds the digest of a match against changes of a single bit.
#include "tools/player/match_digest.h"

#include "tests/client/app/told.h"

#include <cmath>
#include <gtest/gtest.h>

namespace billiards::tools {
namespace {

namespace told = client::told;
using model::Seat;
using protocol::server::ShotPlayed;

ShotPlayed shot(int number) {
    return told::shot(static_cast<std::uint64_t>(number),
                      told::match_at(static_cast<std::uint32_t>(number), Seat::First, number));
}

TEST(MatchDigest, TellsEveryBitOfALayoutAScoreAndARecord) {
    const std::uint64_t before = digest_of(shot(1));
    ShotPlayed moved = shot(1);
    moved.after.layout.balls[1].position_m.x =
        std::nextafter(moved.after.layout.balls[1].position_m.x, 1.0);
    EXPECT_NE(digest_of(moved), before);
    ShotPlayed scored = shot(1);
    scored.after.racks_won[Seat::Second] = 1;
    EXPECT_NE(digest_of(scored), before);
    ShotPlayed recorded = shot(1);
    recorded.record.hash = 1;
    EXPECT_NE(digest_of(recorded), before);
    EXPECT_EQ(digest_of(shot(1)), before);
}

TEST(MatchDigest, CountsAShotOnceAndWhatIsMissing) {
    MatchDigest digest;
    EXPECT_TRUE(digest.add(shot(1)));
    const std::uint64_t after_one = digest.value();
    EXPECT_FALSE(digest.add(shot(1)));
    EXPECT_EQ(digest.value(), after_one);
    EXPECT_TRUE(digest.add(shot(4)));
    EXPECT_EQ(digest.shots(), 2);
    EXPECT_EQ(digest.missed(), 2);
    EXPECT_FALSE(digest.add(shot(3)));
    protocol::server::MatchOver over = told::over(6, Seat::First);
    over.shots = 5;
    digest.add(over);
    EXPECT_EQ(digest.missed(), 3) << "the last one never came";
}

TEST(MatchDigest, TheEndCounts) {
    MatchDigest one;
    MatchDigest other;
    one.add(told::over(2, Seat::First));
    other.add(told::over(2, Seat::Second));
    EXPECT_NE(one.value(), other.value());
}

}  // namespace
}  // namespace billiards::tools
