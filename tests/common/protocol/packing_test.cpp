// Holds packing against bytes of every kind, and against what only looks packed.
#include "common/protocol/packing.h"

#include "common/base/random.h"
#include "common/protocol/codec_journal.h"
#include "tests/common/protocol/samples.h"

#include <gtest/gtest.h>

namespace billiards::protocol {
namespace {

constexpr std::size_t kEnough = 100'000;

Bytes noise(std::size_t size) {
    base::Random random(size);
    Bytes bytes(size);
    for (std::byte& byte : bytes) byte = static_cast<std::byte>(random.below(256));
    return bytes;
}

TEST(Packing, GivesBackWhatItTook) {
    for (const Bytes& bytes : {Bytes{}, Bytes(1), Bytes(50'000), noise(7), noise(50'000)}) {
        EXPECT_EQ(unpacked(packed(bytes), kEnough).value(), bytes);
    }
    for (const auto& [name, entry] : journal_samples()) {
        const Bytes record = encode_entry(entry).record;
        EXPECT_EQ(unpacked(packed(record), kEnough).value(), record) << name;
    }
}

TEST(Packing, TakesWhatWasNeverPacked) {
    for (const auto& [name, entry] : journal_samples()) {
        const EncodedEntry columns = encode_entry(entry);
        EXPECT_EQ(unpacked(columns.command, kEnough).value(), columns.command) << name;
        EXPECT_EQ(unpacked(columns.record, kEnough).value(), columns.record) << name;
    }
}

TEST(Packing, RefusesMoreThanTheLimitPackedOrNot) {
    const Bytes zeros(1'000'000);
    for (const Bytes& bytes : {zeros, packed(zeros)}) {
        EXPECT_TRUE(unpacked(bytes, zeros.size()).ok());
        const auto refused = unpacked(bytes, zeros.size() - 1);
        ASSERT_FALSE(refused.ok());
        EXPECT_EQ(refused.error().code, DecodeErrorCode::OutOfBounds);
    }
}

TEST(Packing, RefusesBytesThatOnlyBeginAsIfPacked) {
    const Bytes whole = packed(noise(500));
    for (std::size_t size = 4; size < whole.size(); ++size) {
        const auto refused = unpacked(std::span(whole).first(size), kEnough);
        ASSERT_FALSE(refused.ok()) << size;
        EXPECT_EQ(refused.error().code, DecodeErrorCode::Malformed) << size;
    }
    Bytes more = whole;
    more.push_back(std::byte{0});
    EXPECT_FALSE(unpacked(more, kEnough).ok());
}

}  // namespace
}  // namespace billiards::protocol
