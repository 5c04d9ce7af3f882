// Takes rulings and the table before them; gives sentences, clause by clause.
#include "client/app/narrate.h"

#include "common/rules/facts.h"

#include <fmt/format.h>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace billiards::client {

namespace {

namespace server = protocol::server;

/// "3", "3 and 11", "3, 8 and 11".
std::string listed(const std::vector<std::string>& items, std::string_view last = " and ") {
    std::string text;
    for (std::size_t i = 0; i < items.size(); ++i) {
        if (i > 0) text += i + 1 == items.size() ? last : std::string_view(", ");
        text += items[i];
    }
    return text;
}

std::string base_name(const std::string& name) {
    return name.substr(0, name.rfind('#'));
}

std::string rack_and_shot(const TableView& before, int shots_played, std::string_view when) {
    return fmt::format("rack {}, {} {}", before.match ? before.match->rack_number : 1, when,
                       shots_played);
}

std::string said(const TableView& before, const model::Call& call) {
    struct Words {
        bool is_break;
        std::string operator()(const model::NoCall&) const { return is_break ? "breaks" : "plays"; }
        std::string operator()(const model::CalledBall& called) const {
            return fmt::format("called {} in pocket {}", called.ball.number, called.pocket.number);
        }
        std::string operator()(const model::Safety&) const { return "called a safety"; }
        std::string operator()(const model::PushOut&) const { return "called a push-out"; }
    };
    const bool is_break = before.match && before.match->rack.phase == rules::Phase::Break;
    return std::visit(Words{is_break}, call);
}

std::string what_fell(const rules::Facts& facts) {
    std::vector<std::string> balls;
    for (const rules::PocketedBall& pocketed : facts.pocketed) {
        balls.push_back(std::to_string(pocketed.ball.number));
    }
    std::string text = balls.empty() ? "nothing pocketed" : "pocketed " + listed(balls);
    std::vector<std::string> off_table;
    facts.off_table.for_each(
        [&](model::BallId ball) { off_table.push_back(std::to_string(ball.number)); });
    if (!off_table.empty()) text += ", " + listed(off_table) + " off the table";
    return text;
}

/// What the reason adds to what fell and to the fouls; empty where they say it all.
std::string_view remark(rules::Reason reason) {
    using rules::Reason;
    switch (reason) {
        case Reason::LegalPot:
        case Reason::BreakPot:
        case Reason::LegalBreak:
        case Reason::NothingPotted:
        case Reason::Safety:
        case Reason::Foul:
        case Reason::IllegalBreak:
        case Reason::BreakFoul:
        case Reason::EightOnBreak:
        case Reason::EightOnFoulBreak:
        case Reason::EightWon:
        case Reason::EightOffTable:
        case Reason::ClockRanOut:
        case Reason::NineWon:
        case Reason::TenWon:
        case Reason::UncalledPot:
        case Reason::BreakingFoul:
        case Reason::TargetReached:
        case Reason::Practice:
            return "";
        case Reason::ThreeFouls:
            return "the third foul in a row";
        case Reason::PushOut:
            return "a push-out";
        case Reason::TenEarly:
            return "the 10 too early";
        case Reason::NotCalled:
            return "not as called";
        case Reason::EightWithFoul:
            return "the 8 on a foul";
        case Reason::EightEarly:
            return "the 8 too early";
        case Reason::EightUncalled:
            return "the 8 not as called";
    }
    return "";
}

std::string fouls_of(const rules::Verdict& verdict) {
    std::vector<std::string> fouls;
    for (const rules::Foul foul : verdict.fouls) fouls.push_back(words(foul));
    return fouls.empty() ? "" : "foul: " + listed(fouls);
}

std::string in_hand(rules::Zone zone) {
    switch (zone) {
        case rules::Zone::None:
            return "";
        case rules::Zone::Anywhere:
            return " with ball in hand";
        case rules::Zone::BehindHeadString:
            return " with ball in hand behind the head string";
    }
    return "";
}

/// At straight pool, where the shot changed it: the points of both.
std::string score_of(const TableView& before, const rules::Verdict& verdict) {
    if (!before.match || verdict.score_change == model::PerSeat<int>{}) return "";
    const auto points = [&](model::Seat seat) {
        return before.match->rack.scores[seat] + verdict.score_change[seat];
    };
    return fmt::format("points {} to {}", points(model::Seat::First), points(model::Seat::Second));
}

/// Who is next, and with what.
std::string what_follows(const TableView& before, const server::ShotPlayed& shot) {
    const rules::Verdict& verdict = shot.verdict;
    if (verdict.winner) return short_name(before, *verdict.winner) + " wins the rack";
    if (verdict.choices.empty() && shot.after.rack.phase == rules::Phase::Break) {
        // A third foul of straight pool, or the last turn of a stalemate that was claimed.
        const bool third_foul = verdict.rerack == rules::Rerack::Fifteen;
        return fmt::format("{}{} to break", third_foul ? "" : "the rack is played again; ",
                           short_name(before, shot.after.to_act));
    }
    const std::string next = short_name(before, verdict.next_player);
    if (!verdict.choices.empty()) {
        std::vector<std::string> choices;
        for (const rules::Choice choice : verdict.choices) choices.push_back(words(choice));
        return next + " may " + listed(choices, " or ");
    }
    if (verdict.turn_continues) return next + " continues" + in_hand(verdict.in_hand);
    return next + " to play" + in_hand(verdict.in_hand);
}

std::string groups_set(const TableView& before, const match::MatchState& after,
                       const rules::Verdict& verdict) {
    const bool had_groups = before.match && before.match->rack.groups;
    if (had_groups || !verdict.groups || verdict.winner) return "";
    const model::Seat shooter = before.match ? before.match->rack.shooter : after.rack.shooter;
    return short_name(before, shooter) + " has " + words((*verdict.groups)[shooter]);
}

bool is_draw(const std::optional<match::MatchState::StandingOffer>& offer) {
    return offer && offer->kind == match::OfferKind::Draw;
}

std::string_view offered(const match::MatchState& after) {
    return is_draw(after.offer) ? "offers a draw" : "offers to play the rack again";
}

std::string_view accepted(const match::MatchState& after) {
    const bool ends = after.stage == match::Stage::Over;
    return ends ? "agrees to the draw" : "agrees to play the rack again";
}

std::string_view rejected(const TableView& before) {
    if (!before.match) return "declines the offer";
    return is_draw(before.match->offer) ? "declines the draw" : "declines to play the rack again";
}

std::string_view gave_up(const match::MatchState& after) {
    const bool is_practice = after.settings.game == rules::Game::Practice;
    return is_practice ? "ends the practice" : "concedes";
}

/// What a step without a shot was: the rest of "Ada#12ab ...".
std::string what_was_done(const TableView& before, const server::MatchMoved& moved) {
    switch (moved.move) {
        case server::Move::Choice:
            return "chose to " + (moved.choice ? words(*moved.choice) : "go on");
        case server::Move::Timeout:
            return "ran out of time";
        case server::Move::Concession:
            return std::string(gave_up(moved.after));
        case server::Move::Forfeit:
            return fmt::format("stayed away for too long; {} claims the match",
                               short_name(before, model::opponent_of(moved.seat)));
        case server::Move::Extension:
            return "takes an extension";
        case server::Move::Offer:
            return std::string(offered(moved.after));
        case server::Move::Acceptance:
            return std::string(accepted(moved.after));
        case server::Move::Rejection:
            return std::string(rejected(before));
        case server::Move::StalemateClaim:
            return "claims a stalemate";
        case server::Move::Spotting:
            return "has the nearest ball spotted";
        case server::Move::Placing:
            return "places a ball";
        case server::Move::Undoing:
            return "takes the last change back";
        case server::Move::Repeating:
            return "sets the balls up as before the last shot";
        case server::Move::Reracking:
            return "racks the balls again";
    }
    return "";
}

/// "a; b; c" of those that are not empty.
std::string joined(const std::vector<std::string>& clauses) {
    std::string text;
    for (const std::string& clause : clauses) {
        if (clause.empty()) continue;
        if (!text.empty()) text += "; ";
        text += clause;
    }
    return text;
}

/// What stands behind "... wins the match 2-1".
std::string how_it_ended(const TableView& before, server::Ending ending, model::Seat loser) {
    switch (ending) {
        case server::Ending::Conceded:
            return fmt::format(": {} conceded", short_name(before, loser));
        case server::Ending::Claimed:
            return fmt::format(": {} stayed away", short_name(before, loser));
        case server::Ending::Played:
        case server::Ending::Abandoned:
            return "";
    }
    return "";
}

}  // namespace

