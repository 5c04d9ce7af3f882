// Takes a game; gives the sentences of the information box: what happened, and what follows.
#pragma once

#include "client/play/game.h"
#include "common/base/time.h"

#include <optional>
#include <string>
#include <vector>

namespace billiards::client {

/// What happened, the oldest first, and last what follows now: whose turn it is, with which group,
/// and what is to be done.
std::vector<std::string> information(const Game& game);

/// The last of them alone.
std::string what_follows(const Game& game);

/// Whole seconds left to whoever is to act; none where no clock runs.
std::optional<int> seconds_left(const Game& game, base::Instant now);

}  // namespace billiards::client
