// Takes an open SQLite database; keeps the matches in it, each with its journal.
#include "server/store/sqlite_matches.h"

#include "common/protocol/limits.h"
#include "common/protocol/packing.h"
#include "server/store/sqlite_row.h"

#include <fmt/format.h>
#include <utility>

namespace billiards::server {
namespace {

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

}  // namespace

void SqliteMatches::save(const StoredMatch& match, std::int64_t started_s) {
    const Use use(save_);
    use->bind(1, stored(match.match.value));
    use->bind(2, stored(match.table.value));
    use->bindNoCopy(3, match.table_name);
    use->bind(4, stored(match.players[model::Seat::First].value));
    use->bind(5, stored(match.players[model::Seat::Second].value));
    bind_bytes(*use, 6, match.settings);
    use->bindNoCopy(7, match.engine);
    use->bind(8, started_s);
    use->exec();
}

/// Large columns are packed here, where the thread is about to wait for the disk anyway.
void SqliteMatches::append(MatchId match, const StoredEntry& stored_entry) {
    const protocol::EncodedEntry& entry = stored_entry.entry;
    const protocol::Bytes final_layout = protocol::packed(entry.final_layout);
    const protocol::Bytes record = protocol::packed(entry.record);
    const Use use(append_);
    use->bind(1, stored(match.value));
    use->bind(2, stored(stored_entry.sequence));
    bind_bytes(*use, 3, entry.command);
    bind_bytes(*use, 4, entry.verdict);
    bind_bytes(*use, 5, final_layout);
    bind_bytes(*use, 6, record);
    use->exec();
}

std::optional<model::PerSeat<PlayerId>> SqliteMatches::players_of_live(MatchId match) {
    SQLite::Statement live(
        database_, "SELECT first_player, second_player FROM matches WHERE id = ? AND ended = 0");
    live.bind(1, stored(match.value));
    if (!live.executeStep()) return std::nullopt;
    model::PerSeat<PlayerId> players;
    players[model::Seat::First].value = read_number(live.getColumn(0));
    players[model::Seat::Second].value = read_number(live.getColumn(1));
    return players;
}

void SqliteMatches::finish(MatchId match, std::int64_t age_s) {
    const Use use(finish_);
    use->bind(1, age_s);
    use->bind(2, stored(match.value));
    use->exec();
}

void SqliteMatches::remove(MatchId match) {
    for (const char* statement :
         {"DELETE FROM entries WHERE match_id = ?", "DELETE FROM matches WHERE id = ?"}) {
        SQLite::Statement forget(database_, statement);
        forget.bind(1, stored(match.value));
        forget.exec();
    }
}

std::vector<StoredMatch> SqliteMatches::live() {
    std::vector<StoredMatch> matches;
    SQLite::Statement rows(
        database_, fmt::format("SELECT {} FROM matches WHERE ended = 0 ORDER BY id", kMatch));
    while (rows.executeStep()) matches.push_back(read_match(rows));
    return matches;
}

std::vector<EndedMatch> SqliteMatches::ended() {
    std::vector<EndedMatch> matches;
    SQLite::Statement rows(
        database_,
        fmt::format("SELECT {}, started_s FROM matches WHERE ended = 1 ORDER BY id", kMatch));
    while (rows.executeStep()) {
        matches.push_back({read_match(rows), rows.getColumn("started_s").getInt64()});
    }
    return matches;
}

std::optional<KnownMatch> SqliteMatches::match_where(const char* condition, std::uint64_t id) {
    SQLite::Statement row(database_,
                          fmt::format("SELECT {}, ended, (SELECT ifnull(max(seq), 0) FROM "
                                      "entries WHERE match_id = id) AS entries "
                                      "FROM matches WHERE {} AND ended < 2 "
                                      "ORDER BY id DESC LIMIT 1",
                                      kMatch, condition));
    row.bind(1, stored(id));
    if (!row.executeStep()) return std::nullopt;
    const bool is_over = row.getColumn("ended").getInt() != 0;
    const std::uint64_t entries = read_number(row.getColumn("entries"));
    return KnownMatch{read_match(row), is_over, entries};
}

std::optional<KnownMatch> SqliteMatches::last_at(protocol::TableId table) {
    return match_where("table_id = ?", table.value);
}

std::optional<KnownMatch> SqliteMatches::find(MatchId match) {
    return match_where("id = ?", match.value);
}

StoreResult<base::Done> SqliteMatches::journal(MatchId match, const EntryVisitor& visit,
                                               std::uint64_t records_from) {
    SQLite::Statement rows(database_,
                           "SELECT seq, command, verdict, final_layout, "
                           "iif(seq < ?2, x'', record) FROM entries "
                           "WHERE match_id = ?1 ORDER BY seq");
    rows.bind(1, stored(match.value));
    rows.bind(2, stored(records_from));
    while (rows.executeStep()) {
        auto entry = read_entry(rows);
        if (!entry) {
            return StoreError{
                StoreErrorCode::Corrupt,
                fmt::format("{}: entry {} of match {}: {}", file_.string(),
                            read_number(rows.getColumn(0)), match.value, entry.error().detail)};
        }
        if (!visit(std::move(entry).value())) break;
    }
    return base::Done{};
}

}  // namespace billiards::server
