// Takes a shot and the offset of the server's clock; gives the balls at any presentation time, and
// what happened between two of them.
#pragma once

#include "common/base/time.h"
#include "common/model/ball.h"
#include "common/model/shot_event.h"
#include "common/protocol/messages.h"

#include <span>
#include <vector>

namespace billiards::client {

struct ShownBall {
    model::BallId ball;
    double radius_m = 0.0;
    model::BallState state;

    friend bool operator==(const ShownBall&, const ShownBall&) = default;
};

/// One shot as it is shown. Needs no engine: the record says everything. All times are local ones;
/// before the strike the balls are as they lay, after the end as they came to rest.
class Playback {
  public:
    /// clock_offset: server time minus local time, so that a latecomer sees the balls where
    /// everybody sees them. A client that strikes itself gives the offset that lets the strike be
    /// now. Every track of the record must have a segment, as the codec makes sure.
    Playback(protocol::server::ShotPlayed shot, base::Duration clock_offset);

    /// All balls of the record, in ascending number.
    std::vector<ShownBall> balls(base::Instant at) const;
    bool finished(base::Instant at) const;
    base::Instant ends_at() const;

    /// The events after `from`, up to and with `to`: for sounds. Playing on from one `to` to the
    /// next gives each event once; the first `from` may be anything before the strike.
    std::span<const model::ShotEvent> events_between(base::Instant from, base::Instant to) const;

    const protocol::server::ShotPlayed& shot() const { return shot_; }

  private:
    double shot_time_s(base::Instant at) const { return base::seconds(at - struck_at_); }

    protocol::server::ShotPlayed shot_;
    base::Instant struck_at_;  ///< On the local clock.
};

}  // namespace billiards::client
