// Takes a match as it was stored; gives it as it stood, without solving anything again.
#pragma once

#include "common/base/result.h"
#include "common/match/match_state.h"
#include "common/model/seat.h"
#include "common/protocol/messages.h"
#include "server/store/match_store.h"

#include <cstdint>
#include <optional>
#include <span>
#include <string>

namespace billiards::server {

struct Refolded {
    match::MatchState state;
    std::uint64_t entries = 0;
    /// Each seat's last shot, so that its repeat is answered; its sequence is its entry's, its
    /// times are not set.
    model::PerSeat<std::optional<protocol::server::ShotPlayed>> last_shots;
};

/// The error says which entry does not follow from those before it, and why.
base::Result<Refolded, std::string> refold_journal(const StoredMatch& match,
                                                   std::span<const StoredEntry> entries);

}  // namespace billiards::server
