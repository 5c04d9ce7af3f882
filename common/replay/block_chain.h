// Takes blocks of bytes; gives one run of bytes in which no byte can be changed, moved or left out
// unnoticed, and back.
#pragma once

#include "common/base/result.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace billiards::replay {

struct Block {
    std::uint32_t kind = 0;
    std::span<const std::byte> content;
};

/// Each block is u32 kind, u32 length, u64 check, the content, u64 check; little-endian. A check
/// is a hash of every byte before it, of the blocks before included: one behind the length, so
/// that a wrong length is not taken for an early end, and one behind the content. It finds
/// accidents and clumsy hands; it is no signature.
class BlockWriter {
  public:
    /// `start` stands before the first block and is checked with it.
    explicit BlockWriter(std::span<const std::byte> start);

    void add(const Block& block);
    const std::vector<std::byte>& bytes() const { return bytes_; }

  private:
    void check(std::size_t from);

    std::vector<std::byte> bytes_;
    std::uint64_t chain_ = 0;
};

enum class BlockDamage : std::uint8_t { Truncated, Edited };

/// `bytes` must outlive it.
class BlockReader {
  public:
    /// The first start_bytes are the writer's `start`; there must be that many.
    BlockReader(std::span<const std::byte> bytes, std::size_t start_bytes);

    bool is_at_end() const { return rest_.empty(); }
    std::size_t position() const { return size_ - rest_.size(); }
    /// The next block; after damage there is none worth reading.
    base::Result<Block, BlockDamage> next();

  private:
    bool check(std::span<const std::byte> bytes, std::span<const std::byte> expected);

    std::span<const std::byte> rest_;
    std::size_t size_ = 0;
    std::uint64_t chain_ = 0;
};

// Columns: several runs of bytes as one, each after its u32 length, little-endian.

std::vector<std::byte> joined(std::span<const std::vector<std::byte>> columns);
/// None where the bytes are not columns to their end.
std::optional<std::vector<std::vector<std::byte>>> split(std::span<const std::byte> bytes);

}  // namespace billiards::replay
