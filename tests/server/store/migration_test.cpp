// Holds the store against files that earlier versions of this program have made.
#include "server/store/sqlite_store.h"
#include "tests/server/store/stored_values.h"
#include "tests/support/temporary_folder.h"

#include <SQLiteCpp/Database.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace billiards::server {
namespace {

constexpr const char* kFirstTables = R"sql(
CREATE TABLE players (
    id                  INTEGER PRIMARY KEY,
    name                TEXT NOT NULL,
    token_hash          BLOB NOT NULL,
    previous_token_hash BLOB
) STRICT;
CREATE TABLE matches (
    id            INTEGER PRIMARY KEY,
    table_id      INTEGER NOT NULL,
    table_name    TEXT    NOT NULL,
    first_player  INTEGER NOT NULL,
    second_player INTEGER NOT NULL,
    settings      BLOB    NOT NULL,
    ended         INTEGER NOT NULL DEFAULT 0
) STRICT;
CREATE INDEX matches_live ON matches (id) WHERE ended = 0;
CREATE INDEX matches_by_table ON matches (table_id);
CREATE TABLE entries (
    match_id     INTEGER NOT NULL REFERENCES matches (id),
    seq          INTEGER NOT NULL,
    command      BLOB    NOT NULL,
    verdict      BLOB    NOT NULL,
    final_layout BLOB    NOT NULL,
    record       BLOB    NOT NULL,
    PRIMARY KEY (match_id, seq)
) STRICT;
PRAGMA user_version = 1;
)sql";

constexpr const char* kSecondTables = R"sql(
ALTER TABLE matches ADD COLUMN engine TEXT NOT NULL DEFAULT 'unknown';
ALTER TABLE matches ADD COLUMN started_s INTEGER NOT NULL DEFAULT 0;
PRAGMA user_version = 2;
)sql";

std::unique_ptr<MatchStore> opened(const std::filesystem::path& file) {
    auto store = open_sqlite_store(file);
    if (!store) throw std::runtime_error(store.error().detail);
    return std::move(store).value();
}

class Migration : public testing::Test {
  protected:
    void make(const std::string& sql) {
        SQLite::Database(file.string(), SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE).exec(sql);
    }

    support::TemporaryFolder folder;
    const std::filesystem::path file = folder.path() / "test.db";
};

TEST_F(Migration, IsForTheServerAlone) {
    make(kFirstTables);
    const auto before = open_sqlite_reader(file);
    ASSERT_FALSE(before.ok());
    EXPECT_THAT(before.error().detail, testing::HasSubstr("older version"));
    ASSERT_TRUE(open_sqlite_store(file).ok());
    EXPECT_TRUE(open_sqlite_reader(file).ok());
}

TEST_F(Migration, KeepsTheMatchesOfTheFirstVersion) {
    make(kFirstTables);
    make("INSERT INTO matches VALUES (1, 1, 'Friday', 1, 2, x'', 1)");
    const auto ended = opened(file)->ended_matches().value();
    ASSERT_EQ(ended.size(), 1U);
    EXPECT_EQ(ended[0].match.engine, "unknown");
    EXPECT_EQ(ended[0].started_s, 0);
}

TEST_F(Migration, GivesEachLiveMatchOfTheSecondVersionItsTableWithoutTheSeed) {
    make(kFirstTables);
    make(kSecondTables);
    match::Settings settings;
    settings.race_to = 7;
    {
        SQLite::Database database(file.string(), SQLite::OPEN_READWRITE);
        SQLite::Statement match(database,
                                "INSERT INTO matches VALUES (?, ?, 'Friday', 3, 4, ?, ?, '1', 0)");
        const protocol::Bytes bytes = protocol::encode_settings(settings, 77);
        for (const auto& [id, table, ended] : {std::tuple(8, 5, 0), std::tuple(9, 6, 1)}) {
            match.bind(1, id);
            match.bind(2, table);
            match.bind(3, bytes.data(), static_cast<int>(bytes.size()));
            match.bind(4, ended);
            match.exec();
            match.reset();
        }
    }
    const auto store = opened(file);
    StoredTable table = some_table(5);
    table.settings = protocol::encode_settings(settings, 0);
    table.owner = {3};
    table.seats = {{{PlayerId{3}, PlayerId{4}}}};
    EXPECT_EQ(store->tables().value(), std::vector{table});
    EXPECT_EQ(store->live_matches().value().at(0).match, MatchId{8});
}

TEST_F(Migration, GoesOnCountingWhereTheOlderVersionStopped) {
    make(kFirstTables);
    make(
        "INSERT INTO matches VALUES (12, 9, 'Friday', 1, 2, x'', 1);"
        "INSERT INTO players VALUES (31, 'Ada', zeroblob(32), NULL)");
    const auto highest = opened(file)->highest_ids().value();
    EXPECT_EQ(highest.player, 31U);
    EXPECT_EQ(highest.match, 12U);
    EXPECT_EQ(highest.table, 9U);
}

}  // namespace
}  // namespace billiards::server
