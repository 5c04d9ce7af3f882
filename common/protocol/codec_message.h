// Takes bytes from outside and gives what a reader makes of them, or the reason why it cannot;
// takes what a writer fills in and gives bytes. For codec*.cpp only.
#pragma once

#include "common/base/check.h"
#include "common/base/result.h"
#include "common/base/vec.h"
#include "common/protocol/codec.h"
#include "common/protocol/limits.h"

#include <capnp/blob.h>
#include <capnp/message.h>
#include <cstddef>
#include <cstdint>
#include <kj/array.h>
#include <kj/exception.h>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace billiards::protocol {

/// How a reader refuses what it reads. Cap'n Proto reports bad pointers from any field access by
/// throwing, so what we refuse takes the same way; decode_root ends both.
struct DecodeFailure {
    DecodeError error;
};

[[noreturn]] void fail(DecodeErrorCode code, std::string_view detail);

/// Refuses as OutOfBounds; `field` is the name in messages.h.
inline void require(bool holds, std::string_view field) {
    if (!holds) fail(DecodeErrorCode::OutOfBounds, field);
}

double finite(double number, std::string_view field);
int count(std::uint32_t number, std::string_view field);
model::BallId ball_id(std::uint8_t number);
/// At most `max_code_points` of valid UTF-8.
std::string text(capnp::Text::Reader reader, std::size_t max_code_points, std::string_view field);
/// Likewise, kMaxDetailLength bytes: a sentence for logs and for whoever debugs.
std::string detail(capnp::Text::Reader reader);
/// What is sent of a detail that may be too long.
std::string clipped_detail(std::string_view text);

/// The list itself, when it is not longer than allowed: nothing is reserved before this.
template <class List>
List at_most(List list, std::size_t max_size, std::string_view field) {
    require(list.size() <= max_size, field);
    return list;
}

inline std::uint32_t to_count(int number) {
    return CHECK(number >= 0), static_cast<std::uint32_t>(number);
}

/// One Cap'n Proto message of one segment, as Cap'n Proto wants to read it.
class OneSegmentReader final : public capnp::MessageReader {
  public:
    /// Throws DecodeFailure unless `bytes` are one segment with its table and nothing else. Copies
    /// them only where they are not aligned; otherwise they must live as long as this.
    explicit OneSegmentReader(std::span<const std::byte> bytes);

    kj::ArrayPtr<const capnp::word> getSegment(unsigned int id) override;

  private:
    kj::Array<capnp::word> copy_;
    kj::ArrayPtr<const capnp::word> segment_;
};

/// read(Root::Reader) gives the value; it may throw DecodeFailure.
template <class Root, class Read>
auto decode_root(std::span<const std::byte> bytes, Read read)
    -> base::Result<decltype(read(typename Root::Reader())), DecodeError> {
    try {
        OneSegmentReader reader(bytes);
        return read(reader.getRoot<Root>());
    } catch (const DecodeFailure& failure) {
        return failure.error;
    } catch (const kj::Exception& exception) {
        return DecodeError{DecodeErrorCode::Malformed, exception.getDescription().cStr()};
    }
}

/// `message` as one segment with its table, after `header_bytes` bytes left free.
std::vector<std::byte> in_one_segment(capnp::MessageBuilder& message, std::size_t header_bytes);

/// fill(Root::Builder) writes the value.
template <class Root, class Fill>
std::vector<std::byte> encode_root(Fill fill, std::size_t header_bytes = 0) {
    capnp::MallocMessageBuilder message;
    fill(message.initRoot<Root>());
    return in_one_segment(message, header_bytes);
}

/// A whole frame with its length header.
SharedFrame framed(std::vector<std::byte> header_and_message);

}  // namespace billiards::protocol
