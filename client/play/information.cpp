// Takes what is shown; gives it in words.
#include "client/play/information.h"

#include "client/app/narrate.h"
#include "client/play/offered.h"
#include "common/match/clock.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace billiards::client {

namespace {

std::string capitalised(std::string text) {
    if (!text.empty() && text[0] >= 'a' && text[0] <= 'z') text[0] -= 'a' - 'A';
    return text;
}

/// "Player 2: Solids", as the original says it.
std::string player_and_group(const TableView& table, model::Seat seat) {
    const match::MatchState& match = *table.match;
    std::string text = short_name(table, seat);
    if (match.rack.groups) text += ": " + capitalised(words((*match.rack.groups)[seat]));
    return text;
}

std::string to_do(const Game& game, const match::MatchState& match) {
    if (match.stage == match::Stage::Choosing) return "has to choose";
    const bool is_break = match.rack.phase == rules::Phase::Break;
    const std::string shot = is_break ? "to break" : "to shoot";
    if (match.rack.in_hand == rules::Zone::None) return shot;
    const bool is_anywhere = match.rack.in_hand == rules::Zone::Anywhere;
    std::string where = is_anywhere ? "anywhere" : "behind the head string";
    if (game.placing() && !game.placing()->is_legal()) where += " (not where it is now)";
    return shot + ", cue ball in hand " + where;
}

std::string at_the_table(const Game& game, const TableView& table) {
    if (game.presentation().rests()) return "The next rack follows.";
    if (game.presentation().rolling() != nullptr) return "The balls roll.";
    if (!table.match || table.match->stage == match::Stage::Over) {
        const bool is_seated = !table.my_seats.empty();
        const auto& seats = table.row.seats;
        if (!seats[model::Seat::First].taken || !seats[model::Seat::Second].taken) {
            return "Waiting for a second player.";
        }
        if (!is_seated) return "The players get ready.";
        if (game.has_asked_to_start()) return "Waiting until the other player is ready.";
        if (has_both_seats(table)) return "Press Start when you are ready.";
        return fmt::format("Press {} when you are ready.",
                           is_between_the_same(table) ? "Rematch" : "Start");
    }
    const match::MatchState& match = *table.match;
    if (match.settings.game == rules::Game::Practice) return "Practice: play any ball anywhere.";
    return fmt::format("{} {}.", player_and_group(table, match.to_act), to_do(game, match));
}

}  // namespace

std::string what_follows(const Game& game) {
    if (game.is_coming_back())
        return fmt::format("Connection lost ({}). Trying again.", game.lost());
    if (!game.lost().empty()) return fmt::format("No connection: {}.", game.lost());
    if (!game.refusal().empty()) return capitalised(game.refusal()) + ".";
    const TableView* table = game.presentation().table();
    return table != nullptr ? at_the_table(game, *table) : "";
}

std::vector<std::string> information(const Game& game) {
    const auto& lines = game.presentation().lines();
    std::vector<std::string> all(lines.begin(), lines.end());
    if (std::string next = what_follows(game); !next.empty()) all.push_back(std::move(next));
    return all;
}

bool is_low(int seconds_left) {
    return seconds_left <= match::kWarning_s;
}

std::optional<int> seconds_left(const Game& game, base::Instant now) {
    const TableView* table = game.presentation().table();
    if (table == nullptr || !table->turn.deadline_us || game.is_rewatching()) return std::nullopt;
    const auto deadline = local_time_of(game.known(), *table->turn.deadline_us);
    if (!deadline || game.presentation().rolling() != nullptr) return std::nullopt;
    return std::max(0, static_cast<int>(std::ceil(base::seconds(*deadline - now))));
}

}  // namespace billiards::client
