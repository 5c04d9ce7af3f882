// Takes a match as it was played, step by step; gives it as if it were played now: to be paused,
// and to be gone through from shot to shot.
#pragma once

#include "client/app/rewind.h"
#include "client/play/presentation.h"
#include "common/base/time.h"

#include <chrono>
#include <cstddef>
#include <optional>

namespace billiards::client {

/// Between the end of one step and the next.
inline constexpr base::Duration kBetweenSteps = std::chrono::milliseconds(1200);

/// One match on one screen, beside the live table, which goes on. All times are local.
class Rewatch {
  public:
    /// `live`: what is known of the table. `match`: 0 for the one played there.
    Rewatch(const ClientState& live, std::uint64_t match) : rewind_(live, match) {}

    /// What to ask the server next; none while it has answered everything, or after an error.
    std::optional<protocol::client::AskReplay> question() const { return rewind_.question(); }
    /// False where it is no answer to what was asked: then the match cannot be seen.
    bool take(const protocol::server::ReplayChunk& chunk);

    void advance(base::Instant now);
    void pause() { is_paused_ = true; }
    void go_on() { is_paused_ = false; }
    /// Ends the roll, and plays the next shot at once.
    void next_shot(base::Instant now);
    /// To where the last shot before this one was played, and plays it again.
    void previous_shot(base::Instant now);

    bool is_paused() const { return is_paused_; }
    bool has_ended() const { return is_shown_ && step_ + 1 >= rewind_.steps(); }
    std::size_t step() const { return step_; }
    std::size_t steps() const { return rewind_.steps(); }
    const Presentation& presentation() const { return presentation_; }

  private:
    /// Without a roll: the table as it was after this step.
    void stand_at(std::size_t step);
    void play(std::size_t step, base::Instant now);

    Rewind rewind_;
    Presentation presentation_;
    std::size_t step_ = 0;  ///< The one that is shown.
    bool is_shown_ = false;
    bool is_paused_ = false;
    std::optional<base::Instant> rested_at_;
};

}  // namespace billiards::client
