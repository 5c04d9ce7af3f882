// Shows that any two versions can refuse each other in words, and that no length is believed.
#include "common/protocol/framing.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <string_view>

namespace billiards::protocol {
namespace {

PreambleBytes bytes_of(std::string_view text) {
    PreambleBytes bytes{};
    std::transform(text.begin(), text.end(), bytes.begin(),
                   [](char letter) { return static_cast<std::byte>(letter); });
    return bytes;
}

FrameHeader header(unsigned char a, unsigned char b, unsigned char c, unsigned char d) {
    return {std::byte{a}, std::byte{b}, std::byte{c}, std::byte{d}};
}

TEST(Preamble, IsSixteenBytesThatNeverChange) {
    const Preamble preamble{.major = 0x0102, .minor = 0x0304, .features = 0x05060708};
    using namespace std::string_view_literals;
    EXPECT_EQ(encode_preamble(preamble), bytes_of("GLBILLRD\2\1\4\3\10\7\6\5"sv));
}

TEST(Preamble, IsReadWhateverTheMinorVersionAndTheFeatures) {
    const Preamble newer{.minor = 65535, .features = 0xffffffff};
    const auto decoded = decode_preamble(encode_preamble(newer));
    ASSERT_TRUE(decoded.ok());
    EXPECT_EQ(*decoded, newer);
}

TEST(Preamble, OfAnotherMajorVersionIsRefusedByBothNames) {
    const auto decoded = decode_preamble(encode_preamble({.major = 9, .minor = 3}));
    ASSERT_FALSE(decoded.ok());
    EXPECT_EQ(decoded.error().code, FramingErrorCode::OtherVersion);
    const std::string ours = std::to_string(kVersionMajor) + "." + std::to_string(kVersionMinor);
    EXPECT_NE(decoded.error().detail.find("9.3"), std::string::npos);
    EXPECT_NE(decoded.error().detail.find(ours), std::string::npos);
}

TEST(Preamble, OfAnotherProtocolIsRefused) {
    for (const std::string_view text : {"GET / HTTP/1.1\r\n", "glbillrd", "GLBILLR", ""}) {
        const auto decoded = decode_preamble(bytes_of(text));
        ASSERT_FALSE(decoded.ok()) << text;
        EXPECT_EQ(decoded.error().code, FramingErrorCode::BadMagic) << text;
    }
}

TEST(FrameHeader, IsLittleEndian) {
    EXPECT_EQ(encode_frame_header(0x00020108), header(0x08, 0x01, 0x02, 0x00));
    const auto length = decode_frame_header(header(0x08, 0x01, 0x02, 0x00), 1 << 20);
    ASSERT_TRUE(length.ok());
    EXPECT_EQ(*length, 0x00020108U);
}

TEST(FrameHeader, OfNoWholeWordsIsRefused) {
    for (const FrameHeader& bytes : {header(0, 0, 0, 0), header(1, 0, 0, 0), header(12, 0, 0, 0)}) {
        const auto length = decode_frame_header(bytes, 1 << 20);
        ASSERT_FALSE(length.ok());
        EXPECT_EQ(length.error().code, FramingErrorCode::BadFrameLength);
    }
}

TEST(FrameHeader, BeyondTheLimitIsRefusedByItsNumbers) {
    EXPECT_TRUE(decode_frame_header(encode_frame_header(512), 512).ok());
    const auto length = decode_frame_header(encode_frame_header(520), 512);
    ASSERT_FALSE(length.ok());
    EXPECT_EQ(length.error().code, FramingErrorCode::FrameTooLong);
    EXPECT_EQ(length.error().detail, "520 bytes, allowed are 512");
    EXPECT_FALSE(decode_frame_header(header(0xf8, 0xff, 0xff, 0xff), kMaxServerFrameBytes).ok());
}

}  // namespace
}  // namespace billiards::protocol
