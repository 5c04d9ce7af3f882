// Takes an open SQLite database; keeps in it how matches ended, and what each made of its players'
// standing.
#include "server/store/sqlite_results.h"

#include "server/store/sqlite_row.h"

#include <algorithm>
#include <array>
#include <limits>

namespace billiards::server {

using model::Seat;

namespace {

constexpr double kDay_s = 24.0 * 60.0 * 60.0;
constexpr std::int64_t kAnyAge_s = std::numeric_limits<std::int64_t>::max();

bool is_rated(const Ended& ended) {
    return ended.players[Seat::First] != ended.players[Seat::Second] &&
           ended.result.game != rules::Game::Practice &&
           ended.result.ending != protocol::server::Ending::Abandoned;
}

/// Ages are whole seconds: one more for what they leave out, and one for the time until the end
/// was durable, so that nothing is shown before those who are told it so much later know.
std::int64_t shown_from_s(const Ended& ended) {
    constexpr auto kMargin = std::chrono::seconds(2);
    const base::Duration hidden_for = ended.result.hidden_for;
    if (hidden_for == base::Duration::zero()) return ended.age_s;
    return ended.age_s + (std::chrono::ceil<std::chrono::seconds>(hidden_for) + kMargin).count();
}

double days_between(std::int64_t from_s, std::int64_t to_s) {
    return static_cast<double>(to_s - from_s) / kDay_s;
}

std::uint32_t read_count(const SQLite::Column& column) {
    return static_cast<std::uint32_t>(column.getInt64());
}

}  // namespace

SqliteResults::Score SqliteResults::after(const Score& score, const Score& opponent,
                                          const Ended& ended, Seat seat) {
    const auto& winner = ended.result.winner;
    const auto fresh = [&](const Score& one) {
        return rested(one.rating, days_between(one.rated_s, ended.age_s));
    };
    Score next = score;
    ++next.games;
    if (winner == seat) ++next.wins;
    if (!winner) ++next.draws;
    const RatedGame game{.opponent = fresh(opponent),
                         .score = !winner ? 0.5 : (*winner == seat ? 1.0 : 0.0)};
    next.rating = rated(fresh(score), std::array{game});
    next.rated_s = ended.age_s;
    return next;
}

SqliteResults::Link SqliteResults::after(const Link& link, const Link& opponent, const Ended& ended,
                                         Seat seat) {
    Link next = link;
    if (!is_rated(ended)) return next;
    next.own = after(link.own, opponent.own, ended, seat);
    if (ended.result.is_private) return next;
    next.shown = after(link.shown, opponent.shown, ended, seat);
    next.shown_from_s = std::max({shown_from_s(ended), link.shown_from_s, opponent.shown_from_s});
    return next;
}

void SqliteResults::add(const Ended& ended) {
    const Link first = newest_link(ended.players[Seat::First], kAnyAge_s);
    const Link second = newest_link(ended.players[Seat::Second], kAnyAge_s);
    save_result(ended);
    save_link(ended, Seat::First, after(first, second, ended, Seat::First));
    if (ended.players[Seat::First] == ended.players[Seat::Second]) return;
    save_link(ended, Seat::Second, after(second, first, ended, Seat::Second));
}

void SqliteResults::save_result(const Ended& ended) {
    const MatchResult& result = ended.result;
    const Use use(save_result_);
    use->bind(1, stored(ended.match.value));
    use->bind(2, ended.calendar_s);
    use->bind(3, shown_from_s(ended));
    use->bind(4, result.is_private ? 1 : 0);
    use->bind(5, stored(ended.players[Seat::First].value));
    use->bind(6, stored(ended.players[Seat::Second].value));
    use->bind(7, static_cast<int>(result.game));
    use->bind(8, static_cast<int>(result.ending));
    if (result.winner) {
        use->bind(9, static_cast<int>(*result.winner));
    } else {
        use->bind(9);  // NULL
    }
    use->bind(10, result.racks_won[Seat::First]);
    use->bind(11, result.racks_won[Seat::Second]);
    use->bind(12, std::int64_t{result.shots});
    use->exec();
}

void SqliteResults::save_link(const Ended& ended, Seat seat, const Link& link) {
    const Use use(save_link_);
    int column = 0;
    use->bind(++column, stored(ended.players[seat].value));
    use->bind(++column, stored(ended.match.value));
    use->bind(++column, stored(ended.players[opponent_of(seat)].value));
    use->bind(++column, ended.result.is_private ? 1 : 0);
    for (const Score* score : {&link.own, &link.shown}) {
        use->bind(++column, std::int64_t{score->games});
        use->bind(++column, std::int64_t{score->wins});
        use->bind(++column, std::int64_t{score->draws});
        use->bind(++column, score->rating.rating);
        use->bind(++column, score->rating.deviation);
        use->bind(++column, score->rated_s);
    }
    use->bind(++column, link.shown_from_s);
    use->exec();
}

SqliteResults::Link SqliteResults::read_link(SQLite::Statement& row) {
    const auto read_score = [&row](int first) {
        return Score{
            .games = read_count(row.getColumn(first)),
            .wins = read_count(row.getColumn(first + 1)),
            .draws = read_count(row.getColumn(first + 2)),
            .rating = {row.getColumn(first + 3).getDouble(), row.getColumn(first + 4).getDouble()},
            .rated_s = row.getColumn(first + 5).getInt64()};
    };
    return {
        .own = read_score(0), .shown = read_score(6), .shown_from_s = row.getColumn(12).getInt64()};
}

/// Of those that may be shown at an age; as at the beginning where there is none.
SqliteResults::Link SqliteResults::newest_link(PlayerId player, std::int64_t shown_by_s) {
    const Use use(newest_link_);
    use->bind(1, stored(player.value));
    use->bind(2, shown_by_s);
    return use->executeStep() ? read_link(*use) : Link{};
}

Standing SqliteResults::standing(PlayerId player, PlayerId asker, std::int64_t age_s) {
    const bool is_own = player == asker;
    const Link link = newest_link(player, is_own ? kAnyAge_s : age_s);
    const Score& score = is_own ? link.own : link.shown;
    return {.games = score.games,
            .wins = score.wins,
            .draws = score.draws,
            .rating = rested(score.rating, days_between(score.rated_s, age_s))};
}

}  // namespace billiards::server
