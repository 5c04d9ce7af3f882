// Takes a replay; gives the bytes of a .billiards file, and back, whatever bytes they are.
// docs/replay.md has the format.
#pragma once

#include "common/replay/replay.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace billiards::replay {

inline constexpr std::uint16_t kFormatMajor = 1;
inline constexpr std::uint16_t kFormatMinor = 0;
inline constexpr std::size_t kStartBytes = 16;  ///< Before the first block: magic and version.

/// Refuses, as TooLarge, what from_bytes would refuse.
Result<std::vector<std::byte>> to_bytes(const Replay& replay);

struct Opened {
    Replay replay;
    /// Where the file is damaged behind its header: `replay` has the entries before that, each as
    /// it was written. Whoever needs the whole match refuses it.
    std::optional<Fault> damage;

    friend bool operator==(const Opened&, const Opened&) = default;
};

/// Total: any bytes give a replay or the reason why not. That its entries are a match is for
/// play() to say.
Result<Opened> from_bytes(std::span<const std::byte> bytes);

}  // namespace billiards::replay
