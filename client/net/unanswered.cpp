// Takes requests; drops each when a message answers it.
#include "client/net/unanswered.h"

#include <algorithm>
#include <type_traits>
#include <variant>

namespace billiards::client {

namespace {

namespace asked = protocol::client;
namespace server = protocol::server;
using model::Seat;
using Seats = std::vector<Seat>;

/// The match as a message leaves it, if it tells.
const match::MatchState* match_in(const protocol::ServerMessage& message) {
    if (const auto* shot = std::get_if<server::ShotPlayed>(&message)) return &shot->after;
    if (const auto* moved = std::get_if<server::MatchMoved>(&message)) return &moved->after;
    const auto* snapshot = std::get_if<server::TableSnapshot>(&message);
    return snapshot != nullptr && snapshot->match ? &*snapshot->match : nullptr;
}

bool is_move(const protocol::ServerMessage& message, server::Move move) {
    const auto* moved = std::get_if<server::MatchMoved>(&message);
    return moved != nullptr && moved->move == move;
}

bool is_match_over(const protocol::ServerMessage& message) {
    if (std::holds_alternative<server::MatchOver>(message)) return true;
    if (const auto* snapshot = std::get_if<server::TableSnapshot>(&message)) {
        if (!snapshot->match) return true;
    }
    const match::MatchState* match = match_in(message);
    return match != nullptr && match->stage == match::Stage::Over;
}

/// Nothing that was asked of this turn can be done any more.
bool is_turn_over(const protocol::ServerMessage& message, model::TurnNumber turn) {
    if (const auto* opened = std::get_if<server::TurnOpened>(&message)) {
        return opened->number > turn;
    }
    const match::MatchState* match = match_in(message);
    return is_match_over(message) || (match != nullptr && match->turn > turn);
}

bool are_ready(const model::PerSeat<server::SeatView>& seats, const Seats& mine) {
    return !mine.empty() &&
           std::all_of(mine.begin(), mine.end(), [&](Seat seat) { return seats[seat].ready; });
}

/// Exactly: a place is kept as it was asked for.
bool lies_at(const match::MatchState& match, base::Vec2 position_m) {
    const model::PlacedBall* cue_ball = match.layout.find(model::kCueBall);
    return cue_ball != nullptr && cue_ball->place == model::Place::OnTable &&
           cue_ball->position_m == position_m;
}

bool is_of(const Seats& mine, Seat seat) {
    return mine.empty() || std::find(mine.begin(), mine.end(), seat) != mine.end();
}

/// One function for each request that may be repeated.
struct AnsweredBy {
    const protocol::ServerMessage& message;
    const Seats& mine;

    bool operator()(const asked::TakeShot& asked) const {
        if (const auto* shot = std::get_if<server::ShotPlayed>(&message)) {
            return shot->shot_id == asked.shot_id;
        }
        const auto* snapshot = std::get_if<server::TableSnapshot>(&message);
        if (snapshot == nullptr) return std::holds_alternative<server::MatchOver>(message);
        return snapshot->rolling && snapshot->rolling->shot_id == asked.shot_id;
    }
    bool operator()(const asked::PlaceCueBall& asked) const {
        if (const auto* placed = std::get_if<server::CueBallPlaced>(&message)) {
            return placed->position_m == asked.position_m;
        }
        const match::MatchState* match = match_in(message);
        return is_turn_over(message, asked.turn) ||
               (match != nullptr && lies_at(*match, asked.position_m));
    }
    bool operator()(const asked::Choose& asked) const { return is_turn_over(message, asked.turn); }
    bool operator()(const asked::Extend& asked) const {
        const match::MatchState* match = match_in(message);
        const auto has_extended = [&](Seat seat) {
            return is_of(mine, seat) && match->extended_in[seat] == asked.turn;
        };
        return is_turn_over(message, asked.turn) ||
               (match != nullptr && std::ranges::any_of(model::kSeats, has_extended));
    }
    bool operator()(const asked::Answer& asked) const {
        const match::MatchState* match = match_in(message);
        return is_turn_over(message, asked.turn) || (match != nullptr && !match->offer);
    }
    bool operator()(const asked::ClaimStalemate& asked) const {
        const match::MatchState* match = match_in(message);
        return is_turn_over(message, asked.turn) || (match != nullptr && match->claim);
    }
    bool operator()(const asked::SpotNearest& asked) const {
        return is_turn_over(message, asked.turn) || is_move(message, server::Move::Spotting);
    }
    bool operator()(const asked::Concede&) const { return is_match_over(message); }
    bool operator()(const asked::ClaimMatch&) const { return is_match_over(message); }
    bool operator()(const asked::Ready&) const { return is_readiness_known(); }
    bool operator()(const asked::Rematch&) const { return is_readiness_known(); }
    bool operator()(const asked::Leave&) const {
        return std::holds_alternative<server::TableList>(message);
    }
    template <class Request>
    bool operator()(const Request&) const {
        return false;
    }

