// Takes bytes; moves what is left of them to the front when more are to come.
#include "client/net/frame_buffer.h"

#include <algorithm>

namespace billiards::client {

namespace {

constexpr std::size_t kUsualBytes = 4096;

}  // namespace

std::span<std::byte> FrameBuffer::room() {
    std::copy(bytes_.begin() + static_cast<std::ptrdiff_t>(begin_),
              bytes_.begin() + static_cast<std::ptrdiff_t>(end_), bytes_.begin());
    end_ -= begin_;
    begin_ = 0;
    const std::size_t size = std::max({wanted_, end_ + 1, kUsualBytes});
    const bool was_large = bytes_.size() > kUsualBytes;
    bytes_.resize(size);
    if (was_large && size == kUsualBytes) bytes_.shrink_to_fit();
    return std::span(bytes_).subspan(end_);
}

base::Result<FrameBuffer::Frame, protocol::FramingError> FrameBuffer::next() {
    const auto rest = std::span<const std::byte>(bytes_).subspan(begin_, end_ - begin_);
    wanted_ = protocol::kFrameHeaderBytes;
    if (rest.size() < wanted_) return Frame();
    const auto length =
        protocol::decode_frame_header(rest.first<protocol::kFrameHeaderBytes>(), max_frame_bytes_);
    if (!length) return length.error();
    wanted_ += *length;
    if (rest.size() < wanted_) return Frame();
    begin_ += wanted_;
    return Frame(rest.subspan(protocol::kFrameHeaderBytes, *length));
}

}  // namespace billiards::client
