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
};

}  // namespace

StoreResult<base::Done> migrate(SQLite::Database& database, const std::filesystem::path& file) {
    const int found = database.execAndGet("PRAGMA user_version").getInt();
    const int known = static_cast<int>(kMigrations.size());
    if (found > known) {
        return StoreError{StoreErrorCode::Newer,
                          fmt::format("{} was written by a newer version of this program: its "
                                      "tables are version {}, this program knows up to {}",
                                      file.string(), found, known)};
    }
    for (int version = found; version < known; ++version) {
        SQLite::Transaction transaction(database, SQLite::TransactionBehavior::EXCLUSIVE);
        database.exec(kMigrations.at(static_cast<std::size_t>(version)));
        database.exec(fmt::format("PRAGMA user_version = {}", version + 1));
        transaction.commit();
    }
    return base::Done{};
}

}  // namespace billiards::server
