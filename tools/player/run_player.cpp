// Takes events from a link and moments from the clock; gives both to the player, in turn.
#include "tools/player/run_player.h"

#include "client/net/clock.h"

#include <algorithm>
#include <utility>
#include <variant>

namespace billiards::tools {

namespace {

/// The longest that a stop goes unnoticed.
constexpr base::Duration kLongestWait = std::chrono::milliseconds(200);

base::Duration time_to_wait(const HeadlessPlayer& player) {
    const std::optional<base::Instant> next = player.next_deadline();
    if (!next) return kLongestWait;
    return std::clamp(*next - client::local_now(), base::Duration::zero(), kLongestWait);
}

}  // namespace

PlayedOut run_player(client::ServerLinkOptions link_options, PlayerOptions options,
                     PlayerEvents events,
                     const std::function<void(const client::LinkLost&)>& link_lost,
                     const std::stop_token& stop) {
    client::ServerLink link(std::move(link_options));
    HeadlessPlayer player(
        std::move(options), std::move(events),
        [&link](protocol::ClientMessageBody body) { return link.send(std::move(body)); });
    std::string failure;
    while (!player.is_finished() && failure.empty()) {
        if (stop.stop_requested()) failure = "stopped";
        const std::optional<client::LinkEvent> event = link.wait_for(time_to_wait(player));
        if (event) {
            if (const auto* arrived = std::get_if<client::Arrived>(&*event)) {
                player.received(arrived->message, arrived->at);
            } else if (const auto* lost = std::get_if<client::LinkLost>(&*event)) {
                player.link_lost();
                if (link_lost) link_lost(*lost);
                if (!lost->retry_after) failure = lost->lost.reason;
            }
        }
        player.advance_time(client::local_now());
    }
    if (!player.failure().empty()) failure = player.failure();
    return {.failure = std::move(failure),
            .name = player.state().name,
            .digest = player.digest(),
            .table = player.state().table};
}

}  // namespace billiards::tools
