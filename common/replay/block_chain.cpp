// Takes blocks of bytes; gives one run of bytes in which no byte can be changed, moved or left out
// unnoticed, and back.
#include "common/replay/block_chain.h"

#include "common/base/check.h"
#include "common/base/hash.h"
#include "common/base/little_endian.h"

#include <algorithm>
#include <limits>

namespace billiards::replay {

namespace {

using base::append_number;
using base::number_in;
using Bytes = std::vector<std::byte>;

constexpr std::size_t kWordBytes = 4;
constexpr std::size_t kCheckBytes = 8;
constexpr std::size_t kHeadBytes = 2 * kWordBytes;

std::uint64_t chained(std::uint64_t chain, std::span<const std::byte> bytes) {
    base::Hasher hasher;
    hasher.add(chain);
    hasher.add(std::uint64_t{bytes.size()});
    for (std::size_t at = 0; at < bytes.size(); at += sizeof(std::uint64_t)) {
        const std::size_t size = std::min(sizeof(std::uint64_t), bytes.size() - at);
        hasher.add(number_in(bytes.subspan(at, size)));
    }
    return hasher.digest();
}

}  // namespace

BlockWriter::BlockWriter(std::span<const std::byte> start)
    : bytes_(start.begin(), start.end()), chain_(chained(0, start)) {}

void BlockWriter::add(const Block& block) {
    CHECK(block.content.size() <= std::numeric_limits<std::uint32_t>::max());
    const std::size_t head = bytes_.size();
    append_number(bytes_, block.kind, kWordBytes);
    append_number(bytes_, block.content.size(), kWordBytes);
    check(head);
    const std::size_t content = bytes_.size();
    bytes_.insert(bytes_.end(), block.content.begin(), block.content.end());
    check(content);
}

void BlockWriter::check(std::size_t from) {
    chain_ = chained(chain_, std::span(bytes_).subspan(from));
    append_number(bytes_, chain_, kCheckBytes);
}

BlockReader::BlockReader(std::span<const std::byte> bytes, std::size_t start_bytes)
    : rest_(bytes.subspan(start_bytes)),
      size_(bytes.size()),
      chain_(chained(0, bytes.first(start_bytes))) {}

base::Result<Block, BlockDamage> BlockReader::next() {
    if (rest_.size() < kHeadBytes + kCheckBytes) return BlockDamage::Truncated;
    const auto head = rest_.first(kHeadBytes);
    if (!check(head, rest_.subspan(kHeadBytes, kCheckBytes))) return BlockDamage::Edited;
    const auto kind = static_cast<std::uint32_t>(number_in(head.first(kWordBytes)));
    const auto length = static_cast<std::size_t>(number_in(head.last(kWordBytes)));
    const auto after_head = rest_.subspan(kHeadBytes + kCheckBytes);
    if (after_head.size() < kCheckBytes || after_head.size() - kCheckBytes < length) {
        return BlockDamage::Truncated;
    }
    const auto content = after_head.first(length);
    if (!check(content, after_head.subspan(length, kCheckBytes))) return BlockDamage::Edited;
    rest_ = after_head.subspan(length + kCheckBytes);
    return Block{kind, content};
}

bool BlockReader::check(std::span<const std::byte> bytes, std::span<const std::byte> expected) {
    chain_ = chained(chain_, bytes);
    return chain_ == number_in(expected);
}

Bytes joined(std::span<const Bytes> columns) {
    Bytes out;
    for (const Bytes& column : columns) {
        append_number(out, column.size(), kWordBytes);
        out.insert(out.end(), column.begin(), column.end());
    }
    return out;
}

std::optional<std::vector<Bytes>> split(std::span<const std::byte> bytes) {
    std::vector<Bytes> columns;
    while (!bytes.empty()) {
        if (bytes.size() < kWordBytes) return std::nullopt;
        const auto size = static_cast<std::size_t>(number_in(bytes.first(kWordBytes)));
        bytes = bytes.subspan(kWordBytes);
        if (bytes.size() < size) return std::nullopt;
        columns.emplace_back(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(size));
        bytes = bytes.subspan(size);
    }
    return columns;
}

}  // namespace billiards::replay
