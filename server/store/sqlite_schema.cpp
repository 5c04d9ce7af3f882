// Takes an open SQLite database; gives it the tables of this version.
#include "server/store/sqlite_schema.h"

#include <SQLiteCpp/Transaction.h>
#include <array>
#include <fmt/format.h>

namespace billiards::server {
namespace {

/// The n-th takes a file from version n to n + 1 (PRAGMA user_version). Only append: what a
/// release has applied to a file is never changed.
constexpr std::array kMigrations = {
    R"sql(
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
)sql",
    R"sql(
ALTER TABLE matches ADD COLUMN engine TEXT NOT NULL DEFAULT 'unknown';
ALTER TABLE matches ADD COLUMN started_s INTEGER NOT NULL DEFAULT 0;
)sql",
};

constexpr int kKnownVersion = static_cast<int>(kMigrations.size());

int version_of(SQLite::Database& database) {
    return database.execAndGet("PRAGMA user_version").getInt();
}

StoreError newer(const std::filesystem::path& file, int found) {
    return {StoreErrorCode::Newer,
            fmt::format("{} was written by a newer version of this program: its tables are "
                        "version {}, this program knows up to {}",
                        file.string(), found, kKnownVersion)};
}

}  // namespace

StoreResult<base::Done> migrate(SQLite::Database& database, const std::filesystem::path& file) {
    const int found = version_of(database);
    if (found > kKnownVersion) return newer(file, found);
    for (int version = found; version < kKnownVersion; ++version) {
        SQLite::Transaction transaction(database, SQLite::TransactionBehavior::EXCLUSIVE);
        database.exec(kMigrations.at(static_cast<std::size_t>(version)));
        database.exec(fmt::format("PRAGMA user_version = {}", version + 1));
        transaction.commit();
    }
    return base::Done{};
}

StoreResult<base::Done> check_version(SQLite::Database& database,
                                      const std::filesystem::path& file) {
    const int found = version_of(database);
    if (found > kKnownVersion) return newer(file, found);
    if (found == kKnownVersion) return base::Done{};
    return StoreError{StoreErrorCode::CannotOpen,
                      fmt::format("{} was written by an older version of this program: start the "
                                  "server on it once",
                                  file.string())};
}

}  // namespace billiards::server
