// Takes what a client knows and a message; gives what it knows then: one function a message.
#include "client/app/reduce.h"

#include <algorithm>
#include <chrono>
#include <variant>

namespace billiards::client {

namespace {

namespace server = protocol::server;

class Reduction {
  public:
    Reduction(ClientState& state, base::Instant local_now) : state_(state), now_(local_now) {}

    void on(const server::Welcome& message) {
        state_.link = LinkState::Ready;
        state_.name = message.name;
        state_.token = message.token;
        if (!message.table) state_.table.reset();
        state_.is_table_stale = state_.table.has_value();
        state_.clock_samples.clear();  // It may be another server's clock since a restart.
        state_.clock_offset.reset();
        guess_clock(message.server_time_us);
    }

    void on(const server::Refused& message) { state_.last_refusal = message; }

    /// Nobody at a table asks for the list: it is what the lobby shows to whoever comes back to it.
    void on(const server::TableList& message) {
        state_.tables = message.tables;
        leave_table();
    }

    void on(const server::TableSnapshot& message) {
        TableView view{.row = message.row,
                       .stream = message.stream,
                       .sequence = message.sequence,
                       .my_seats = message.your_seats,
                       .match = message.match,
                       .last_shot = message.rolling,
                       .turn = message.turn,
                       .aim = std::nullopt,
                       .over = std::nullopt};
        if (!view.last_shot) keep_last_shot(view);
        if (view.match && view.match->stage == match::Stage::Over) view.over = end_of(view);
        state_.table = std::move(view);
        state_.is_table_stale = false;
        guess_clock(message.server_time_us);
    }

    void on(const server::SeatChanged& message) {
        TableView* view = news(message.sequence);
        if (view == nullptr) return;
        view->row.seats = message.seats;
        view->row.spectators = message.spectators;
    }

    void on(const server::MatchStarted& message) {
        TableView* view = news(message.sequence);
        if (view == nullptr) return;
        move_on(*view, message.state, message.turn);
        view->row.playing = true;
        view->last_shot.reset();
        view->over.reset();
        view->players_of_match.reset();
    }

    void on(const server::CueBallPlaced& message) {
        TableView* view = news(message.sequence);
        if (view == nullptr || !view->match) return;
        model::PlacedBall* cue_ball = view->match->layout.find(model::kCueBall);
        if (cue_ball == nullptr) return;
        cue_ball->place = model::Place::OnTable;
        cue_ball->position_m = message.position_m;
    }

    void on(const server::AimShown& message) {
        if (!state_.table || !state_.table->match) return;
        if (message.turn == state_.table->match->turn) state_.table->aim = message;
    }

    void on(const server::ShotPlayed& message) {
        TableView* view = news(message.sequence);
        if (view == nullptr) return;
        move_on(*view, message.after, message.turn);
        view->last_shot = message;
    }

    void on(const server::TurnOpened& message) {
        TableView* view = news(message.sequence);
        if (view == nullptr || !view->match || view->match->turn != message.number) return;
        view->turn = message.turn;
    }

    void on(const server::MatchMoved& message) {
        TableView* view = news(message.sequence);
        if (view != nullptr) move_on(*view, message.after, message.turn);
    }

    void on(const server::MatchOver& message) {
        TableView* view = news(message.sequence);
        if (view == nullptr) return;
        view->over = message;
        view->players_of_match = {
            {view->row.seats[model::Seat::First].name, view->row.seats[model::Seat::Second].name}};
        view->aim.reset();
        view->row.playing = false;
        view->row.racks_won = message.racks_won;
        if (!view->match) return;
        view->match->stage = match::Stage::Over;
        view->match->winner = message.winner;
        view->match->racks_won = message.racks_won;
    }

    void on(const server::ChatSaid& message) {
        if (is_muted(state_, message.name)) return;
        if (state_.chat.size() >= kChatKept) state_.chat.erase(state_.chat.begin());
        state_.chat.push_back({.name = message.name, .text = message.text});
    }

    void on(const server::Notice& message) {
        state_.last_notice = message;
        const bool is_table_gone = message.code == server::NoticeCode::TableClosed ||
                                   message.code == server::NoticeCode::Kicked;
        if (is_table_gone) leave_table();
    }

