// Takes bytes as a stream gives them; gives whole frames.
#pragma once

#include "common/base/result.h"
#include "common/protocol/framing.h"

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace billiards::client {

/// Holds one piece of a stream: small while frames are, as large as the frame that is being read.
class FrameBuffer {
  public:
    using Frame = std::optional<std::span<const std::byte>>;

    explicit FrameBuffer(std::size_t max_frame_bytes) : max_frame_bytes_(max_frame_bytes) {}

    /// Where the next bytes of the stream go; never empty. Ends the life of frames given before.
    std::span<std::byte> room();
    /// So many bytes were put at the start of room().
    void add(std::size_t bytes) { end_ += bytes; }

    /// The next frame, without its length header; none where it is not whole yet. After an error
    /// there is no next frame: what follows cannot be told apart.
    base::Result<Frame, protocol::FramingError> next();

  private:
    std::size_t max_frame_bytes_;
    std::vector<std::byte> bytes_;
    std::size_t begin_ = 0;  ///< Of what was not given yet.
    std::size_t end_ = 0;
    std::size_t wanted_ = 0;  ///< With its header, of the frame that is not whole yet.
};

}  // namespace billiards::client
