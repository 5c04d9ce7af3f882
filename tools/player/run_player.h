// Takes a server's address and a player; plays on a real connection until it is finished.
#pragma once

#include "client/net/server_link.h"
#include "tools/player/headless_player.h"

#include <functional>
#include <stop_token>
#include <string>

namespace billiards::tools {

struct PlayedOut {
    std::string failure;  ///< Empty: the match was played to its end.
    std::string name;     ///< As the server gave it.
    MatchDigest digest;
    std::optional<client::TableView> table;  ///< As it was at the end.
};

/// Blocks. `link_lost` is told of each lost link, the final one included; it may be empty. A stop
/// counts as a failure.
PlayedOut run_player(client::ServerLinkOptions link, PlayerOptions player, PlayerEvents events,
                     const std::function<void(const client::LinkLost&)>& link_lost,
                     const std::stop_token& stop = {});

}  // namespace billiards::tools