    /// Ready now; or asked anew, because what will be played has changed.
    bool is_readiness_known() const {
        if (const auto* changed = std::get_if<server::SeatChanged>(&message)) {
            return are_ready(changed->seats, mine);
        }
        if (const auto* snapshot = std::get_if<server::TableSnapshot>(&message)) {
            return snapshot->row.playing || are_ready(snapshot->row.seats, mine);
        }
        return std::holds_alternative<server::TableChanged>(message);
    }
};

bool takes_the_table_away(const protocol::ServerMessage& message) {
    if (const auto* welcome = std::get_if<server::Welcome>(&message)) return !welcome->table;
    const auto* notice = std::get_if<server::Notice>(&message);
    return notice != nullptr && (notice->code == server::NoticeCode::TableClosed ||
                                 notice->code == server::NoticeCode::Kicked);
}

}  // namespace

bool may_be_repeated(const protocol::ClientMessageBody& request) {
    return std::visit(
        []<class Request>(const Request&) {
            return (std::is_same_v<Request, asked::TakeShot> ||
                    std::is_same_v<Request, asked::PlaceCueBall> ||
                    std::is_same_v<Request, asked::Choose> ||
                    std::is_same_v<Request, asked::Extend> ||
                    std::is_same_v<Request, asked::Answer> ||
                    std::is_same_v<Request, asked::ClaimStalemate> ||
                    std::is_same_v<Request, asked::SpotNearest> ||
                    std::is_same_v<Request, asked::Concede> ||
                    std::is_same_v<Request, asked::ClaimMatch> ||
                    std::is_same_v<Request, asked::Leave>);
        },
        request);
}

bool is_answer(const protocol::ServerMessage& message, const protocol::ClientMessage& request,
               const Seats& mine) {
    if (const auto* refused = std::get_if<server::Refused>(&message)) {
        return refused->in_reply_to == request.request_id;
    }
    if (takes_the_table_away(message)) return true;
    const bool is_leave = std::holds_alternative<asked::Leave>(request.body);
    if (std::holds_alternative<server::MatchStarted>(message)) return !is_leave;
    return std::visit(AnsweredBy{message, mine}, request.body);
}

bool Unanswered::sent(const protocol::ClientMessage& request) {
    if (!may_be_repeated(request.body)) return false;
    if (std::holds_alternative<asked::Leave>(request.body)) requests_.clear();
    std::erase_if(requests_, [&](const protocol::ClientMessage& earlier) {
        return earlier.body.index() == request.body.index();
    });
    requests_.push_back(request);
    return true;
}

void Unanswered::received(const protocol::ServerMessage& message) {
    if (const auto* snapshot = std::get_if<server::TableSnapshot>(&message)) {
        mine_ = snapshot->your_seats;
    } else if (const auto* resumed = std::get_if<server::Resumed>(&message)) {
        mine_ = resumed->your_seats;
    }
    std::erase_if(requests_, [&](const protocol::ClientMessage& request) {
        return is_answer(message, request, mine_);
    });
}

}  // namespace billiards::client
