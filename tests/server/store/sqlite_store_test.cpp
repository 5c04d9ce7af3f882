// Holds the SQLite store against the contract of every store, and against files that are not fit.
#include "server/store/sqlite_store.h"

#include "tests/server/store/match_store_contract.h"
#include "tests/support/temporary_folder.h"

#include <SQLiteCpp/Database.h>
#include <fstream>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace billiards::server {
namespace {

using support::TemporaryFolder;

std::unique_ptr<MatchStore> open_or_throw(const std::filesystem::path& file) {
    auto opened = open_sqlite_store(file);
    if (!opened) throw std::runtime_error(opened.error().detail);
    return std::move(opened).value();
}

struct SqliteFile {
    TemporaryFolder folder;
    std::unique_ptr<MatchStore> open() { return open_or_throw(folder.path() / "test.db"); }
};

INSTANTIATE_TYPED_TEST_SUITE_P(Sqlite, MatchStoreContract, SqliteFile);

TEST(SqliteStore, WhatWasCommittedIsInTheFilesWithoutAClosing) {
    const TemporaryFolder folder;
    const TemporaryFolder copy;
    const auto store = open_or_throw(folder.path() / "test.db");
    ASSERT_TRUE(store->commit(std::vector<Write>{SavePlayer{some_player(1)}}).ok());
    for (const auto& file : std::filesystem::directory_iterator(folder.path())) {
        if (file.path().extension() == ".db-shm") continue;  // Of memory: a crash loses it.
        std::filesystem::copy_file(file.path(), copy.path() / file.path().filename());
    }
    const auto after_crash = open_or_throw(copy.path() / "test.db");
    EXPECT_EQ(after_crash->players().value(), std::vector{some_player(1)});
}

TEST(SqliteStore, RefusesAFileOfANewerVersionAndLeavesItAsItWas) {
    const TemporaryFolder folder;
    const auto file = folder.path() / "test.db";
    SQLite::Database(file.string(), SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE)
        .exec("PRAGMA user_version = 4711");
    const auto opened = open_sqlite_store(file);
    ASSERT_FALSE(opened.ok());
    EXPECT_EQ(opened.error().code, StoreErrorCode::Newer);
    EXPECT_THAT(opened.error().detail, testing::HasSubstr(file.string()));
    EXPECT_THAT(opened.error().detail, testing::HasSubstr("4711"));
    SQLite::Database untouched(file.string(), SQLite::OPEN_READWRITE);
    EXPECT_FALSE(untouched.tableExists("players"));
}

TEST(SqliteStore, RefusesAFileThatIsNoDatabase) {
    const TemporaryFolder folder;
    const auto file = folder.path() / "test.db";
    std::ofstream(file) << std::string(8192, 'x');
    const auto opened = open_sqlite_store(file);
    ASSERT_FALSE(opened.ok());
    EXPECT_EQ(opened.error().code, StoreErrorCode::Corrupt);
}

TEST(SqliteStore, NamesTheFileThatCannotBeOpened) {
    const TemporaryFolder folder;
    const auto file = folder.path() / "missing" / "test.db";
    const auto opened = open_sqlite_store(file);
    ASSERT_FALSE(opened.ok());
    EXPECT_EQ(opened.error().code, StoreErrorCode::CannotOpen);
    EXPECT_THAT(opened.error().detail, testing::HasSubstr(file.string()));
}

/// A store that holds entry 1 of match 1, with the statement done to its file.
StoreResult<std::vector<StoredEntry>> journal_after(const std::string& statement) {
    const TemporaryFolder folder;
    const auto file = folder.path() / "test.db";
    const auto store = open_or_throw(file);
    EXPECT_TRUE(store->commit(
        std::vector<Write>{SaveMatch{some_match(1)}, AppendEntry{{1}, some_entry(1)}}));
    SQLite::Database(file.string(), SQLite::OPEN_READWRITE).exec(statement);
    return whole_journal(*store, {1});
}

TEST(SqliteStore, KeepsRecordsPacked) {
    const TemporaryFolder folder;
    const auto file = folder.path() / "test.db";
    const auto store = open_or_throw(file);
    const std::string record(10'000, 'r');
    ASSERT_TRUE(store->commit(
        std::vector<Write>{SaveMatch{some_match(1)}, AppendEntry{{1}, some_entry(1, record)}}));
    SQLite::Database database(file.string());
    EXPECT_LT(database.execAndGet("SELECT length(record) FROM entries").getInt(), 100);
    EXPECT_EQ(whole_journal(*store, {1}).value().at(0).entry.record, bytes_of(record));
}

TEST(SqliteStore, ReadsColumnsThatWereNeverPacked) {
    const auto journal = journal_after(
        "UPDATE entries SET record = x'00000000', "
        "final_layout = x'0000000001'");
    ASSERT_TRUE(journal.ok());
    EXPECT_EQ(journal->at(0).entry.record, protocol::Bytes(4));
    EXPECT_EQ(journal->at(0).entry.final_layout.size(), 5U);
}

TEST(SqliteStore, SaysCorruptWhereARecordCannotBeUnpacked) {
    const auto journal = journal_after("UPDATE entries SET record = x'28b52ffd00'");
    ASSERT_FALSE(journal.ok());
    EXPECT_EQ(journal.error().code, StoreErrorCode::Corrupt);
    EXPECT_THAT(journal.error().detail, testing::HasSubstr("entry 1 of match 1"));
}

TEST(SqliteStore, SaysCorruptWhereATokenHashHasAnotherLength) {
    const TemporaryFolder folder;
    const auto file = folder.path() / "test.db";
    const auto store = open_or_throw(file);
    SQLite::Database(file.string(), SQLite::OPEN_READWRITE)
        .exec("INSERT INTO players (id, name, token_hash) VALUES (1, 'Ada', x'00')");
    const auto players = store->players();
    ASSERT_FALSE(players.ok());
    EXPECT_EQ(players.error().code, StoreErrorCode::Corrupt);
}

}  // namespace
}  // namespace billiards::server
