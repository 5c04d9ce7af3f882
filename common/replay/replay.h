// Gives a match that was played, as it is kept in a file: what it started from, and what was done.
#pragma once

#include "common/match/match_state.h"
#include "common/model/seat.h"
#include "common/protocol/codec_journal.h"
#include "common/replay/engine_version.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace billiards::replay {

inline constexpr std::size_t kMaxFileBytes = std::size_t{16} << 20U;
inline constexpr std::size_t kMaxShots = 5'000;
inline constexpr std::size_t kMaxEntries = 20'000;  ///< Shots, placements, choices and the like.
/// Of all entries together, so that a small file cannot take all memory.
inline constexpr std::size_t kMaxUnpackedBytes = std::size_t{64} << 20U;
inline constexpr std::size_t kMaxEngineLength = 40;             ///< Code points.
inline constexpr std::int64_t kMaxStarted_s = 253'402'300'799;  ///< The end of the year 9999.

struct Header {
    std::string engine = std::string(kEngineVersion);  ///< Solved and judged the shots.
    match::Settings settings;
    /// Of every rack, also of those to come: a match that is not over must not leave its server.
    std::uint64_t seed = 0;
    model::PerSeat<std::string> players;  ///< Shown names.
    std::string table;
    std::int64_t started_s = 0;  ///< Since 1970-01-01 UTC; 0: unknown.

    friend bool operator==(const Header&, const Header&) = default;
};

struct Replay {
    Header header;
    std::vector<protocol::JournalEntry> entries;

    friend bool operator==(const Replay&, const Replay&) = default;
};

enum class FaultCode : std::uint8_t {
    NotAReplay,  ///< It does not begin as one.
    Newer,       ///< Written by a newer version of this program.
    TooLarge,    ///< Over a limit above; detail names it.
    Truncated,   ///< It ends too early.
    Edited,      ///< Bytes in it are not those that were written.
    Invalid,  ///< Written so, and yet no match: a value out of bounds, or a step that no rule has.
};

/// Why a file is refused, as a sentence in plain ASCII.
struct Fault {
    FaultCode code = FaultCode::Invalid;
    std::string detail;

    friend bool operator==(const Fault&, const Fault&) = default;
};

template <class T>
using Result = base::Result<T, Fault>;

}  // namespace billiards::replay
