// Takes an open SQLite database; gives it the tables of this version.
#include "server/store/sqlite_schema.h"

#include <SQLiteCpp/Transaction.h>
#include <array>
#include <cstddef>
#include <fmt/format.h>
#include <sqlite3.h>

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
    // Ages, and columns named *_age_s, shown_from_s, seen_s and *rated_s: see sqlite_age.h. A
    // match's `ended` is 0: live, 1: over, 2: over, and its journal is being dropped.
    R"sql(
CREATE TABLE age (
    age_s      INTEGER NOT NULL,
    steady_s   INTEGER NOT NULL,
    calendar_s INTEGER NOT NULL
) STRICT;
INSERT INTO age VALUES (0, 0, unixepoch());
CREATE TABLE highest_ids (
    kind TEXT PRIMARY KEY,
    id   INTEGER NOT NULL
) STRICT, WITHOUT ROWID;
INSERT INTO highest_ids VALUES
    ('player', (SELECT ifnull(max(id), 0) FROM players)),
    ('match', (SELECT ifnull(max(id), 0) FROM matches)),
    ('table', (SELECT ifnull(max(table_id), 0) FROM matches));

ALTER TABLE players ADD COLUMN seen_s INTEGER NOT NULL DEFAULT 0;
CREATE INDEX players_by_name ON players (name);

ALTER TABLE matches ADD COLUMN ended_age_s INTEGER NOT NULL DEFAULT 0;
CREATE INDEX matches_ended ON matches (ended_age_s, id) WHERE ended = 1;
CREATE INDEX matches_dropped ON matches (id) WHERE ended = 2;

CREATE TABLE tables (
    id            INTEGER PRIMARY KEY,
    name          TEXT    NOT NULL,
    settings      BLOB    NOT NULL,
    owner         INTEGER NOT NULL,
    is_private    INTEGER NOT NULL,
    passcode_hash BLOB,
    passcode_salt BLOB    NOT NULL,
    first_seat    INTEGER,
    second_seat   INTEGER
) STRICT;
CREATE TABLE table_invites (
    table_id       INTEGER NOT NULL REFERENCES tables (id),
    position       INTEGER NOT NULL,
    hash           BLOB    NOT NULL,
    is_for_playing INTEGER NOT NULL,
    PRIMARY KEY (table_id, position)
) STRICT, WITHOUT ROWID;
CREATE TABLE table_kicked (
    table_id INTEGER NOT NULL REFERENCES tables (id),
    position INTEGER NOT NULL,
    player   INTEGER NOT NULL,
    PRIMARY KEY (table_id, position)
) STRICT, WITHOUT ROWID;
INSERT INTO tables
    SELECT table_id, table_name, without_seed(settings), first_player, 0, NULL, zeroblob(16),
           first_player, second_player
    FROM matches WHERE id IN (SELECT max(id) FROM matches WHERE ended = 0 GROUP BY table_id);

CREATE TABLE results (
    match_id      INTEGER PRIMARY KEY,
    ended_s       INTEGER NOT NULL,
    shown_from_s  INTEGER NOT NULL,
    is_private    INTEGER NOT NULL,
    first_player  INTEGER NOT NULL,
    second_player INTEGER NOT NULL,
    game          INTEGER NOT NULL,
    ending        INTEGER NOT NULL,
    winner        INTEGER,
    first_racks   INTEGER NOT NULL,
    second_racks  INTEGER NOT NULL,
    shots         INTEGER NOT NULL
) STRICT;
CREATE INDEX results_public ON results (match_id) WHERE is_private = 0;
CREATE TABLE standings (
    id              INTEGER PRIMARY KEY,
    player          INTEGER NOT NULL,
    match_id        INTEGER NOT NULL REFERENCES results (match_id),
    opponent        INTEGER NOT NULL,
    is_private      INTEGER NOT NULL,
    games           INTEGER NOT NULL,
    wins            INTEGER NOT NULL,
    draws           INTEGER NOT NULL,
    rating          REAL    NOT NULL,
    deviation       REAL    NOT NULL,
    rated_s         INTEGER NOT NULL,
    shown_games     INTEGER NOT NULL,
    shown_wins      INTEGER NOT NULL,
    shown_draws     INTEGER NOT NULL,
    shown_rating    REAL    NOT NULL,
    shown_deviation REAL    NOT NULL,
    shown_rated_s   INTEGER NOT NULL,
    shown_from_s    INTEGER NOT NULL
) STRICT;
CREATE INDEX standings_newest ON standings (player);
CREATE INDEX standings_own ON standings (player, match_id);
CREATE INDEX standings_shown ON standings (player, is_private, match_id);
CREATE INDEX standings_between ON standings (player, opponent, match_id);
)sql",
};

constexpr int kKnownVersion = static_cast<int>(kMigrations.size());

/// SQL's way to settings as a table keeps them. What cannot be read is left as it is.
void without_seed(sqlite3_context* context, int /*count*/, sqlite3_value** values) {
    const auto* data = static_cast<const std::byte*>(sqlite3_value_blob(values[0]));
    const auto size = static_cast<std::size_t>(sqlite3_value_bytes(values[0]));
    const auto settings = protocol::decode_settings({data, size});
    if (!settings) return sqlite3_result_value(context, values[0]);
    const protocol::Bytes bytes = protocol::encode_settings(settings->settings, 0);
    sqlite3_result_blob(context, bytes.data(), static_cast<int>(bytes.size()), SQLITE_TRANSIENT);
}

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
    // Only before the first table can a file be made so that its free pages may be given back.
    if (found == 0) database.exec("PRAGMA auto_vacuum = INCREMENTAL");
    database.createFunction("without_seed", 1, true, nullptr, without_seed);
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
