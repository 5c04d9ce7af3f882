// Gives the whole truth of one shot: what happened, how every ball moved, and where all came to
// rest.
#pragma once

#include "common/model/layout.h"
#include "common/model/shot_event.h"
#include "common/timeline/timeline.h"

#include <cstdint>
#include <vector>

namespace billiards::timeline {

/// Immutable once made. The hash is over the bits of everything else.
struct ShotRecord {
    std::vector<model::ShotEvent> events;  ///< In order of time.
    Timeline timeline;
    model::Layout final_layout;  ///< Every ball that was given, in ascending number.
    double duration_s = 0.0;     ///< Until the last ball rests.
    std::uint64_t hash = 0;

    friend bool operator==(const ShotRecord&, const ShotRecord&) = default;
};

/// The hash that `record` should carry: a 64-bit digest of its events, timeline, final layout and
/// duration, the same on every machine.
std::uint64_t hash_of(const ShotRecord& record);

}  // namespace billiards::timeline
