// Takes what the connections of a load see; gives the figures.
#pragma once

#include "common/base/time.h"
#include "common/protocol/messages.h"

#include <cstddef>
#include <cstdint>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

namespace billiards::tools {

/// Numbers of which the quantiles are wanted.
class Samples {
  public:
    void add(double sample) { samples_.push_back(sample); }
    std::size_t size() const { return samples_.size(); }
    /// The smallest sample that at least the share `quantile` in (0, 1] does not exceed; 0 of none.
    double at(double quantile) const;
    /// {"p50", "p99", "max"}, or null of none.
    nlohmann::ordered_json summary() const;

  private:
    std::vector<double> samples_;
};

class Recorder {
  public:
    /// From here on shots count; what was sent before does not.
    void start() { is_measuring_ = true; }
    void stop() { is_measuring_ = false; }

    /// The last byte of a TakeShot was given to the system.
    void shot_sent(std::uint64_t shot_id, base::Instant at);
    /// One receiver has decoded a shot. Counts only a shot that was sent while measuring.
    void shot_received(const protocol::server::ShotPlayed& shot, std::size_t frame_bytes,
                       base::Instant at);
    void error(const std::string& what) { ++errors_[what]; }
    /// A lost connection was made again and welcomed, this long after it was lost.
    void reconnected(base::Duration after) { reconnect_s_.add(base::seconds(after)); }
    /// How a server brought somebody who came back up to date: with what they had missed, or with
    /// the whole table.
    enum class Way : std::uint8_t { Ring, Snapshot };
    void resumed(Way way) { ++(way == Way::Ring ? by_ring_ : by_snapshot_); }
    /// From here on what is lost and made again counts as one great loss: a server that went down.
    void await_loss();
    /// A link was made, before anything was said on it.
    void connected(base::Instant now);
    void lost_place(base::Instant now);
    /// A lost place was taken again, this long after it was lost.
    void returned(base::Duration after, base::Instant now);
    std::size_t places_lost() const { return places_lost_; }
    std::size_t places_returned() const { return return_s_.size(); }
    std::uint64_t resumed_by_ring() const { return by_ring_; }
    std::uint64_t resumed_by_snapshot() const { return by_snapshot_; }
    void nonsense_sent() { ++nonsense_; }

    /// Everything but what is known of the server's process.
    nlohmann::ordered_json report() const;

  private:
    struct Sent {
        base::Instant at;
        bool is_answered = false;
    };

    bool is_measuring_ = false;
    std::unordered_map<std::uint64_t, Sent> sent_;
    std::uint64_t shots_ = 0;  ///< That at least one receiver got.
    Samples shot_to_broadcast_ms_;
    Samples without_commit_ms_;
    Samples commit_ms_;
    Samples bytes_per_shot_;
    std::map<std::string, std::uint64_t> errors_;
    Samples reconnect_s_;
    bool awaits_loss_ = false;
    std::optional<base::Instant> first_lost_;
    std::optional<base::Instant> first_connected_;  ///< After that.
    std::size_t places_lost_ = 0;
    Samples return_s_;           ///< Since the own place was lost.
    Samples return_since_up_s_;  ///< Since the first link was made again.
    std::uint64_t by_ring_ = 0;
    std::uint64_t by_snapshot_ = 0;
    std::uint64_t nonsense_ = 0;
};

}  // namespace billiards::tools
