// Takes what happens around a match; gives sentences.
#include "client/app/announce.h"

#include "client/app/narrate.h"

#include <algorithm>
#include <fmt/format.h>
#include <string_view>

namespace billiards::client {

namespace {

namespace server = protocol::server;

constexpr std::int64_t kSecond_us = 1'000'000;
constexpr std::int64_t kHour_s = 3600;

void append(std::string& text, std::string_view clause) {
    if (clause.empty()) return;
    if (!text.empty()) text += "; ";
    text += clause;
}

/// Of one seat: at most one thing, the one that matters most.
std::string tell(const server::SeatView& was, const server::SeatView& is) {
    if (was.taken && (!is.taken || was.name != is.name)) {
        return is.taken ? fmt::format("{} has left; {} sits down", was.name, is.name)
                        : was.name + " has left";
    }
    if (!is.taken) return "";
    if (!was.taken) return is.name + " sits down";
    if (was.connected && !is.connected) return is.name + " is away";
    if (!was.connected && is.connected) return is.name + " is back";
    if (!was.ready && is.ready) return is.name + " is ready";
    return "";
}

std::string_view who_may_come(const server::TableRow& row) {
    if (!row.is_private) return "open to everybody";
    return row.has_passcode ? "only for invited people and the passcode"
                            : "only for invited people";
}

/// Rounded up, so that it never says less than there is.
std::int64_t seconds_until(std::int64_t then_us, std::int64_t now_us) {
    return std::max<std::int64_t>(0, (then_us - now_us + kSecond_us - 1) / kSecond_us);
}

std::string how_long(std::int64_t seconds) {
    if (seconds >= kHour_s) return fmt::format("{} h", (seconds + kHour_s / 2) / kHour_s);
    return fmt::format("{} min", std::max<std::int64_t>(1, seconds / 60));
}

}  // namespace

/// Whoever has both seats comes and goes once.
std::string tell(const TableView& before, const server::SeatChanged& changed) {
    std::string text;
    std::string said;
    for (const model::Seat seat : model::kSeats) {
        std::string clause = tell(before.row.seats[seat], changed.seats[seat]);
        if (clause != said) append(text, clause);
        said = std::move(clause);
    }
    return text;
}

std::string tell(const TableView& before, const server::TableChanged& changed) {
    std::string text;
    if (before.row.settings != changed.row.settings) text = words(changed.row.settings);
    if (before.row.is_private != changed.row.is_private ||
        before.row.has_passcode != changed.row.has_passcode) {
        append(text, who_may_come(changed.row));
    }
    if (before.row.owner != changed.row.owner && !changed.row.owner.empty()) {
        append(text, changed.row.owner + " owns it now");
    }
    return text.empty() ? "the table is as it was" : "the table is changed: " + text;
}

std::string tell(const ChatLine& line) {
    return fmt::format("{}: {}", line.name, line.text);
}

std::string tell(const server::Notice& notice) {
    switch (notice.code) {
        case server::NoticeCode::ShuttingDown:
            return "the server is going down; matches go on when it is back";
        case server::NoticeCode::TableClosed:
            return "the table is closed: nobody had been there for too long";
        case server::NoticeCode::ReplacedByNewConnection:
            return "you have come back on another connection, so this one is closed";
        case server::NoticeCode::Kicked:
            return "the owner of the table has sent you away";
    }
    return notice.detail;
}

std::string tell(const server::InviteMade& invite, std::int64_t server_now_us) {
    const std::string_view what = invite.is_for_playing
                                      ? "this invite lets one person play"
                                      : "this invite lets everybody who has it watch";
    const std::int64_t left_s = seconds_until(invite.expires_us, server_now_us);
    return fmt::format("{}; it is good for {}", what, how_long(left_s));
}

std::string tell(const server::HistoryRow& played) {
    const auto& [first, second] = played.names.values;
    const std::string game = words(played.game);
    const std::string score = fmt::format("{}-{}", played.racks_won[model::Seat::First],
                                          played.racks_won[model::Seat::Second]);
    if (played.ending == server::Ending::Abandoned) {
        return fmt::format("{}: {} against {} was abandoned at {}", game, first, second, score);
    }
    if (!played.winner) return fmt::format("{}: {} drew with {} {}", game, first, second, score);
    const model::Seat loser = model::opponent_of(*played.winner);
    return fmt::format("{}: {} beat {} {}-{}", game, played.names[*played.winner],
                       played.names[loser], played.racks_won[*played.winner],
                       played.racks_won[loser]);
}

std::string tell(const server::PlayerRecord& record) {
    std::string text =
        fmt::format("{}: {} of {} matches won", record.name, record.wins, record.games);
    if (record.draws > 0) text += fmt::format(", {} drawn", record.draws);
    return text +
           fmt::format("; rating {:.0f} (+/- {:.0f})", record.rating, 2.0 * record.deviation);
}

std::string absence_of(const TableView& table, model::Seat seat, std::int64_t server_now_us) {
    const server::SeatView& view = table.row.seats[seat];
    if (!view.taken || view.connected || !view.claimable_us) return "";
    const std::string away = short_name(table, seat) + " is away: you may claim the match";
    const std::int64_t left_s = seconds_until(*view.claimable_us, server_now_us);
    return left_s > 0 ? fmt::format("{} in {} s", away, left_s) : away + ", or wait";
}

std::string words(rules::Game game) {
    switch (game) {
        case rules::Game::EightBall:
            return "8-ball";
        case rules::Game::NineBall:
            return "9-ball";
        case rules::Game::TenBall:
            return "10-ball";
        case rules::Game::StraightPool:
            return "straight pool";
        case rules::Game::Practice:
            return "practice";
    }
    return "";
}

std::string words(const match::Settings& settings) {
    std::string text = words(settings.game);
    if (settings.game == rules::Game::Practice) return text;
    if (settings.game == rules::Game::StraightPool) {
        text += fmt::format(", {} points", settings.options.target_points);
    } else {
        text += fmt::format(", race to {}", settings.race_to);
    }
    if (settings.shot_clock_s > 0.0)
        return text + fmt::format(", {:g} s a shot", settings.shot_clock_s);
    return text + ", no clock";
}

}  // namespace billiards::client
