// Takes the path of a database file; gives a MatchStore in SQLite.
#include "server/store/sqlite_store.h"

#include "server/store/opened_file.h"
#include "server/store/sqlite_age.h"
#include "server/store/sqlite_errors.h"
#include "server/store/sqlite_matches.h"
#include "server/store/sqlite_results.h"
#include "server/store/sqlite_row.h"
#include "server/store/sqlite_schema.h"
#include "server/store/sqlite_sweep.h"
#include "server/store/sqlite_tables.h"

#include <SQLiteCpp/Database.h>
#include <SQLiteCpp/Statement.h>
#include <SQLiteCpp/Transaction.h>
#include <fmt/format.h>
#include <sqlite3.h>
#include <string>
#include <utility>

namespace billiards::server {
namespace {

/// Of the write-ahead log, once it has been copied into the file: a long reader lets it grow.
constexpr int kLogKept_bytes = 64 * 1024 * 1024;

class SqliteStore final : public MatchStore {
  public:
    /// The file stands open and migrated.
    SqliteStore(SQLite::Database database, std::filesystem::path file, StoreClock clock)
        : database_(std::move(database)),
          file_(std::move(file)),
          age_(database_, std::move(clock)) {}

    StoreResult<base::Done> commit(std::span<const Write> writes) override;
    StoreResult<std::vector<StoredPlayer>> players() override;
    StoreResult<std::vector<StoredTable>> tables() override;
    StoreResult<std::vector<StoredMatch>> live_matches() override;
    StoreResult<std::vector<EndedMatch>> ended_matches() override;
    StoreResult<std::optional<KnownMatch>> last_match(protocol::TableId table) override;
    StoreResult<std::optional<KnownMatch>> find_match(MatchId match) override;
    StoreResult<base::Done> journal(MatchId match, const EntryVisitor& visit,
                                    std::uint64_t records_from) override;
    StoreResult<HighestIds> highest_ids() override;
    StoreResult<std::optional<PlayerId>> player_named(const std::string& name) override;
    StoreResult<std::vector<StoredResult>> history(const HistoryQuery& query) override;
    StoreResult<bool> may_see(MatchId match, PlayerId asker) override;
    StoreResult<Standing> standing(PlayerId player, PlayerId asker) override;
    StoreResult<Swept> sweep(const Retention& retention) override;

  private:
    void on(const SavePlayer& write);
    void on(const SaveMatch& write);
    void on(const AppendEntry& write);
    void on(const FinishMatch& write);
    void on(const SaveTable& write);
    void on(const RemoveTable& write);
    void given(const char* kind, std::uint64_t id);
    std::optional<StoreError> gone() const;
    /// What `call` gives, where only SQLite can find something wrong.
    template <class Call>
    auto read(const Call& call) -> StoreResult<decltype(call())> {
        return guarded(file_, [&]() -> StoreResult<decltype(call())> { return call(); });
    }

