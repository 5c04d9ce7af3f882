// Takes when a turn opens, how long it may last and whether anyone is there; gives its deadline.
#pragma once

#include "common/base/time.h"
#include "common/protocol/messages.h"

#include <optional>

namespace billiards::server {

/// A turn waits until the balls rest, then is open until the next step. The clock runs while it is
/// open and a player is connected; it stands still while none is.
class TurnClock {
  public:
    /// A turn that opens later. No `allowed`: it may last for ever.
    void wait_until(base::Instant opens, std::optional<base::Duration> allowed);
    /// Opens the turn that waits, now or early.
    void open(base::Instant now);
    /// An open turn with its time given back in full.
    void open(base::Instant now, std::optional<base::Duration> allowed);
    /// The open turn may last so much longer.
    void extend(base::Duration by);
    /// No turn: before and after a match.
    void stop();
    /// Somebody is there to play, or nobody. True where that changed an open turn's deadline.
    bool set_running(base::Instant now, bool running);

    bool is_waiting() const { return stage_ == Stage::Waiting; }
    bool is_open() const { return stage_ == Stage::Open; }
    base::Instant opens() const { return opens_; }
    std::optional<base::Instant> deadline() const { return deadline_; }
    protocol::server::Turn view() const;

  private:
    enum class Stage : std::uint8_t { None, Waiting, Open };

    Stage stage_ = Stage::None;
    bool running_ = false;
    base::Instant opens_{};
    std::optional<base::Duration> left_;     ///< Of the turn, while its clock stands still.
    std::optional<base::Instant> deadline_;  ///< While its clock runs.
};

/// Microseconds on the wire.
std::int64_t wire_time(base::Instant instant);

}  // namespace billiards::server
