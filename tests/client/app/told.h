// Gives tests of the client the messages of a small match between Ada and Grace.
#pragma once

#include "client/app/client_state.h"
#include "common/protocol/messages.h"

#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace billiards::client::told {

inline constexpr base::Instant kNow{std::chrono::seconds(100)};

inline protocol::server::Welcome welcome(std::optional<protocol::TableId> table = {}) {
    return {.name = "Ada#12ab", .token = {1, 2, 3}, .server_time_us = 5'000'000, .table = table};
}

inline match::MatchState match_at(std::uint32_t turn, model::Seat to_act, int shots_played = 0) {
    match::MatchState state;
    state.turn = model::TurnNumber{turn};
    state.to_act = to_act;
    state.shots_played = shots_played;
    state.rack.phase = rules::Phase::Open;
    state.rack.shooter = to_act;
    state.layout.balls = {{.ball = model::kCueBall, .position_m = {-0.5, 0.0}},
                          {.ball = model::BallId{5}, .position_m = {0.5, 0.0}}};
    return state;
}

inline protocol::server::TableSnapshot snapshot(std::uint64_t sequence,
                                                std::vector<model::Seat> mine,
                                                std::optional<match::MatchState> match) {
    protocol::server::TableSnapshot snapshot;
    snapshot.sequence = sequence;
    snapshot.row.table = protocol::TableId{7};
    snapshot.row.name = "The table";
    snapshot.row.seats[model::Seat::First].name = "Ada#12ab";
    snapshot.row.seats[model::Seat::Second].name = "Grace#3f21";
    snapshot.row.playing = match.has_value();
    snapshot.your_seats = std::move(mine);
    snapshot.match = std::move(match);
    snapshot.server_time_us = 5'000'000;
    return snapshot;
}

inline protocol::server::ShotPlayed shot(std::uint64_t sequence, match::MatchState after,
                                         std::uint64_t shot_id = 1) {
    protocol::server::ShotPlayed shot;
    shot.sequence = sequence;
    shot.shot_id = shot_id;
    shot.after = std::move(after);
    shot.turn.opens_us = 9'000'000;
    return shot;
}

inline protocol::server::MatchOver over(std::uint64_t sequence, model::Seat winner) {
    protocol::server::MatchOver over;
    over.sequence = sequence;
    over.winner = winner;
    return over;
}

inline protocol::server::MatchMoved moved(std::uint64_t sequence, model::Seat seat,
                                          match::MatchState after) {
    protocol::server::MatchMoved moved;
    moved.sequence = sequence;
    moved.seat = seat;
    moved.after = std::move(after);
    return moved;
}

inline protocol::server::AimShown aim(std::uint32_t turn) {
    protocol::server::AimShown aim;
    aim.turn = model::TurnNumber{turn};
    return aim;
}

inline protocol::server::Turn open_since(std::int64_t opens_us) {
    protocol::server::Turn turn;
    turn.opens_us = opens_us;
    return turn;
}

inline protocol::server::Refused refused(protocol::RefusedCode code, std::uint32_t in_reply_to) {
    protocol::server::Refused refused;
    refused.code = code;
    refused.in_reply_to = in_reply_to;
    return refused;
}

inline protocol::server::Notice notice(protocol::server::NoticeCode code) {
    return {.code = code, .detail = ""};
}

}  // namespace billiards::client::told
