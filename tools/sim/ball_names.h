// Takes the names that a case gives its balls; gives the engine's ids, and back.
#pragma once

#include "common/model/ball.h"

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace billiards::tools {

/// "cue" is ball 0 and "1" to "21" are themselves; any other name takes the lowest number that is
/// left, the cue ball's last.
class BallNames {
  public:
    /// At most model::kMaxBalls different names.
    explicit BallNames(const std::vector<std::string>& names);

    /// The names must hold it.
    model::BallId id_of(const std::string& name) const;
    const std::string& name_of(model::BallId ball) const;
    /// The engine's "ball 3" in a sentence, in the case's own names.
    std::string translated(const std::string& sentence) const;

  private:
    std::array<std::optional<std::string>, model::kMaxBalls> names_;
};

}  // namespace billiards::tools
