// Takes the commands of a match and their outcomes; gives the bytes that the journal keeps, and
// back.
#pragma once

#include "common/base/result.h"
#include "common/match/match.h"
#include "common/match/match_state.h"
#include "common/protocol/codec.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace billiards::protocol {

using Bytes = std::vector<std::byte>;

/// One applied command with everything that a refold needs, and the record for whoever watches.
struct JournalEntry {
    model::Seat seat = model::Seat::First;
    match::Command command;
    std::uint64_t shot_id = 0;  ///< Of a TakeShot; lets a repeat after a restart be answered.
    std::optional<rules::Verdict> verdict;
    std::optional<model::Layout> final_layout;
    std::optional<timeline::ShotRecord> record;  ///< Segments through 32-bit floats, as sent.

    friend bool operator==(const JournalEntry&, const JournalEntry&) = default;
};

/// The columns of the journal: each stands alone, so that a reader can leave the record out.
struct EncodedEntry {
    Bytes command;       ///< seat, command, shot_id
    Bytes verdict;       ///< Empty: none.
    Bytes final_layout;  ///< Empty: none.
    Bytes record;        ///< Empty: none.
};

EncodedEntry encode_entry(const JournalEntry& entry);
base::Result<JournalEntry, DecodeError> decode_entry(const EncodedEntry& entry);

/// Settings with the seed: what match::start needs.
Bytes encode_settings(const match::Settings& settings, std::uint64_t seed);
struct StoredSettings {
    match::Settings settings;
    std::uint64_t seed = 0;
};
base::Result<StoredSettings, DecodeError> decode_settings(std::span<const std::byte> bytes);

/// Whether a receiver takes the record: events, segments, duration and numbers within the limits
/// of limits.h. The size in bytes is another question.
bool is_sendable(const timeline::ShotRecord& record);

/// Bytes of the record alone as a viewer gets it: for measuring.
std::size_t encoded_record_size(const timeline::ShotRecord& record);

}  // namespace billiards::protocol
