// Takes options; runs a player or spectator on this thread and reports to standard output.
#include "tools/demo/role.h"

#include "common/base/elementary.h"
#include "common/bot/choose.h"
#include "tools/demo/report.h"
#include "tools/demo/token_file.h"
#include "tools/player/run_player.h"
#include "tools/player/unsteady.h"

#include <iostream>
#include <utility>

namespace billiards::tools {

namespace {

PlayerOptions player_options(const RoleOptions& options) {
    PlayerOptions player{.role = options.role,
                         .table = options.table,
                         .table_name = options.table_name,
                         .settings = {},
                         .seed = options.seed,
                         .min_think = base::duration_of(options.min_think_s),
                         .max_think = base::duration_of(options.max_think_s),
                         .watches_balls_roll = options.watches_balls_roll,
                         .aim_every = std::nullopt,
                         .plays_again = false,
                         .choose = unsteady(bot::choose, base::radians(options.unsteady_deg))};
    player.settings.race_to = options.race_to;
    player.settings.shot_clock_s = options.shot_clock_s;
    return player;
}

}  // namespace

int play_role(const RoleOptions& options) {
    Report report(std::cout, options.json);
    PlayerEvents events = report.events();
    client::ServerLinkOptions link{.address = options.server,
                                   .name = options.name,
                                   .token = std::nullopt,
                                   .seed = options.seed,
                                   .limits = {},
                                   .reconnect = {}};
    if (!options.token_file.empty()) {
        link.token = read_token(options.token_file);
        events.welcome = [&](const protocol::server::Welcome& welcome) {
            write_token(options.token_file, welcome.token);
        };
    }
    const PlayedOut played =
        run_player(std::move(link), player_options(options), std::move(events),
                   [&report](const client::LinkLost& lost) { report.link_lost(lost); });
    report.result(played);
    return played.failure.empty() ? 0 : 1;
}

}  // namespace billiards::tools
