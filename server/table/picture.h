// Gives a table as it is shown at one moment: to its players at once, to a delayed gallery later.
#pragma once

#include "common/base/time.h"
#include "common/match/match_state.h"
#include "common/protocol/codec.h"
#include "common/protocol/messages.h"
#include "server/store/match_store.h"

#include <cstdint>
#include <optional>

namespace billiards::server {

struct Picture {
    std::uint64_t sequence = 0;  ///< Of the last event in it.
    protocol::server::TableRow row;
    std::optional<MatchId> match_id;
    std::uint64_t steps = 0;         ///< Of the match's journal, with how it began.
    bool match_was_private = false;  ///< It is not for those who come once the table is public.
    std::optional<match::MatchState> match;  ///< As it is told: match::as_told.
    protocol::SharedFrame rolling;           ///< ShotPlayed, while there is one.
    base::Instant rests{};                   ///< When its balls do.
    protocol::server::Turn turn;
};

/// Without seats and stream, which differ from one receiver to another.
protocol::server::TableSnapshot snapshot_of(const Picture& picture, base::Instant now);

/// What the server has encoded itself.
protocol::ServerMessage message_in(const protocol::SharedFrame& frame);

/// The same news for those who are told so much later: each moment in it is as late as they are.
protocol::ServerMessage told_later(protocol::ServerMessage message, base::Duration by);

}  // namespace billiards::server
