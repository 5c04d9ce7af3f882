// Takes a table and the time; gives what is to be known beside whose turn it is, in words.
#include "client/app/announce.h"
#include "client/app/narrate.h"
#include "client/play/information.h"
#include "client/play/offered.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace billiards::client {

namespace {

using model::Seat;

bool is_away(const TableView& table, Seat seat) {
    return table.row.seats[seat].taken && !table.row.seats[seat].connected;
}

/// Who is away, and when the other one may claim the match.
std::string about_absence(const Game& game, const TableView& table, base::Instant now) {
    const bool first = is_away(table, Seat::First);
    const bool second = is_away(table, Seat::Second);
    if (!first && !second) return "";
    if (first && second) return "Both players are away: the match waits for them.";
    const Seat away = first ? Seat::First : Seat::Second;
    const std::string text = short_name(table, away) + " is away";
    const auto& claimable_us = table.row.seats[away].claimable_us;
    const auto from = claimable_us ? local_time_of(game.known(), *claimable_us) : std::nullopt;
    if (!from) return text + ".";
    const auto& mine = table.my_seats;
    const bool is_mine = std::ranges::find(mine, model::opponent_of(away)) != mine.end();
    const std::string who = is_mine ? "you" : short_name(table, model::opponent_of(away));
    const int wait_s = static_cast<int>(std::ceil(base::seconds(*from - now)));
    if (wait_s > 0) return fmt::format("{}: {} may claim the match in {} s.", text, who, wait_s);
    return fmt::format("{}: {} may claim the match, or wait.", text, who);
}

std::string about_offer(const TableView& table) {
    if (!table.match || !table.match->offer) return "";
    const match::MatchState::StandingOffer& offer = *table.match->offer;
    const auto& mine = table.my_seats;
    const bool is_mine = std::ranges::find(mine, offer.by) != mine.end();
    const std::string what =
        offer.kind == match::OfferKind::Draw ? "a draw" : "to play the rack again";
    return is_mine ? fmt::format("You have offered {}.", what)
                   : fmt::format("{} offers {}.", short_name(table, offer.by), what);
}

std::string about_claim(const TableView& table) {
    if (!table.match || !table.match->claim) return "";
    const model::PerSeat<int>& turns = *table.match->claim;
    const int left = std::max(0, match::kTurnsOfClaim - turns[Seat::First]) +
                     std::max(0, match::kTurnsOfClaim - turns[Seat::Second]);
    return fmt::format(
        "A stalemate is claimed: {} more turns without a ball or a foul, and the "
        "rack is played again.",
        left);
}

std::string about_next_match(const TableView& table) {
    if (table.match && table.match->stage != match::Stage::Over) return "";
    if (has_both_seats(table)) return "";
    for (const Seat seat : model::kSeats) {
        const auto& mine = table.my_seats;
        const bool is_mine = std::ranges::find(mine, seat) != mine.end();
        if (!table.row.seats[seat].ready || is_mine) continue;
        return short_name(table, seat) +
               (is_between_the_same(table) ? " wants a rematch." : " is ready.");
    }
    return "";
}

std::string about_delay(const TableView& table) {
    const double delay_s = table.row.settings.spectator_delay_s;
    if (!table.my_seats.empty() || delay_s <= 0.0) return "";
    return fmt::format("Who watches sees this table {:.0f} s late.", delay_s);
}

}  // namespace

std::vector<std::string> notes(const Game& game, base::Instant now) {
    const TableView* table = game.presentation().table();
    if (table == nullptr || game.is_rewatching()) return {};
    std::vector<std::string> notes{about_absence(game, *table, now), about_offer(*table),
                                   about_claim(*table), about_next_match(*table),
                                   about_delay(*table)};
    std::erase(notes, "");
    return notes;
}

bool has_room(const protocol::server::TableRow& row) {
    return !row.seats[Seat::First].taken || !row.seats[Seat::Second].taken;
}

RowText text_of(const protocol::server::TableRow& row) {
    const auto name_of = [&](Seat seat) {
        return row.seats[seat].taken ? row.seats[seat].name : std::string("free seat");
    };
    const bool is_one =
        row.seats[Seat::First].taken && row.seats[Seat::First].name == row.seats[Seat::Second].name;
    const bool is_practice = row.settings.game == rules::Game::Practice;
    RowText text{.game = words(row.settings.game), .players = {}, .race = {}, .state = {}};
    if (is_one) {
        text.players = row.seats[Seat::First].name;
    } else {
        text.players =
            fmt::format("{} {} - {} {}", name_of(Seat::First), row.racks_won[Seat::First],
                        row.racks_won[Seat::Second], name_of(Seat::Second));
    }
    if (is_one && !is_practice) {
        text.players += fmt::format(", both sides, {} - {}", row.racks_won[Seat::First],
                                    row.racks_won[Seat::Second]);
    }
    if (!is_practice) text.race = fmt::format("race to {}", row.settings.race_to);
    text.state = row.playing ? "playing" : has_room(row) ? "open" : "getting ready";
    if (row.spectators > 0) text.state += fmt::format(", {} watching", row.spectators);
    return text;
}

std::string score_of(const TableView& table) {
    const bool is_of_points =
        table.match && table.match->settings.game == rules::Game::StraightPool;
    if (is_of_points) {
        const auto& points = table.match->rack.scores;
        return fmt::format("{} : {} of {}", points[Seat::First], points[Seat::Second],
                           table.match->settings.options.target_points);
    }
    const model::PerSeat<int>& racks = table.match ? table.match->racks_won : table.row.racks_won;
    return fmt::format("{} : {}", racks[Seat::First], racks[Seat::Second]);
}

}  // namespace billiards::client
