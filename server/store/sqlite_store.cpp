// Takes the path of a database file; gives a MatchStore in SQLite.
#include "server/store/sqlite_store.h"

#include "common/protocol/limits.h"
#include "common/protocol/packing.h"
#include "server/store/sqlite_schema.h"

#include <SQLiteCpp/Column.h>
#include <SQLiteCpp/Database.h>
#include <SQLiteCpp/Statement.h>
#include <SQLiteCpp/Transaction.h>
#include <algorithm>
#include <exception>
#include <fmt/format.h>
#include <optional>
#include <sqlite3.h>
#include <string>
#include <utility>

namespace billiards::server {
namespace {

/// For a reader from outside, such as a backup, that holds the file for a moment.
constexpr int kBusyTimeout_ms = 5000;

StoreErrorCode code_of(const SQLite::Exception& error) {
    switch (error.getErrorCode() & 0xff) {  // The primary code is the lowest byte.
        case SQLITE_CANTOPEN:
        case SQLITE_PERM:
        case SQLITE_READONLY:
            return StoreErrorCode::CannotOpen;
        case SQLITE_CORRUPT:
        case SQLITE_NOTADB:
            return StoreErrorCode::Corrupt;
        case SQLITE_FULL:
            return StoreErrorCode::Full;
        case SQLITE_BUSY:
        case SQLITE_LOCKED:
            return StoreErrorCode::Busy;
        default:
            return StoreErrorCode::Failed;
    }
}

/// Runs what may throw; gives its result, or the exception as an error.
template <class Call>
auto guarded(const std::filesystem::path& file, const Call& call) -> decltype(call()) {
    try {
        return call();
    } catch (const SQLite::Exception& error) {
        return StoreError{code_of(error), fmt::format("{}: {}", file.string(), error.what())};
    } catch (const std::exception& error) {
        return StoreError{StoreErrorCode::Failed,
                          fmt::format("{}: {}", file.string(), error.what())};
    }
}

// SQLite's integers are signed; every identity and sequence number keeps its 64 bits.
std::int64_t stored(std::uint64_t number) {
    return static_cast<std::int64_t>(number);
}
std::uint64_t read_number(const SQLite::Column& column) {
    return static_cast<std::uint64_t>(column.getInt64());
}

template <class Container>
void bind_bytes(SQLite::Statement& statement, int index, const Container& bytes) {
    // A null pointer would bind NULL instead of no bytes.
    const void* data = bytes.empty() ? static_cast<const void*>("") : bytes.data();
    statement.bindNoCopy(index, data, static_cast<int>(bytes.size()));
}

protocol::Bytes read_bytes(const SQLite::Column& column) {
    const auto* data = static_cast<const std::byte*>(column.getBlob());
    return {data, data + column.getBytes()};
}

/// The columns of read_match.
constexpr const char* kMatch =
    "id, table_id, table_name, first_player, second_player, settings, engine";

StoredMatch read_match(SQLite::Statement& row) {
    StoredMatch match;
    match.match.value = read_number(row.getColumn(0));
    match.table.value = static_cast<std::uint32_t>(row.getColumn(1).getInt64());
    match.table_name = row.getColumn(2).getString();
    match.players[model::Seat::First].value = read_number(row.getColumn(3));
    match.players[model::Seat::Second].value = read_number(row.getColumn(4));
    match.settings = read_bytes(row.getColumn(5));
    match.engine = row.getColumn(6).getString();
    return match;
}

/// Of a row (sequence, command, verdict, final layout, record).
base::Result<StoredEntry, protocol::DecodeError> read_entry(SQLite::Statement& row) {
    const auto read_packed = [&](int index) {
        return protocol::unpacked(read_bytes(row.getColumn(index)), protocol::kMaxServerFrameBytes);
    };
    auto final_layout = read_packed(3);
    if (!final_layout) return std::move(final_layout).error();
    auto record = read_packed(4);
    if (!record) return std::move(record).error();
    return StoredEntry{.sequence = read_number(row.getColumn(0)),
                       .entry = {.command = read_bytes(row.getColumn(1)),
                                 .verdict = read_bytes(row.getColumn(2)),
                                 .final_layout = std::move(final_layout).value(),
                                 .record = std::move(record).value()}};
}

/// None where the column is NULL or has another length.
std::optional<TokenHash> read_hash(const SQLite::Column& column) {
    TokenHash hash;
    if (column.getBytes() != static_cast<int>(hash.size())) return std::nullopt;
    std::copy_n(static_cast<const std::uint8_t*>(column.getBlob()), hash.size(), hash.begin());
    return hash;
}

/// A prepared statement in use; ready to be used again once this is gone, whatever happened.
class Use {
  public:
    explicit Use(SQLite::Statement& statement) : statement_(statement) {}
    ~Use() { statement_.tryReset(); }
    Use(const Use&) = delete;
    Use& operator=(const Use&) = delete;

    SQLite::Statement* operator->() const { return &statement_; }
    SQLite::Statement& operator*() const { return statement_; }

