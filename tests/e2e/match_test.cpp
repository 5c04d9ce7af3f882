// Plays whole matches over TCP between processes: alone, side by side, through a bad network, and
// over the server's sudden death.
#include "common/base/random.h"
#include "tests/e2e/match_runner.h"
#include "tests/support/chaos_proxy.h"

#include <asio/ip/address_v4.hpp>
#include <gtest/gtest.h>
#include <string>

namespace billiards::e2e {
namespace {

TEST(MatchOverTcp, ThreeProcessesFinishItWithBitIdenticalLayoutsAndScores) {
    Host host;
    const std::vector<Account> accounts = Match(host.port(), 2, 1).finish();
    expect_one_match(accounts);
    for (const Account& account : accounts) {
        EXPECT_EQ(account.missed, 0);
        EXPECT_EQ(account.links_lost, 0);
        EXPECT_EQ(account.digest, accounts.front().digest);
    }
    EXPECT_EQ(host.stop(), 0);
}

TEST(MatchOverTcp, EightTablesAtOnceEachFinishTheirs) {
    Host host;
    std::vector<Match> matches;
    for (int table = 0; table < 8; ++table) matches.emplace_back(host.port(), 1, 10 + table);
    for (Match& match : matches) {
        const std::vector<Account> accounts = match.finish();
        expect_one_match(accounts);
        for (const Account& account : accounts) {
            EXPECT_EQ(account.digest, accounts.front().digest);
        }
    }
    EXPECT_EQ(host.stop(), 0);
}

TEST(MatchOverTcp, ItIsFinishedThroughTheWorstNetwork) {
    Host host;
    support::ChaosProxy proxy({asio::ip::address_v4::loopback(), host.port()},
                              *support::chaos_preset("worst"), 7);
    const std::vector<Account> accounts = Match(proxy.port(), 1, 30).finish();
    expect_one_match(accounts);
    EXPECT_GT(proxy.counts().splits, 0U);
    EXPECT_GT(proxy.counts().stalls, 0U);
    EXPECT_EQ(host.stop(), 0);
}

TEST(MatchOverTcp, NoAcknowledgedShotIsMissingAfterTheServerIsKilled) {
    Host host;
    Match match(host.port(), 2, 50);
    base::Random random(50);
    int kills = 0;
    while (kills < 4 && match.watch_shots(1 + static_cast<int>(random.below(6)))) {
        host.kill_minus_nine();
        host.start();
        ++kills;
    }
    EXPECT_GT(kills, 0);
    const std::vector<Account> accounts = match.finish();
    expect_one_match(accounts);
    EXPECT_EQ(host.stop(), 0);
    const std::vector<JournalledShot> journal = journalled_shots(host);
    for (const Account& account : accounts) {
        EXPECT_GE(account.links_lost, 1);
        for (const auto& [number, shot] : account.told) {
            ASSERT_LE(static_cast<std::size_t>(number), journal.size());
            EXPECT_EQ(shot, journal[static_cast<std::size_t>(number) - 1]) << "shot " << number;
        }
    }
}

}  // namespace
}  // namespace billiards::e2e
