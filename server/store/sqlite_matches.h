// Takes an open SQLite database; keeps the matches in it, each with its journal.
#pragma once

#include "server/store/match_store.h"

#include <SQLiteCpp/Database.h>
#include <SQLiteCpp/Statement.h>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <utility>
#include <vector>

namespace billiards::server {

/// Everything here throws SQLite::Exception.
class SqliteMatches {
  public:
    /// `file` is named by what journal() finds corrupt.
    SqliteMatches(SQLite::Database& database, std::filesystem::path file)
        : database_(database), file_(std::move(file)) {}

    void save(const StoredMatch& match, std::int64_t started_s);
    void append(MatchId match, const StoredEntry& entry);
    /// None where no such match is being played.
    std::optional<model::PerSeat<PlayerId>> players_of_live(MatchId match);
    /// `age_s` is that of the store, now.
    void finish(MatchId match, std::int64_t age_s);
    void remove(MatchId match);

    std::vector<StoredMatch> live();
    std::vector<EndedMatch> ended();
    std::optional<KnownMatch> last_at(protocol::TableId table);
    std::optional<KnownMatch> find(MatchId match);
    /// As MatchStore::journal.
    StoreResult<base::Done> journal(MatchId match, const EntryVisitor& visit,
                                    std::uint64_t records_from);

  private:
    std::optional<KnownMatch> match_where(const char* condition, std::uint64_t id);

    SQLite::Database& database_;
    std::filesystem::path file_;
    SQLite::Statement save_{
        database_,
        "INSERT INTO matches (id, table_id, table_name, first_player, second_player, settings, "
        "engine, started_s) VALUES (?, ?, ?, ?, ?, ?, ?, ?) ON CONFLICT (id) DO UPDATE "
        "SET table_id = excluded.table_id, "
        "table_name = excluded.table_name, first_player = excluded.first_player, "
        "second_player = excluded.second_player, settings = excluded.settings, "
        "engine = excluded.engine"};
    SQLite::Statement append_{
        database_,
        "INSERT INTO entries (match_id, seq, command, verdict, final_layout, record) "
        "VALUES (?, ?, ?, ?, ?, ?)"};
    SQLite::Statement finish_{database_,
                              "UPDATE matches SET ended = 1, ended_age_s = ? WHERE id = ?"};
};

}  // namespace billiards::server
