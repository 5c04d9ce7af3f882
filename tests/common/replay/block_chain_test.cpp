// Holds the chain of blocks against every byte changed, moved or left out.
#include "common/replay/block_chain.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <string_view>

namespace billiards::replay {
namespace {

using Bytes = std::vector<std::byte>;

Bytes bytes_of(std::string_view text) {
    const auto bytes = std::as_bytes(std::span(text));
    return {bytes.begin(), bytes.end()};
}

struct Kept {
    std::uint32_t kind = 0;
    Bytes content;
    friend bool operator==(const Kept&, const Kept&) = default;
};

struct Read {
    std::vector<Kept> blocks;
    std::optional<BlockDamage> damage;
};

const Bytes kStart = bytes_of("start");
const std::vector<Kept> kBlocks{
    {1, bytes_of("a header")}, {2, bytes_of("entry")}, {2, bytes_of("entry")}, {7, {}}};

Bytes written(const std::vector<Kept>& blocks) {
    BlockWriter writer(kStart);
    for (const Kept& block : blocks) writer.add({block.kind, block.content});
    return writer.bytes();
}

Read read(std::span<const std::byte> bytes) {
    Read all;
    BlockReader reader(bytes, kStart.size());
    while (!reader.is_at_end() && !all.damage) {
        const auto block = reader.next();
        if (block) {
            all.blocks.push_back({block->kind, {block->content.begin(), block->content.end()}});
        } else {
            all.damage = block.error();
        }
    }
    return all;
}

TEST(BlockChain, GivesBackItsBlocks) {
    const Read all = read(written(kBlocks));
    EXPECT_EQ(all.blocks, kBlocks);
    EXPECT_FALSE(all.damage);
}

TEST(BlockChain, FindsEveryChangedBit) {
    const Bytes whole = written(kBlocks);
    for (std::size_t bit = 0; bit < 8 * whole.size(); ++bit) {
        Bytes bytes = whole;
        bytes[bit / 8] ^= static_cast<std::byte>(1U << bit % 8);
        EXPECT_EQ(read(bytes).damage, BlockDamage::Edited) << "bit " << bit;
    }
}

TEST(BlockChain, FindsABlockMovedOrLeftOut) {
    const Bytes whole = written({{1, {}}, {2, bytes_of("one")}, {2, bytes_of("two")}, {3, {}}});
    const auto first = static_cast<std::ptrdiff_t>(written({{1, {}}}).size());
    const auto size =
        static_cast<std::ptrdiff_t>(written({{1, {}}, {2, bytes_of("one")}}).size()) - first;
    Bytes without = whole;
    without.erase(without.begin() + first, without.begin() + first + size);
    EXPECT_EQ(read(without).damage, BlockDamage::Edited);
    Bytes swapped = whole;
    std::rotate(swapped.begin() + first, swapped.begin() + first + size,
                swapped.begin() + first + 2 * size);
    EXPECT_EQ(read(swapped).damage, BlockDamage::Edited);
}

TEST(BlockChain, SaysTruncatedWhereverItIsCut) {
    const Bytes whole = written(kBlocks);
    for (std::size_t size = kStart.size(); size < whole.size(); ++size) {
        const Read all = read(std::span(whole).first(size));
        EXPECT_NE(all.damage, BlockDamage::Edited) << size;
        EXPECT_LT(all.blocks.size(), kBlocks.size()) << size;
    }
}

TEST(Columns, AreGivenBackEmptyOnesIncluded) {
    const std::vector<Bytes> columns{bytes_of("one"), {}, bytes_of("three"), {}};
    EXPECT_EQ(split(joined(columns)), columns);
}

TEST(Columns, CutShortAreNone) {
    const Bytes whole = joined(std::vector<Bytes>{bytes_of("one"), bytes_of("two")});
    for (std::size_t size = 1; size < whole.size(); ++size) {
        const bool is_one_column = size == whole.size() / 2;
        EXPECT_EQ(split(std::span(whole).first(size)).has_value(), is_one_column) << size;
    }
}

}  // namespace
}  // namespace billiards::replay
