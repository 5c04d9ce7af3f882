// Takes what a table's server says, as it arrives; gives what of it the screen shows, and when: a
// ruling waits until the balls rest.
#pragma once

#include "client/app/client_state.h"
#include "client/playback/playback.h"
#include "common/base/time.h"
#include "common/protocol/messages.h"

#include <chrono>
#include <cstdint>
#include <deque>
#include <optional>
#include <string>
#include <vector>

namespace billiards::client {

inline constexpr std::size_t kLinesKept = 200;
/// How long a rack that is won lies as it ended before the next one is shown.
inline constexpr base::Duration kRackRests = std::chrono::milliseconds(1500);

/// One table on one screen. All times are local.
class Presentation {
  public:
    /// A table as a snapshot gives it: nothing is told of what came before, but a shot that still
    /// rolls is seen where it is.
    void enter(const TableView& table, base::Duration clock_offset);
    void leave();

    /// One message, with the table as it was known before it and after it.
    void received(const TableView& before, const TableView& after,
                  const protocol::ServerMessage& message, base::Duration clock_offset);

    /// Shows what is due.
    void advance(base::Instant now);
    /// Ends the roll at once.
    void skip();

    /// The table as shown; null where there is none.
    const TableView* table() const { return table_ ? &*table_ : nullptr; }
    /// The shot whose balls roll; null where all rest and the next may be played.
    const Playback* rolling() const { return rolling_ ? &*rolling_ : nullptr; }
    /// Its balls rest, and have ended a rack: the next one is shown in a moment.
    bool rests() const { return rests_; }
    /// The balls in play, in ascending number.
    std::vector<ShownBall> balls(base::Instant now) const;
    /// What happened, in sentences, the oldest first.
    const std::deque<std::string>& lines() const { return lines_; }
    /// The sequence of a shot that was shown to its end, once.
    std::optional<std::uint64_t> take_seen();

  private:
    /// A table to come, and what is said of it.
    struct Due {
        TableView table;
        std::string line;
    };

    base::Duration rest() const;
    void say(std::string& line);
    void show(Due due);
    void settle();

    std::optional<TableView> table_;
    std::optional<Playback> rolling_;
    bool rests_ = false;
    std::vector<Due> due_;  ///< Once the balls rest, in this order.
    std::deque<std::string> lines_;
    std::optional<std::uint64_t> seen_;
};

}  // namespace billiards::client
