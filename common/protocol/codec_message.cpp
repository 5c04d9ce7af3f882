// Takes and gives Cap'n Proto messages of one segment, and checks single fields.
#include "common/protocol/codec_message.h"

#include "common/base/little_endian.h"
#include "common/protocol/framing.h"
#include "common/protocol/text.h"

#include <algorithm>
#include <capnp/any.h>
#include <cmath>
#include <cstring>
#include <memory>
#include <optional>
#include <utility>

namespace billiards::protocol {

namespace {

constexpr std::size_t kWordBytes = sizeof(capnp::word);
constexpr std::size_t kCountBytes = 4;  ///< Two before the segment: how many more, and its words.

capnp::ReaderOptions options_for(std::size_t bytes) {
    capnp::ReaderOptions options;
    options.traversalLimitInWords = kTraversalFactor * (bytes / kWordBytes);
    options.nestingLimit = kMaxNesting;
    return options;
}

std::vector<std::byte> with_table(kj::ArrayPtr<const capnp::word> segment,
                                  std::size_t header_bytes) {
    const kj::ArrayPtr<const kj::byte> content = segment.asBytes();
    std::vector<std::byte> bytes;
    bytes.reserve(header_bytes + kWordBytes + content.size());
    bytes.resize(header_bytes);
    base::append_number(bytes, 0, kCountBytes);  // One segment.
    base::append_number(bytes, segment.size(), kCountBytes);
    const auto* first = reinterpret_cast<const std::byte*>(content.begin());
    bytes.insert(bytes.end(), first, first + content.size());
    return bytes;
}

}  // namespace

void fail(DecodeErrorCode code, std::string_view detail) {
    throw DecodeFailure{{code, std::string(detail)}};
}

double finite(double number, std::string_view field) {
    return require(std::isfinite(number), field), number;
}

int count(std::uint32_t number, std::string_view field) {
    return require(number <= kMaxCount, field), static_cast<int>(number);
}

model::BallId ball_id(std::uint8_t number) {
    return require(number < model::kMaxBalls, "ball"), model::BallId{number};
}

std::string text(capnp::Text::Reader reader, std::size_t max_code_points, std::string_view field) {
    constexpr std::size_t kMaxBytesOfACodePoint = 4;
    require(reader.size() <= max_code_points * kMaxBytesOfACodePoint, field);
    const std::string_view view(reader.cStr(), reader.size());
    const std::optional<std::size_t> length = code_points(view);
    require(length && *length <= max_code_points, field);
    return std::string(view);
}

std::string detail(capnp::Text::Reader reader) {
    require(reader.size() <= kMaxDetailLength, "detail");
    return text(reader, kMaxDetailLength, "detail");
}

std::string clipped_detail(std::string_view text) {
    return std::string(clipped(text, kMaxDetailLength));
}

OneSegmentReader::OneSegmentReader(std::span<const std::byte> bytes)
    : MessageReader(options_for(bytes.size())) {
    const std::size_t words = bytes.size() / kWordBytes;
    if (words == 0 || bytes.size() % kWordBytes != 0) {
        fail(DecodeErrorCode::Malformed, "no multiple of 8 bytes above 0");
    }
    const std::uint64_t more_segments = base::number_in(bytes.first(kCountBytes));
    const std::uint64_t segment_words = base::number_in(bytes.subspan(kCountBytes, kCountBytes));
    if (more_segments != 0) fail(DecodeErrorCode::Malformed, "more than one segment");
    if (segment_words != words - 1) fail(DecodeErrorCode::Malformed, "segment's size");
    const bool is_aligned =
        reinterpret_cast<std::uintptr_t>(bytes.data()) % alignof(capnp::word) == 0;
    if (is_aligned) {
        segment_ = {reinterpret_cast<const capnp::word*>(bytes.data()) + 1, words - 1};
    } else {
        copy_ = kj::heapArray<capnp::word>(words - 1);
        std::memcpy(copy_.begin(), bytes.data() + kWordBytes, bytes.size() - kWordBytes);
        segment_ = copy_.asPtr();
    }
}

kj::ArrayPtr<const capnp::word> OneSegmentReader::getSegment(unsigned int id) {
    return id == 0 ? segment_ : nullptr;
}

std::vector<std::byte> in_one_segment(capnp::MessageBuilder& message, std::size_t header_bytes) {
    const auto segments = message.getSegmentsForOutput();
    if (segments.size() == 1) return with_table(segments[0], header_bytes);
    capnp::MallocMessageBuilder single(static_cast<unsigned int>(message.sizeInWords()),
                                       capnp::AllocationStrategy::FIXED_SIZE);
    single.setRoot(message.getRoot<capnp::AnyPointer>().asReader());
    const auto one = single.getSegmentsForOutput();
    CHECK(one.size() == 1);
    return with_table(one[0], header_bytes);
}

SharedFrame framed(std::vector<std::byte> header_and_message) {
    const FrameHeader header = encode_frame_header(header_and_message.size() - kFrameHeaderBytes);
    std::copy(header.begin(), header.end(), header_and_message.begin());
    return std::make_shared<const std::vector<std::byte>>(std::move(header_and_message));
}

}  // namespace billiards::protocol
