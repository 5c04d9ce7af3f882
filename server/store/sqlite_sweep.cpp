// Takes an open SQLite database; drops from it what need not be kept any longer.
#include "server/store/sqlite_sweep.h"

#include "server/store/sqlite_row.h"

#include <SQLiteCpp/Statement.h>
#include <fmt/format.h>
#include <optional>

namespace billiards::server {
namespace {

constexpr int kPagesGivenBack = 1024;

std::uint64_t pragma(SQLite::Database& database, const char* name) {
    return read_number(database.execAndGet(fmt::format("PRAGMA {}", name)));
}

std::uint64_t bytes_in_use(SQLite::Database& database) {
    return (pragma(database, "page_count") - pragma(database, "freelist_count")) *
           pragma(database, "page_size");
}

std::optional<std::int64_t> first_of(SQLite::Statement& row) {
    if (!row.executeStep()) return std::nullopt;
    return row.getColumn(0).getInt64();
}

/// The match that is being dropped, or else the next that has to be.
std::optional<std::int64_t> next_to_drop(SQLite::Database& database, const Retention& retention,
                                         std::int64_t age_s) {
    SQLite::Statement begun(database, "SELECT id FROM matches WHERE ended = 2 LIMIT 1");
    if (const auto match = first_of(begun)) return match;
    const bool is_too_large =
        retention.most_bytes != 0 && bytes_in_use(database) > retention.most_bytes;
    if (!is_too_large && retention.kept_s == 0) return std::nullopt;
    SQLite::Statement oldest(database,
                             "SELECT id FROM matches WHERE ended = 1 AND ended_age_s < ? "
                             "ORDER BY ended_age_s, id LIMIT 1");
    oldest.bind(1, is_too_large ? age_s + 1 : age_s - retention.kept_s);
    return first_of(oldest);
}

void run(SQLite::Database& database, const char* statement, std::int64_t match) {
    SQLite::Statement one(database, statement);
    one.bind(1, match);
    one.exec();
}

std::size_t drop_entries(SQLite::Database& database, std::int64_t match, std::size_t at_most) {
    SQLite::Statement drop(database,
                           "DELETE FROM entries WHERE match_id = ?1 AND seq IN (SELECT seq FROM "
                           "entries WHERE match_id = ?1 ORDER BY seq DESC LIMIT ?2)");
    drop.bind(1, match);
    drop.bind(2, static_cast<std::int64_t>(at_most));
    return static_cast<std::size_t>(drop.exec());
}

}  // namespace

Swept sweep_journals(SQLite::Database& database, const Retention& retention, std::int64_t age_s) {
    Swept swept;
    while (const auto match = next_to_drop(database, retention, age_s)) {
        run(database, "UPDATE matches SET ended = 2 WHERE id = ?", *match);
        const std::size_t room = retention.entries_at_once - swept.entries;
        swept.entries += drop_entries(database, *match, room);
        swept.is_done = swept.entries < retention.entries_at_once;
        if (!swept.is_done) break;  // Perhaps not all of this match.
        run(database, "DELETE FROM matches WHERE id = ?", *match);
        ++swept.matches;
    }
    return swept;
}

Swept forget_guests(SQLite::Database& database, const Retention& retention, std::int64_t age_s) {
    if (retention.kept_s == 0) return {};
    SQLite::Statement forget(
        database,
        "DELETE FROM players WHERE id IN (SELECT id FROM players p WHERE seen_s < ? "
        "AND NOT EXISTS (SELECT 1 FROM standings WHERE player = p.id) "
        "AND id NOT IN (SELECT first_player FROM matches) "
        "AND id NOT IN (SELECT second_player FROM matches) "
        "AND id NOT IN (SELECT owner FROM tables) "
        "AND id NOT IN (SELECT first_seat FROM tables WHERE first_seat IS NOT NULL) "
        "AND id NOT IN (SELECT second_seat FROM tables WHERE second_seat IS NOT NULL) LIMIT ?)");
    forget.bind(1, age_s - retention.kept_s);
    forget.bind(2, static_cast<std::int64_t>(retention.entries_at_once));
    const auto forgotten = static_cast<std::size_t>(forget.exec());
    return {.is_done = forgotten < retention.entries_at_once};
}

void give_pages_back(SQLite::Database& database) {
    SQLite::Statement vacuum(database,
                             fmt::format("PRAGMA incremental_vacuum({})", kPagesGivenBack));
    while (vacuum.executeStep()) {
    }
}

}  // namespace billiards::server