  private:
    SQLite::Statement& statement_;
};

class SqliteStore final : public MatchStore {
  public:
    /// The file stands open and migrated.
    SqliteStore(SQLite::Database database, std::filesystem::path file)
        : database_(std::move(database)), file_(std::move(file)) {}

    StoreResult<base::Done> commit(std::span<const Write> writes) override;
    StoreResult<std::vector<StoredPlayer>> players() override;
    StoreResult<std::vector<StoredMatch>> live_matches() override;
    StoreResult<std::vector<EndedMatch>> ended_matches() override;
    StoreResult<std::vector<StoredEntry>> journal(MatchId match) override;
    StoreResult<HighestIds> highest_ids() override;

  private:
    void on(const SavePlayer& write);
    void on(const SaveMatch& write);
    void on(const AppendEntry& write);
    void on(const FinishMatch& write);
    void on(const SaveTable& write);
    void on(const RemoveTable& write);

    SQLite::Database database_;
    std::filesystem::path file_;
    SQLite::Statement save_player_{
        database_,
        "INSERT INTO players (id, name, token_hash, previous_token_hash) VALUES (?, ?, ?, ?) "
        "ON CONFLICT (id) DO UPDATE SET name = excluded.name, token_hash = excluded.token_hash, "
        "previous_token_hash = excluded.previous_token_hash"};
    SQLite::Statement save_match_{
        database_,
        "INSERT INTO matches (id, table_id, table_name, first_player, second_player, settings, "
        "engine, started_s) VALUES (?, ?, ?, ?, ?, ?, ?, unixepoch()) ON CONFLICT (id) DO UPDATE "
        "SET table_id = excluded.table_id, "
        "table_name = excluded.table_name, first_player = excluded.first_player, "
        "second_player = excluded.second_player, settings = excluded.settings, "
        "engine = excluded.engine"};
    SQLite::Statement append_entry_{
        database_,
        "INSERT INTO entries (match_id, seq, command, verdict, final_layout, record) "
        "VALUES (?, ?, ?, ?, ?, ?)"};
    SQLite::Statement finish_match_{database_, "UPDATE matches SET ended = 1 WHERE id = ?"};
};

void SqliteStore::on(const SavePlayer& write) {
    const Use use(save_player_);
    use->bind(1, stored(write.player.player.value));
    use->bindNoCopy(2, write.player.name);
    bind_bytes(*use, 3, write.player.token_hash);
    if (write.player.previous_token_hash) {
        bind_bytes(*use, 4, *write.player.previous_token_hash);
    } else {
        use->bind(4);  // NULL
    }
    use->exec();
}

void SqliteStore::on(const SaveMatch& write) {
    const Use use(save_match_);
    use->bind(1, stored(write.match.match.value));
    use->bind(2, stored(write.match.table.value));
    use->bindNoCopy(3, write.match.table_name);
    use->bind(4, stored(write.match.players[model::Seat::First].value));
    use->bind(5, stored(write.match.players[model::Seat::Second].value));
    bind_bytes(*use, 6, write.match.settings);
    use->bindNoCopy(7, write.match.engine);
    use->exec();
}

/// Large columns are packed here, where the thread is about to wait for the disk anyway.
void SqliteStore::on(const AppendEntry& write) {
    const protocol::EncodedEntry& entry = write.entry.entry;
    const protocol::Bytes final_layout = protocol::packed(entry.final_layout);
    const protocol::Bytes record = protocol::packed(entry.record);
    const Use use(append_entry_);
    use->bind(1, stored(write.match.value));
    use->bind(2, stored(write.entry.sequence));
    bind_bytes(*use, 3, entry.command);
    bind_bytes(*use, 4, entry.verdict);
    bind_bytes(*use, 5, final_layout);
    bind_bytes(*use, 6, record);
    use->exec();
}

void SqliteStore::on(const FinishMatch& write) {
    const Use use(finish_match_);
    use->bind(1, stored(write.match.value));
    use->exec();
}

void SqliteStore::on(const SaveTable& /*write*/) {}

void SqliteStore::on(const RemoveTable& /*write*/) {}

StoreResult<base::Done> SqliteStore::commit(std::span<const Write> writes) {
    return guarded(file_, [&]() -> StoreResult<base::Done> {
        SQLite::Transaction transaction(database_, SQLite::TransactionBehavior::IMMEDIATE);
        for (const Write& write : writes) {
            std::visit([this](const auto& one) { on(one); }, write);
        }
        transaction.commit();
        return base::Done{};
    });
}

StoreResult<std::vector<StoredPlayer>> SqliteStore::players() {
    return guarded(file_, [&]() -> StoreResult<std::vector<StoredPlayer>> {
        std::vector<StoredPlayer> players;
        SQLite::Statement rows(database_,
                               "SELECT id, name, token_hash, previous_token_hash FROM players "
                               "ORDER BY id");
        while (rows.executeStep()) {
            const auto hash = read_hash(rows.getColumn(2));
            const auto previous = read_hash(rows.getColumn(3));
            if (!hash || (!previous && !rows.isColumnNull(3))) {
                return StoreError{StoreErrorCode::Corrupt,
                                  fmt::format("{}: a token hash of player {} has another length",
                                              file_.string(), read_number(rows.getColumn(0)))};
            }
            players.push_back(
                {{read_number(rows.getColumn(0))}, rows.getColumn(1).getString(), *hash, previous});
        }
        return players;
    });
}

StoreResult<std::vector<StoredMatch>> SqliteStore::live_matches() {
    return guarded(file_, [&]() -> StoreResult<std::vector<StoredMatch>> {
        std::vector<StoredMatch> matches;
        SQLite::Statement rows(
            database_, fmt::format("SELECT {} FROM matches WHERE ended = 0 ORDER BY id", kMatch));
        while (rows.executeStep()) matches.push_back(read_match(rows));
        return matches;
    });
}

StoreResult<std::vector<EndedMatch>> SqliteStore::ended_matches() {
    return guarded(file_, [&]() -> StoreResult<std::vector<EndedMatch>> {
        std::vector<EndedMatch> matches;
        SQLite::Statement rows(
            database_,
            fmt::format("SELECT {}, started_s FROM matches WHERE ended = 1 ORDER BY id", kMatch));
        while (rows.executeStep()) {
            matches.push_back({read_match(rows), rows.getColumn("started_s").getInt64()});
        }
        return matches;
    });
}

StoreResult<std::vector<StoredEntry>> SqliteStore::journal(MatchId match) {
    return guarded(file_, [&]() -> StoreResult<std::vector<StoredEntry>> {
        std::vector<StoredEntry> entries;
        SQLite::Statement rows(database_,
                               "SELECT seq, command, verdict, final_layout, record FROM entries "
                               "WHERE match_id = ? ORDER BY seq");
        rows.bind(1, stored(match.value));
        while (rows.executeStep()) {
            auto entry = read_entry(rows);
            if (!entry) {
                return StoreError{
                    StoreErrorCode::Corrupt,
                    fmt::format("{}: entry {} of match {}: {}", file_.string(),
                                read_number(rows.getColumn(0)), match.value, entry.error().detail)};
            }
            entries.push_back(std::move(entry).value());
        }
        return entries;
    });
}

StoreResult<MatchStore::HighestIds> SqliteStore::highest_ids() {
    return guarded(file_, [&]() -> StoreResult<HighestIds> {
        SQLite::Statement row(database_,
                              "SELECT (SELECT ifnull(max(id), 0) FROM players), "
                              "(SELECT ifnull(max(id), 0) FROM matches), "
                              "(SELECT ifnull(max(table_id), 0) FROM matches)");
        row.executeStep();
        return HighestIds{.player = read_number(row.getColumn(0)),
                          .match = read_number(row.getColumn(1)),
                          .table = static_cast<std::uint32_t>(row.getColumn(2).getInt64())};
    });
}

/// Durable means: in the log, and the log on the disk, before commit() returns.
StoreResult<base::Done> set_up(SQLite::Database& database, const std::filesystem::path& file) {
    // A file that may only be read opens all the same: better to know now than at the first match.
    if (sqlite3_db_readonly(database.getHandle(), "main") != 0) {
        return StoreError{StoreErrorCode::CannotOpen, file.string() + ": may not be written"};
    }
    const std::string mode = database.execAndGet("PRAGMA journal_mode = WAL").getString();
    if (mode != "wal") {
        return StoreError{StoreErrorCode::CannotOpen,
                          file.string() + ": this file system does not bear a write-ahead log"};
    }
    database.exec("PRAGMA synchronous = FULL; PRAGMA foreign_keys = ON");
    return base::Done{};
}

}  // namespace

StoreResult<std::unique_ptr<MatchStore>> open_sqlite_store(const std::filesystem::path& file) {
    using Opened = StoreResult<std::unique_ptr<MatchStore>>;
    return guarded(file, [&]() -> Opened {
        SQLite::Database database(file.string(), SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE,
                                  kBusyTimeout_ms);
        auto migrated = migrate(database, file);
        if (!migrated) return std::move(migrated).error();
        auto set = set_up(database, file);
        if (!set) return std::move(set).error();
        return Opened(std::make_unique<SqliteStore>(std::move(database), file));
    });
}

StoreResult<std::unique_ptr<MatchStore>> open_sqlite_reader(const std::filesystem::path& file) {
    using Opened = StoreResult<std::unique_ptr<MatchStore>>;
    return guarded(file, [&]() -> Opened {
        SQLite::Database database(file.string(), SQLite::OPEN_READONLY, kBusyTimeout_ms);
        auto checked = check_version(database, file);
        if (!checked) return std::move(checked).error();
        return Opened(std::make_unique<SqliteStore>(std::move(database), file));
    });
}

}  // namespace billiards::server
