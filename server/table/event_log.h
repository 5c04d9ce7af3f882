// Takes a table's events as they are told; gives those that somebody missed.
#pragma once

#include "common/protocol/codec.h"

#include <cstddef>
#include <cstdint>
#include <deque>
#include <optional>
#include <vector>

namespace billiards::server {

/// The newest events of one stream, as the frames that everyone got. Each is numbered one above
/// the one before.
class EventLog {
  public:
    struct Limits {
        std::size_t events = 0;
        std::size_t bytes = 0;  ///< Of all frames together.
    };

    explicit EventLog(Limits limits) : limits_(limits) {}

    /// Nothing is kept, as if the event with this number had been the last; at first it is 0.
    void skip_to(std::uint64_t sequence);
    /// The oldest frames are forgotten over a limit; a
    /// frame that is larger than the log leaves it empty.
    void append(protocol::SharedFrame frame);

    /// What followed the event with this number, the oldest first; none where some of it is
    /// forgotten or the number was never given.
    std::optional<std::vector<protocol::SharedFrame>> since(std::uint64_t sequence) const;

    std::uint64_t last() const { return last_; }
    std::size_t size() const { return frames_.size(); }
    std::size_t bytes() const { return bytes_; }

  private:
    Limits limits_;
    std::uint64_t last_ = 0;
    std::deque<protocol::SharedFrame> frames_;
    std::size_t bytes_ = 0;
};

}  // namespace billiards::server
