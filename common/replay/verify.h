// Takes a replay; gives whether this engine would play the same match, to the bit.
#pragma once

#include "common/match/match.h"
#include "common/replay/replay.h"

#include <cstdint>
#include <string>

namespace billiards::replay {

enum class NotVerifiedCode : std::uint8_t {
    OtherEngine,  ///< Another version played it: it plays, but says nothing when solved again.
    Differs,      ///< detail names the first entry that comes out otherwise, and what in it.
};

struct NotVerified {
    NotVerifiedCode code = NotVerifiedCode::Differs;
    std::string detail;

    friend bool operator==(const NotVerified&, const NotVerified&) = default;
};

/// What is kept of a step that was applied: its record as everyone gets it. The error is that of a
/// record too large to be sent.
base::Result<protocol::JournalEntry, protocol::DecodeError> kept(model::Seat seat,
                                                                 const match::Command& command,
                                                                 std::uint64_t shot_id,
                                                                 match::Outcome outcome);

/// Solves and judges every shot again, and compares record, layout, ruling and hash.
base::Result<base::Done, NotVerified> verify(const Replay& replay);

}  // namespace billiards::replay
