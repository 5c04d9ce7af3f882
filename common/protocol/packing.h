// Takes bytes that are kept for long; gives them packed by zstd, and back.
#pragma once

#include "common/base/result.h"
#include "common/protocol/codec.h"

#include <cstddef>
#include <span>
#include <vector>

namespace billiards::protocol {

/// No bytes stay no bytes. Takes tens of microseconds for a record: not for a thread that others
/// wait for.
std::vector<std::byte> packed(std::span<const std::byte> bytes);

/// Takes what packed() gave, and also what never was packed: a Cap'n Proto message of one segment
/// does not begin as zstd does. More than `max_bytes` are refused before they are unpacked.
base::Result<std::vector<std::byte>, DecodeError> unpacked(std::span<const std::byte> bytes,
                                                           std::size_t max_bytes);

}  // namespace billiards::protocol
