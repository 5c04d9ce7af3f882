// Holds the SQLite store against a process that is killed at any instant: what it had acknowledged
// is there, and nothing of it half.
#include "common/base/random.h"
#include "server/store/sqlite_store.h"
#include "tests/server/store/stored_values.h"
#include "tests/support/temporary_folder.h"

#include <csignal>
#include <cstdint>
#include <cstdlib>
#include <gtest/gtest.h>
#include <poll.h>
#include <sys/wait.h>
#include <unistd.h>

namespace billiards::server {
namespace {

constexpr int kKills = 25;
constexpr std::uint64_t kEntriesInOneCommit = 3;

/// Appends to match 1 until it is killed; writes the last sequence number of each commit to
/// `acknowledged` once the store has said that it is durable.
[[noreturn]] void write_until_killed(const std::filesystem::path& file, std::uint64_t sequence,
                                     int acknowledged) {
    auto opened = open_sqlite_store(file);
    if (!opened) std::_Exit(1);
    for (;;) {
        std::vector<Write> writes{SaveMatch{some_match(1)}};
        for (std::uint64_t i = 0; i < kEntriesInOneCommit; ++i) {
            writes.push_back(AppendEntry{{1}, some_entry(++sequence, std::string(9000, 'r'))});
        }
        if (!opened.value()->commit(writes).ok()) std::_Exit(1);
        if (::write(acknowledged, &sequence, sizeof sequence) != sizeof sequence) std::_Exit(1);
    }
}

/// Runs a writer for as long as that many commits and the given time take, kills it, and gives
/// the last sequence number that it acknowledged.
std::uint64_t run_and_kill(const std::filesystem::path& file, std::uint64_t sequence, int commits,
                           std::chrono::microseconds further) {
    int ends[2];
    if (::pipe(ends) != 0) std::abort();
    const pid_t child = ::fork();
    if (child == 0) write_until_killed(file, sequence, ends[1]);
    ::close(ends[1]);
    std::uint64_t acknowledged = sequence;
    for (int i = 0; i < commits; ++i) {
        if (::read(ends[0], &acknowledged, sizeof acknowledged) != sizeof acknowledged) break;
    }
    // Not a wait for anything: the instant of the kill is what the test is about.
    const timespec until_the_kill{0, std::chrono::nanoseconds(further).count()};
    ::ppoll(nullptr, 0, &until_the_kill, nullptr);
    ::kill(child, SIGKILL);
    ::waitpid(child, nullptr, 0);
    while (::read(ends[0], &acknowledged, sizeof acknowledged) == sizeof acknowledged) {
    }
    ::close(ends[0]);
    return acknowledged;
}

TEST(KilledStore, LosesNothingItAcknowledgedAndHasNothingHalf) {
    const support::TemporaryFolder folder;
    const auto file = folder.path() / "test.db";
    base::Random random(20260131);
    std::uint64_t found = 0;
    for (int kill = 0; kill < kKills; ++kill) {
        const auto further = std::chrono::microseconds(random.below(4000));
        const std::uint64_t acknowledged =
            run_and_kill(file, found, 1 + static_cast<int>(random.below(3)), further);
        ASSERT_GT(acknowledged, found) << "the writer could not write";
        const auto store = open_sqlite_store(file);
        ASSERT_TRUE(store.ok()) << store.error().detail;
        const auto journal = whole_journal(**store, {1});
        ASSERT_TRUE(journal.ok()) << journal.error().detail;
        found = journal->size();
        EXPECT_GE(found, acknowledged);
        EXPECT_LE(found, acknowledged + kEntriesInOneCommit);  // Durable, and not yet said so.
        EXPECT_EQ(found % kEntriesInOneCommit, 0U);
        EXPECT_EQ(journal->back().sequence, found);
    }
}

}  // namespace
}  // namespace billiards::server
