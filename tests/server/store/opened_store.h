// Gives a test a SQLite store in a folder of its own, with clocks that the test sets.
#pragma once

#include "server/store/sqlite_store.h"
#include "tests/server/store/stored_values.h"
#include "tests/support/temporary_folder.h"

#include <gtest/gtest.h>
#include <memory>
#include <optional>
#include <stdexcept>
#include <utility>
#include <vector>

namespace billiards::server {

inline constexpr std::int64_t kTestDay_s = 24 * 60 * 60;
inline constexpr std::int64_t kTestToday_s = 1'790'000'000;  ///< In 2026.

class StoreTest : public testing::Test {
  protected:
    void open() {
        store.reset();
        options.clock = [this] { return times; };
        auto opened = open_sqlite_store(file, options);
        if (!opened) throw std::runtime_error(opened.error().detail);
        store = std::move(opened).value();
    }
    /// The server runs for so long.
    void pass(std::int64_t duration_s) {
        times.steady_s += duration_s;
        times.calendar_s += duration_s;
    }
    void commit(const std::vector<Write>& writes) {
        const auto done = store->commit(writes);
        ASSERT_TRUE(done.ok()) << done.error().detail;
    }
    StoreErrorCode failure(const std::vector<Write>& writes) {
        const auto done = store->commit(writes);
        EXPECT_FALSE(done.ok());
        return done.ok() ? StoreErrorCode::Failed : done.error().code;
    }
    /// A match between the two, with one entry, that has ended with this result.
    void play(std::uint64_t match, std::uint64_t first, std::uint64_t second, MatchResult result) {
        StoredMatch stored = some_match(match);
        stored.players = {{{PlayerId{first}, PlayerId{second}}}};
        if (result.shots == 0) result.shots = 1;
        commit(
            {SaveMatch{stored}, AppendEntry{{match}, some_entry(1)}, FinishMatch{{match}, result}});
    }
    static MatchResult won_by(model::Seat seat) {
        MatchResult result;
        result.winner = seat;
        return result;
    }

    support::TemporaryFolder folder;
    std::filesystem::path file = folder.path() / "billiards.db";
    StoreTimes times{.calendar_s = kTestToday_s, .steady_s = 1000};
    SqliteOptions options;
    std::unique_ptr<MatchStore> store;
};

}  // namespace billiards::server
