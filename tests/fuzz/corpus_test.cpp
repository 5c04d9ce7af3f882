// Shows, with any compiler and in a second, what the fuzzer looks for: messages that were damaged
// on purpose, by a seed, break no decoder.
#include "common/base/random.h"
#include "common/replay/replay_file.h"
#include "tests/common/protocol/samples.h"
#include "tests/fuzz/decode_anything.h"

#include <gtest/gtest.h>

namespace billiards::fuzz {
namespace {

using protocol::Bytes;

std::vector<Bytes> seeds() {
    std::vector<Bytes> seeds;
    const auto add = [&](std::span<const std::byte> bytes) {
        if (!bytes.empty()) seeds.emplace_back(bytes.begin(), bytes.end());
    };
    for (const auto& sample : protocol::client_samples()) {
        add(protocol::content_of(protocol::encode(sample.value)));
    }
    for (const auto& sample : protocol::server_samples()) {
        add(protocol::content_of(protocol::encode(sample.value)));
    }
    for (const auto& sample : protocol::journal_samples()) {
        const protocol::EncodedEntry columns = protocol::encode_entry(sample.value);
        for (const Bytes& column :
             {columns.command, columns.verdict, columns.final_layout, columns.record}) {
            add(column);
        }
        add(replay::to_bytes({.header = {}, .entries = {sample.value}}).value());
    }
    return seeds;
}

/// The table of segments says again how long the message is, or the rest would never be looked at.
void mend_size(Bytes& bytes) {
    const std::size_t words = bytes.size() / 8;
    if (words == 0) return;
    bytes.resize(8 * words);
    for (std::size_t i = 0; i < 4; ++i) {
        bytes[4 + i] = static_cast<std::byte>((words - 1) >> (8 * i) & 0xffU);
    }
}

TEST(DamagedMessages, CutShortAnywhereBreakNoDecoder) {
    for (const Bytes& seed : seeds()) {
        for (std::size_t size = 0; size < seed.size(); ++size) {
            Bytes bytes(seed.begin(), seed.begin() + static_cast<std::ptrdiff_t>(size));
            decode_anything(bytes);
            if (size % 8 != 0) continue;
            mend_size(bytes);
            decode_anything(bytes);
        }
    }
}

TEST(DamagedMessages, WithAnyByteChangedBreakNoDecoder) {
    base::Random random(20'261);
    for (const Bytes& seed : seeds()) {
        for (std::size_t at = 0; at < seed.size(); ++at) {
            Bytes bytes = seed;
            bytes[at] ^= static_cast<std::byte>(1 + random.below(255));
            decode_anything(bytes);
        }
    }
}

TEST(DamagedMessages, WithManyBytesChangedOrMovedBreakNoDecoder) {
    base::Random random(7);
    const std::vector<Bytes> all = seeds();
    for (int i = 0; i < 5'000; ++i) {
        Bytes bytes = all[random.below(all.size())];
        for (std::uint64_t changes = 1 + random.below(8); changes > 0; --changes) {
            const std::size_t at = random.below(bytes.size());
            bytes[at] = random.below(2) == 0 ? static_cast<std::byte>(random.below(256))
                                             : bytes[random.below(bytes.size())];
        }
        mend_size(bytes);
        decode_anything(bytes);
    }
}

TEST(DamagedMessages, OfNoiseBreakNoDecoder) {
    base::Random random(11);
    for (int i = 0; i < 5'000; ++i) {
        Bytes bytes(8 * random.below(40));
        for (std::byte& byte : bytes) {
            byte = static_cast<std::byte>(random.below(4) == 0 ? random.below(256) : 0);
        }
        if (bytes.size() >= 8) std::fill(bytes.begin(), bytes.begin() + 4, std::byte{0});
        mend_size(bytes);
        decode_anything(bytes);
    }
}

}  // namespace
}  // namespace billiards::fuzz