std::string narrate(const TableView& before, const server::ShotPlayed& shot) {
    return rack_and_shot(before, shot.after.shots_played, "shot") + ": " + tell(before, shot);
}

std::string narrate(const TableView& before, const server::MatchMoved& moved) {
    return rack_and_shot(before, moved.after.shots_played, "after shot") + ": " +
           tell(before, moved);
}

std::string tell(const TableView& before, const server::ShotPlayed& shot) {
    std::string happened = what_fell(rules::facts_of(shot.record.events));
    const std::string_view note = remark(shot.verdict.reason);
    if (!note.empty()) happened += fmt::format(", {}", note);
    return fmt::format(
        "{} {}: {}", full_name(before, shot.seat), said(before, shot.call),
        joined({happened, fouls_of(shot.verdict), groups_set(before, shot.after, shot.verdict),
                score_of(before, shot.verdict), what_follows(before, shot)}));
}

std::string tell(const TableView& before, const server::MatchMoved& moved) {
    const std::string what =
        fmt::format("{} {}", full_name(before, moved.seat), what_was_done(before, moved));
    if (moved.after.stage == match::Stage::Over) return what;
    const std::string points = moved.verdict ? score_of(before, *moved.verdict) : "";
    if (moved.move == server::Move::Offer) {
        return fmt::format("{}; {} may agree or decline", what,
                           short_name(before, model::opponent_of(moved.seat)));
    }
    const std::string next = short_name(before, moved.after.to_act);
    if (moved.after.stage == match::Stage::Choosing)
        return joined({what, points, next + " to choose"});
    const bool is_break = moved.after.rack.phase == rules::Phase::Break;
    const std::string follows = fmt::format("{} to {}{}", next, is_break ? "break" : "play",
                                            is_break ? "" : in_hand(moved.after.rack.in_hand));
    return joined({what, points, follows});
}

