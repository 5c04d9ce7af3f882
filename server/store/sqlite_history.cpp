// Takes an open SQLite database; gives a page of the matches in it that have ended, from indices
// alone.
#include "server/store/sqlite_results.h"
#include "server/store/sqlite_row.h"

#include <fmt/format.h>
#include <functional>
#include <limits>
#include <set>
#include <string>

namespace billiards::server {

using model::Seat;

namespace {

/// Match numbers, the newest first. Each of the sources that make a page is read from an index of
/// its own, and no further than a page.
using Page = std::set<std::int64_t, std::greater<>>;

constexpr const char* kOfEverybody =
    "SELECT match_id FROM results WHERE is_private = 0 AND shown_from_s <= :age_s";
constexpr const char* kOwn = "SELECT match_id FROM standings WHERE player = :asker";
constexpr const char* kOfPlayer =
    "SELECT match_id FROM standings JOIN results USING (match_id) WHERE player = :player AND "
    "standings.is_private = 0 AND results.shown_from_s <= :age_s";
constexpr const char* kBetween =
    "SELECT match_id FROM standings WHERE player = :player AND opponent = :asker";

std::string page_of(const char* source) {
    return fmt::format("{} AND match_id < :before ORDER BY match_id DESC LIMIT :most", source);
}

std::vector<const char*> sources_of(const HistoryQuery& query) {
    if (!query.player) return {kOfEverybody, kOwn};
    if (*query.player == query.asker) return {kOwn};
    return {kOfPlayer, kBetween};
}

/// A source names only what it needs.
void bind_where_asked(SQLite::Statement& statement, const char* name, std::int64_t value) {
    if (statement.getIndex(name) != 0) statement.bind(name, value);
}

void read_source(SQLite::Database& database, const char* source, const HistoryQuery& query,
                 std::int64_t age_s, Page& page) {
    SQLite::Statement rows(database, page_of(source));
    bind_where_asked(rows, ":age_s", age_s);
    bind_where_asked(rows, ":asker", stored(query.asker.value));
    bind_where_asked(rows, ":player", stored(query.player.value_or(PlayerId{}).value));
    rows.bind(":before",
              query.before == 0 ? std::numeric_limits<std::int64_t>::max() : stored(query.before));
    rows.bind(":most", static_cast<std::int64_t>(query.at_most));
    while (rows.executeStep()) page.insert(rows.getColumn(0).getInt64());
}

std::string name_or_unknown(const SQLite::Column& column) {
    return column.isNull() ? "?" : column.getString();
}

StoredResult read_result(SQLite::Statement& row) {
    StoredResult stored;
    stored.match.value = read_number(row.getColumn(0));
    stored.ended_s = row.getColumn(1).getInt64();
    stored.players = {{{{read_number(row.getColumn(2))}, {read_number(row.getColumn(3))}}}};
    stored.names = {{{name_or_unknown(row.getColumn(4)), name_or_unknown(row.getColumn(5))}}};
    MatchResult& result = stored.result;
    result.game = static_cast<rules::Game>(row.getColumn(6).getInt());
    result.ending = static_cast<protocol::server::Ending>(row.getColumn(7).getInt());
    if (!row.isColumnNull(8)) result.winner = static_cast<Seat>(row.getColumn(8).getInt());
    result.racks_won = {{{row.getColumn(9).getInt(), row.getColumn(10).getInt()}}};
    result.shots = static_cast<std::uint32_t>(row.getColumn(11).getInt64());
    result.is_private = row.getColumn(12).getInt() != 0;
    return stored;
}

}  // namespace

std::vector<std::string> history_statements() {
    return {page_of(kOfEverybody), page_of(kOwn), page_of(kOfPlayer), page_of(kBetween)};
}

std::vector<StoredResult> SqliteResults::history(const HistoryQuery& query, std::int64_t age_s) {
    Page page;
    for (const char* source : sources_of(query)) {
        read_source(database_, source, query, age_s, page);
    }
    SQLite::Statement row(
        database_,
        "SELECT match_id, ended_s, first_player, second_player, first.name, second.name, game, "
        "ending, winner, first_racks, second_racks, shots, is_private FROM results "
        "LEFT JOIN players first ON first.id = first_player "
        "LEFT JOIN players second ON second.id = second_player WHERE match_id = ?");
    std::vector<StoredResult> results;
    for (const std::int64_t match : page) {
        if (results.size() == query.at_most) break;
        const Use use(row);
        use->bind(1, match);
        if (use->executeStep()) results.push_back(read_result(*use));
    }
    return results;
}

bool SqliteResults::may_see(MatchId match, PlayerId asker, std::int64_t age_s) {
    SQLite::Statement row(database_,
                          "SELECT 1 FROM results WHERE match_id = :match AND (first_player = "
                          ":asker OR second_player = :asker OR (is_private = 0 AND shown_from_s "
                          "<= :age_s))");
    row.bind(":match", stored(match.value));
    row.bind(":asker", stored(asker.value));
    row.bind(":age_s", age_s);
    return row.executeStep();
}

}  // namespace billiards::server
