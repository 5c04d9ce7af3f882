// Takes the shots of a match as one receiver got them; gives 64 bits that agree between all who
// got the same.
#pragma once

#include "common/base/hash.h"
#include "common/protocol/messages.h"

#include <cstdint>

namespace billiards::tools {

/// The hash of one shot's consequences: its record's hash, every bit of where the balls lie then,
/// and the score.
std::uint64_t digest_of(const protocol::server::ShotPlayed& shot);

class MatchDigest {
  public:
    /// False, and nothing added, for a shot that was added before: an answer may come twice.
    bool add(const protocol::server::ShotPlayed& shot);
    void add(const protocol::server::MatchOver& over);

    std::uint64_t value() const { return hasher_.digest(); }
    int shots() const { return shots_; }
    /// Shots that were played and never got here: while it is not 0, the digest says nothing.
    int missed() const { return missed_; }

  private:
    base::Hasher hasher_;
    int shots_ = 0;
    int missed_ = 0;
};

}  // namespace billiards::tools