std::string narrate(const TableView& before, const server::MatchOver& over) {
    const std::string score = fmt::format("{}-{}", over.racks_won[model::Seat::First],
                                          over.racks_won[model::Seat::Second]);
    if (over.ending == server::Ending::Abandoned) {
        return fmt::format("the match is abandoned at {}: nobody came back to it", score);
    }
    if (!over.winner) {
        if (before.row.settings.game == rules::Game::Practice) return "practice is over";
        return "the match is drawn " + score;
    }
    const model::Seat loser = model::opponent_of(*over.winner);
    return fmt::format("{} wins the match {}-{}{}", full_name(before, *over.winner),
                       over.racks_won[*over.winner], over.racks_won[loser],
                       how_it_ended(before, over.ending, loser));
}

std::string full_name(const TableView& table, model::Seat seat) {
    const std::string& name = table.row.seats[seat].name;
    const bool has_both_seats = name == table.row.seats[model::opponent_of(seat)].name;
    if (!has_both_seats) return name;
    return seat == model::Seat::First ? "Player 1" : "Player 2";
}

std::string short_name(const TableView& table, model::Seat seat) {
    const std::string name = full_name(table, seat);
    const std::string other = full_name(table, model::opponent_of(seat));
    return base_name(name) == base_name(other) ? name : base_name(name);
}

}  // namespace billiards::client