    SQLite::Database database_;
    std::filesystem::path file_;
    SqliteAge age_;
    OpenedFile opened_{file_};
    SqliteMatches matches_{database_, file_};
    SqliteTables tables_{database_};
    SqliteResults results_{database_};
    SQLite::Statement save_player_{
        database_,
        "INSERT INTO players (id, name, token_hash, previous_token_hash, seen_s) "
        "VALUES (?, ?, ?, ?, ?) ON CONFLICT (id) DO UPDATE SET name = excluded.name, "
        "token_hash = excluded.token_hash, previous_token_hash = excluded.previous_token_hash, "
        "seen_s = excluded.seen_s"};
    SQLite::Statement given_{database_, "UPDATE highest_ids SET id = max(id, ?) WHERE kind = ?"};
};

void SqliteStore::on(const SavePlayer& write) {
    given("player", write.player.player.value);
    const Use use(save_player_);
    use->bind(1, stored(write.player.player.value));
    use->bindNoCopy(2, write.player.name);
    bind_bytes(*use, 3, write.player.token_hash);
    bind_bytes(*use, 4, write.player.previous_token_hash);
    use->bind(5, age_.now_s());
    use->exec();
}

void SqliteStore::on(const SaveMatch& write) {
    given("match", write.match.match.value);
    given("table", write.match.table.value);
    matches_.save(write.match, age_.calendar_s());
}

void SqliteStore::on(const AppendEntry& write) {
    matches_.append(write.match, write.entry);
}

void SqliteStore::on(const FinishMatch& write) {
    const auto players = matches_.players_of_live(write.match);
    if (!players) return;
    if (write.result.shots == 0) return matches_.remove(write.match);
    const Ended ended{.match = write.match,
                      .players = *players,
                      .result = write.result,
                      .age_s = age_.now_s(),
                      .calendar_s = age_.calendar_s()};
    matches_.finish(ended.match, ended.age_s);
    results_.add(ended);
}

void SqliteStore::on(const SaveTable& write) {
    given("table", write.table.table.value);
    tables_.save(write.table);
}

void SqliteStore::on(const RemoveTable& write) {
    tables_.remove(write.table);
}

void SqliteStore::given(const char* kind, std::uint64_t id) {
    const Use use(given_);
    use->bind(1, stored(id));
    use->bind(2, kind);
    use->exec();
}

std::optional<StoreError> SqliteStore::gone() const {
    if (opened_.is_still_there()) return std::nullopt;
    return StoreError{StoreErrorCode::Gone,
                      fmt::format("{}: was deleted, moved or replaced while it was in use: put it "
                                  "back, or start the server again",
                                  file_.string())};
}

StoreResult<base::Done> SqliteStore::commit(std::span<const Write> writes) {
    return guarded(file_, [&]() -> StoreResult<base::Done> {
        SQLite::Transaction transaction(database_, SQLite::TransactionBehavior::IMMEDIATE);
        for (const Write& write : writes) {
            std::visit([this](const auto& one) { on(one); }, write);
        }
        if (auto error = gone()) return *std::move(error);
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
            const auto hash = read_array<std::tuple_size_v<TokenHash>>(rows.getColumn(2));
            const auto previous = read_array<std::tuple_size_v<TokenHash>>(rows.getColumn(3));
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

StoreResult<std::vector<StoredTable>> SqliteStore::tables() {
    return read([&] { return tables_.all(); });
}

StoreResult<std::vector<StoredMatch>> SqliteStore::live_matches() {
    return read([&] { return matches_.live(); });
}

StoreResult<std::vector<EndedMatch>> SqliteStore::ended_matches() {
    return read([&] { return matches_.ended(); });
}

StoreResult<std::optional<KnownMatch>> SqliteStore::last_match(protocol::TableId table) {
    return read([&] { return matches_.last_at(table); });
}

StoreResult<std::optional<KnownMatch>> SqliteStore::find_match(MatchId match) {
    return read([&] { return matches_.find(match); });
}

StoreResult<base::Done> SqliteStore::journal(MatchId match, const EntryVisitor& visit,
                                             std::uint64_t records_from) {
    return guarded(file_, [&] { return matches_.journal(match, visit, records_from); });
}

StoreResult<MatchStore::HighestIds> SqliteStore::highest_ids() {
    return read([&] {
        SQLite::Statement row(database_,
                              "SELECT (SELECT id FROM highest_ids WHERE kind = 'player'), "
                              "(SELECT id FROM highest_ids WHERE kind = 'match'), "
                              "(SELECT id FROM highest_ids WHERE kind = 'table')");
        row.executeStep();
        return HighestIds{.player = read_number(row.getColumn(0)),
                          .match = read_number(row.getColumn(1)),
                          .table = static_cast<std::uint32_t>(row.getColumn(2).getInt64())};
    });
}

StoreResult<std::optional<PlayerId>> SqliteStore::player_named(const std::string& name) {
    return read([&] {
        SQLite::Statement row(database_,
                              "SELECT id FROM players WHERE name = ? ORDER BY id DESC LIMIT 1");
        row.bind(1, name);
        if (!row.executeStep()) return std::optional<PlayerId>();
        return std::optional(PlayerId{read_number(row.getColumn(0))});
    });
}

StoreResult<std::vector<StoredResult>> SqliteStore::history(const HistoryQuery& query) {
    return read([&] { return results_.history(query, age_.now_s()); });
}

StoreResult<bool> SqliteStore::may_see(MatchId match, PlayerId asker) {
    return read([&] { return results_.may_see(match, asker, age_.now_s()); });
}

StoreResult<Standing> SqliteStore::standing(PlayerId player, PlayerId asker) {
    return read([&] { return results_.standing(player, asker, age_.now_s()); });
}

StoreResult<Swept> SqliteStore::sweep(const Retention& retention) {
    return guarded(file_, [&]() -> StoreResult<Swept> {
        SQLite::Transaction transaction(database_, SQLite::TransactionBehavior::IMMEDIATE);
        age_.keep();
        const std::int64_t age_s = age_.now_s();
        const Swept swept = retention.guests ? forget_guests(database_, retention, age_s)
                                             : sweep_journals(database_, retention, age_s);
        if (auto error = gone()) return *std::move(error);
        transaction.commit();
        give_pages_back(database_);
        return swept;
    });
}

/// Durable means: in the log, and the log on the disk, before commit() returns.
StoreResult<base::Done> set_up(SQLite::Database& database, const std::filesystem::path& file,
                               const SqliteOptions& options) {
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
    database.exec(fmt::format("PRAGMA journal_size_limit = {}", kLogKept_bytes));
    if (options.most_pages) {
        database.exec(fmt::format("PRAGMA max_page_count = {}", *options.most_pages));
    }
    return base::Done{};
}

}  // namespace

StoreResult<std::unique_ptr<MatchStore>> open_sqlite_store(const std::filesystem::path& file,
                                                           const SqliteOptions& options) {
    using Opened = StoreResult<std::unique_ptr<MatchStore>>;
    return guarded(file, [&]() -> Opened {
        SQLite::Database database(file.string(), SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE,
                                  static_cast<int>(options.busy_timeout.count()));
        auto migrated = migrate(database, file);
        if (!migrated) return std::move(migrated).error();
        auto set = set_up(database, file, options);
        if (!set) return std::move(set).error();
        SqliteAge(database, options.clock).begin();  // From here the log stands beside the file.
        return Opened(std::make_unique<SqliteStore>(std::move(database), file, options.clock));
    });
}

StoreResult<std::unique_ptr<MatchStore>> open_sqlite_reader(const std::filesystem::path& file,
                                                            const SqliteOptions& options) {
    using Opened = StoreResult<std::unique_ptr<MatchStore>>;
    return guarded(file, [&]() -> Opened {
        SQLite::Database database(file.string(), SQLite::OPEN_READONLY,
                                  static_cast<int>(options.busy_timeout.count()));
        auto checked = check_version(database, file);
        if (!checked) return std::move(checked).error();
        return Opened(std::make_unique<SqliteStore>(std::move(database), file, options.clock));
    });
}

}  // namespace billiards::server
