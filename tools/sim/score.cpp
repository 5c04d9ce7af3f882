// Takes a replay; gives the match as text, shot by shot, to be read like the score of a chess game.
#include "tools/sim/score.h"

#include "client/app/narrate.h"
#include "common/protocol/moves.h"
#include "common/replay/play.h"
#include "tools/sim/words.h"

#include <ctime>
#include <fmt/chrono.h>
#include <fmt/format.h>
#include <fmt/ostream.h>
#include <ostream>
#include <string>

namespace billiards::tools {

namespace {

using model::Seat;

const char* name_of(model::TableSize size) {
    switch (size) {
        case model::TableSize::SevenFoot:
            return "7 ft table";
        case model::TableSize::EightFoot:
            return "8 ft table";
        case model::TableSize::NineFoot:
            return "9 ft table";
    }
    return "";
}

const char* name_of(match::BreakOrder order) {
    switch (order) {
        case match::BreakOrder::Alternate:
            return "alternate break";
        case match::BreakOrder::Winner:
            return "winner breaks";
        case match::BreakOrder::Loser:
            return "loser breaks";
    }
    return "";
}

/// At straight pool a rack is won by points.
std::string points_of(const match::Settings& settings) {
    if (settings.game != rules::Game::StraightPool) return "";
    return fmt::format("{} points, ", settings.options.target_points);
}

void print(const replay::Header& header, std::ostream& out) {
    const match::Settings& settings = header.settings;
    const bool is_classic = settings.physics == match::PhysicsPreset::Classic;
    fmt::print(out, "{} - {}\n", header.players[Seat::First], header.players[Seat::Second]);
    fmt::print(out, "{}, {}race to {}, {}, {}, {} physics\n", word_of(settings.game),
               points_of(settings), settings.race_to, name_of(settings.break_order),
               name_of(settings.table), is_classic ? "classic" : "realistic");
    if (!header.table.empty()) fmt::print(out, "table \"{}\", ", header.table);
    if (header.started_s != 0) {
        fmt::print(out, "{:%Y-%m-%d %H:%M} UTC, ", fmt::gmtime(std::time_t{header.started_s}));
    }
    fmt::print(out, "engine {}\n", header.engine);
}

/// Prints moment by moment, and keeps what a sentence needs: the table as a viewer sees it.
class Scorer {
  public:
    Scorer(const replay::Header& header, std::ostream& out) : out_(out) {
        table_.row.settings = header.settings;
        client::TableView named;
        for (const Seat seat : model::kSeats) named.row.seats[seat].name = header.players[seat];
        for (const Seat seat : model::kSeats) {
            table_.row.seats[seat].name = client::short_name(named, seat);
        }
    }

    void on(const replay::Moment& moment) {
        table_.match = moment.before;
        if (moment.before.rack_number != rack_) begin_rack(moment.before);
        const auto& command = moment.entry.command;
        if (const auto* take = std::get_if<match::TakeShot>(&command)) return shot(moment, *take);
        if (std::holds_alternative<match::PlaceCueBall>(command)) return;
        ending_ = protocol::ending_of(command);
        const bool is_told_at_the_end = ending_ != protocol::server::Ending::Played;
        if (!is_told_at_the_end) moved(moment);
    }

    void end(const match::MatchState& state) {
        if (state.stage != match::Stage::Over) return;
        table_.match = state;
        protocol::server::MatchOver over;
        over.winner = state.winner;
        over.racks_won = state.racks_won;
        over.ending = ending_;
        fmt::print(out_, "\n{}\n", client::narrate(table_, over));
    }

  private:
    void begin_rack(const match::MatchState& match) {
        rack_ = match.rack_number;
        fmt::print(out_, "\nrack {}, {}-{}\n", rack_, match.racks_won[Seat::First],
                   match.racks_won[Seat::Second]);
    }

    void shot(const replay::Moment& moment, const match::TakeShot& take) {
        protocol::server::ShotPlayed played;
        played.seat = moment.entry.seat;
        played.shot = take.shot;
        played.call = take.call;
        played.record = *moment.entry.record;
        played.verdict = *moment.entry.verdict;
        played.after = moment.after;
        fmt::print(out_, "{:4}. {}\n", moment.after.shots_played, client::tell(table_, played));
    }

    void moved(const replay::Moment& moment) {
        protocol::server::MatchMoved moved;
        moved.seat = moment.entry.seat;
        const auto* choose = std::get_if<match::Choose>(&moment.entry.command);
        if (choose != nullptr) moved.choice = choose->choice;
        moved.verdict = moment.entry.verdict;
        moved.after = moment.after;
        moved.move = protocol::move_of(moment.entry.command);
        fmt::print(out_, "      {}\n", client::tell(table_, moved));
    }

    std::ostream& out_;
    client::TableView table_;
    int rack_ = 0;
    protocol::server::Ending ending_ = protocol::server::Ending::Played;
};

}  // namespace

replay::Result<base::Done> print_score(const replay::Replay& replay, std::ostream& out) {
    print(replay.header, out);
    Scorer scorer(replay.header, out);
    const auto end = replay::play(replay, [&](const replay::Moment& moment) { scorer.on(moment); });
    if (!end) return end.error();
    scorer.end(*end);
    return base::Done{};
}

}  // namespace billiards::tools