    void on(const server::Pong& message) {
        const base::Duration sent(message.client_time_us);
        const base::Duration round_trip = now_.time_since_epoch() - sent;
        if (round_trip < base::Duration::zero()) return;  // No echo of ours.
        const base::Duration offset =
            base::Duration(message.server_time_us) - (sent + round_trip / 2);
        std::vector<ClockSample>& samples = state_.clock_samples;
        if (samples.size() >= kClockSamplesKept) samples.erase(samples.begin());
        samples.push_back({.round_trip = round_trip, .offset = offset});
        state_.clock_offset = std::min_element(samples.begin(), samples.end(),
                                               [](const ClockSample& a, const ClockSample& b) {
                                                   return a.round_trip < b.round_trip;
                                               })
                                  ->offset;
    }

    /// The table is as it was: what was missed follows as if it had never been away. But whoever
    /// was away is not ready any more.
    void on(const server::Resumed& message) {
        guess_clock(message.server_time_us);
        if (!state_.table || state_.table->row.table != message.table) return;
        state_.link = LinkState::Ready;
        state_.table->my_seats = message.your_seats;
        for (const model::Seat seat : message.your_seats)
            state_.table->row.seats[seat].ready = false;
        state_.is_table_stale = false;
    }

    void on(const server::TableChanged& message) {
        TableView* view = news(message.sequence);
        if (view != nullptr) view->row = message.row;
    }

    void on(const server::TableListChange& message) {
        std::erase_if(state_.tables, [&](const server::TableRow& row) {
            return std::find(message.gone.begin(), message.gone.end(), row.table) !=
                   message.gone.end();
        });
        for (const server::TableRow& changed : message.changed) {
            const auto known = std::find_if(
                state_.tables.begin(), state_.tables.end(),
                [&](const server::TableRow& row) { return row.table == changed.table; });
            if (known != state_.tables.end()) {
                *known = changed;
            } else if (state_.tables.size() < kTablesKept) {
                state_.tables.insert(state_.tables.begin(), changed);
            }
        }
    }

    void on(const server::InviteMade& message) { state_.last_invite = message; }
    void on(const server::HistoryPage& message) { state_.last_history = message; }
    void on(const server::PlayerRecord& message) { state_.last_record = message; }
    /// For whoever asked: a rewound match is another client's state than the live one.
    void on(const server::ReplayChunk&) {}

  private:
    void leave_table() {
        state_.table.reset();
        state_.is_table_stale = false;
    }

    /// The table, where `sequence` is not older than what it has seen: after a reconnect an answer
    /// may tell of something that the snapshot already holds.
    TableView* news(std::uint64_t sequence) {
        if (!state_.table || sequence < state_.table->sequence) return nullptr;
        state_.table->sequence = sequence;
        return &*state_.table;
    }

    static void move_on(TableView& view, const match::MatchState& match, const server::Turn& turn) {
        view.match = match;
        view.turn = turn;
        view.aim.reset();
        view.row.racks_won = match.racks_won;
    }

    /// A snapshot leaves out a shot that has come to rest; it is still the last one if nothing was
    /// played since.
    void keep_last_shot(TableView& view) const {
        if (!state_.table || state_.table->row.table != view.row.table) return;
        if (state_.table->over && view.match && view.match->stage != match::Stage::Over) return;
        const std::optional<server::ShotPlayed>& last = state_.table->last_shot;
        if (last && view.match && last->after.shots_played == view.match->shots_played) {
            view.last_shot = last;
        }
    }

    /// How a match ended that was over before the snapshot; what MatchOver said of it is better.
    std::optional<server::MatchOver> end_of(const TableView& view) const {
        const match::MatchState& match = *view.match;
        const bool is_same_end =
            state_.table && state_.table->over && state_.table->row.table == view.row.table &&
            state_.table->over->winner == match.winner &&
            state_.table->over->racks_won == match.racks_won && state_.table->match &&
            state_.table->match->shots_played == match.shots_played;
        if (is_same_end) return state_.table->over;
        return server::MatchOver{.sequence = view.sequence,
                                 .winner = match.winner,
                                 .racks_won = match.racks_won,
                                 .shots = static_cast<std::uint32_t>(match.shots_played)};
    }

    /// A message took some time to get here, so the largest guess is the nearest.
    void guess_clock(std::int64_t server_time_us) {
        if (!state_.clock_samples.empty()) return;
        const base::Duration guess = base::Duration(server_time_us) - now_.time_since_epoch();
        state_.clock_offset = std::max(state_.clock_offset.value_or(guess), guess);
    }

    ClientState& state_;
    base::Instant now_;
};

}  // namespace

ClientState reduce(ClientState state, const protocol::ServerMessage& message,
                   base::Instant local_now) {
    Reduction reduction(state, local_now);
    std::visit([&reduction](const auto& body) { reduction.on(body); }, message);
    return state;
}

}  // namespace billiards::client
