// Holds what the lobby does about a disk that fails and about shots that nobody can solve.
#include "tests/server/support/game_test.h"

#include <gtest/gtest.h>

namespace billiards::server {
namespace {

class FailingDiskTest : public GameTest {
  protected:
    FailingDiskTest() {
        ada = greet("Ada");
        disk_is_slow = true;
        greet("Grace");
        committer.fail();
    }

    SessionId ada;
};

TEST_F(FailingDiskTest, IsTriedUntilItWorksSoThatReadinessComesBackByItself) {
    EXPECT_TRUE(lobby->stats().storage_failing);
    pass(limits.storage_probe_every);
    ASSERT_EQ(committer.waiting(), 1U);
    ASSERT_EQ(committer.next().size(), 1U) << "only a write finds out";
    committer.fail();
    EXPECT_TRUE(lobby->stats().storage_failing);

    pass(limits.storage_probe_every - 10ms);
    EXPECT_EQ(committer.waiting(), 0U);
    pass(10ms);
    ASSERT_EQ(committer.waiting(), 1U);
    const auto before = committer.durable().players;
    committer.complete();
    EXPECT_FALSE(lobby->stats().storage_failing);
    EXPECT_EQ(committer.durable().players, before);
    pass(2 * limits.storage_probe_every);
    EXPECT_EQ(committer.waiting(), 0U);
}

TEST_F(FailingDiskTest, IsTriedByOneProbeAtATime) {
    pass(4 * limits.storage_probe_every);
    EXPECT_EQ(committer.waiting(), 1U);
}

class UnsolvableTest : public MatchTest {
  protected:
    UnsolvableTest() {
        limits.record_bytes = 1;
        start();
        start_match();
    }
};

TEST_F(UnsolvableTest, ShotsAreCountedAndOnlySoManyAreTried) {
    place_cue_ball();
    const SessionId breaker = shooter();
    for (int i = 0; i < limits.unsolvable_per_min; ++i) {
        say(breaker, shot(static_cast<std::uint64_t>(i)));
        EXPECT_EQ(match_refusal(breaker), match::RefusalCode::Unsolvable);
    }
    say(breaker, shot(100));
    EXPECT_EQ(refusal(breaker), RefusedCode::TooMany);
    EXPECT_EQ(lobby->stats().unsolvable, static_cast<std::uint64_t>(limits.unsolvable_per_min));
    keep_alive();
    pass(10s);  // One more every ten seconds.
    say(shooter(), shot(101));
    EXPECT_EQ(match_refusal(shooter()), match::RefusalCode::Unsolvable);
}

}  // namespace
}  // namespace billiards::server
