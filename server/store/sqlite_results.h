// Takes an open SQLite database; keeps in it how matches ended, and what each made of its players'
// standing.
#pragma once

#include "server/store/match_store.h"

#include <SQLiteCpp/Database.h>
#include <SQLiteCpp/Statement.h>
#include <cstdint>
#include <string>
#include <vector>

namespace billiards::server {

/// A match that ends, and when: by the store's age, and by the calendar for being shown.
struct Ended {
    MatchId match;
    model::PerSeat<PlayerId> players;
    MatchResult result;
    std::int64_t age_s = 0;
    std::int64_t calendar_s = 0;
};

/// The statements that a page of history is read with: whoever holds them against SQLite's plans
/// wants them all.
std::vector<std::string> history_statements();

/// Everything here throws SQLite::Exception. What others see of a player is a chain of its own:
/// it leaves private matches out, and none of its links is shown before those that it rests on.
class SqliteResults {
  public:
    explicit SqliteResults(SQLite::Database& database) : database_(database) {}

    void add(const Ended& ended);

    // `age_s` is that of the store, now.
    std::vector<StoredResult> history(const HistoryQuery& query, std::int64_t age_s);
    bool may_see(MatchId match, PlayerId asker, std::int64_t age_s);
    Standing standing(PlayerId player, PlayerId asker, std::int64_t age_s);

  private:
    struct Score {
        std::uint32_t games = 0;
        std::uint32_t wins = 0;
        std::uint32_t draws = 0;
        Rating rating{};
        std::int64_t rated_s = 0;  ///< The store's age at the last rated game.
    };
    /// After a match, as the player sees it and as others do, from an age on.
    struct Link {
        Score own;
        Score shown;
        std::int64_t shown_from_s = 0;
    };

    static Score after(const Score& score, const Score& opponent, const Ended& ended,
                       model::Seat seat);
    static Link after(const Link& link, const Link& opponent, const Ended& ended, model::Seat seat);
    static Link read_link(SQLite::Statement& row);
    Link newest_link(PlayerId player, std::int64_t shown_by_s);
    void save_result(const Ended& ended);
    void save_link(const Ended& ended, model::Seat seat, const Link& link);

    SQLite::Database& database_;
    SQLite::Statement save_result_{
        database_, "INSERT INTO results VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?)"};
    SQLite::Statement save_link_{
        database_,
        "INSERT INTO standings VALUES (NULL, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?)"};
    SQLite::Statement newest_link_{
        database_,
        "SELECT games, wins, draws, rating, deviation, rated_s, shown_games, shown_wins, "
        "shown_draws, shown_rating, shown_deviation, shown_rated_s, shown_from_s FROM standings "
        "WHERE player = ? AND shown_from_s <= ? ORDER BY id DESC LIMIT 1"};
};

}  // namespace billiards::server
