// Holds the cutting of a stream into frames against streams cut at random.
#include "client/net/frame_buffer.h"

#include "common/base/random.h"

#include <algorithm>
#include <cstring>
#include <gtest/gtest.h>
#include <vector>

namespace billiards::client {
namespace {

using Bytes = std::vector<std::byte>;

constexpr std::size_t kMaxFrame = 64 * 1024;

Bytes frame_of(std::size_t length, std::byte fill) {
    const protocol::FrameHeader header = protocol::encode_frame_header(length);
    Bytes bytes(header.size() + length, fill);
    std::copy(header.begin(), header.end(), bytes.begin());
    return bytes;
}

void feed(FrameBuffer& buffer, std::span<const std::byte> bytes) {
    const std::span<std::byte> room = buffer.room();
    ASSERT_LE(bytes.size(), room.size());
    std::copy(bytes.begin(), bytes.end(), room.begin());
    buffer.add(bytes.size());
}

TEST(FrameBuffer, GivesEveryFrameHoweverTheStreamIsCut) {
    base::Random random(1);
    Bytes stream;
    std::vector<std::size_t> lengths;
    for (int i = 0; i < 200; ++i) {
        lengths.push_back(8 * (1 + random.below(i % 20 == 0 ? kMaxFrame / 8 : 40)));
        const Bytes frame = frame_of(lengths.back(), static_cast<std::byte>(i));
        stream.insert(stream.end(), frame.begin(), frame.end());
    }
    FrameBuffer buffer(kMaxFrame);
    std::vector<std::size_t> given;
    for (std::size_t at = 0; at < stream.size();) {
        const std::size_t most = std::min(buffer.room().size(), stream.size() - at);
        const std::size_t piece = 1 + random.below(most);
        feed(buffer, std::span(stream).subspan(at, piece));
        at += piece;
        for (auto frame = buffer.next(); frame.value(); frame = buffer.next()) {
            const auto fill = static_cast<std::byte>(given.size());
            EXPECT_TRUE(std::all_of((*frame)->begin(), (*frame)->end(),
                                    [fill](std::byte byte) { return byte == fill; }));
            given.push_back((*frame)->size());
        }
    }
    EXPECT_EQ(given, lengths);
}

TEST(FrameBuffer, HasRoomForTheFrameThatIsBeingRead) {
    FrameBuffer buffer(kMaxFrame);
    const Bytes frame = frame_of(kMaxFrame, std::byte{1});
    feed(buffer, std::span(frame).first(protocol::kFrameHeaderBytes));
    ASSERT_FALSE(buffer.next().value());
    EXPECT_GE(buffer.room().size(), kMaxFrame);
}

TEST(FrameBuffer, ShrinksAgainAfterALongFrame) {
    FrameBuffer buffer(kMaxFrame);
    const std::size_t usual = buffer.room().size();
    const Bytes frame = frame_of(kMaxFrame, std::byte{1});
    feed(buffer, std::span(frame).first(usual));
    ASSERT_FALSE(buffer.next().value());
    feed(buffer, std::span(frame).subspan(usual));
    ASSERT_TRUE(buffer.next().value());
    ASSERT_FALSE(buffer.next().value());
    EXPECT_EQ(buffer.room().size(), usual);
}

TEST(FrameBuffer, ALengthThatIsImpossibleIsAnError) {
    for (const std::uint32_t length : {0U, 7U, static_cast<std::uint32_t>(kMaxFrame) + 8, ~0U}) {
        FrameBuffer buffer(kMaxFrame);
        Bytes header(sizeof length);
        std::memcpy(header.data(), &length, sizeof length);
        feed(buffer, header);
        EXPECT_FALSE(buffer.next()) << length;
    }
}

}  // namespace
}  // namespace billiards::client
