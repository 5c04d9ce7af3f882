// Takes what the game sends within one call; gives it to the network in one piece.
#include "server/net/batched_outbox.h"

#include <asio/post.hpp>
#include <utility>

namespace billiards::server {

void BatchedOutbox::deliver(SessionId to, const protocol::SharedFrame& frame, Delivery delivery) {
    const bool latest_wins = delivery == Delivery::LatestWins;
    batch_.push_back(
        {to, latest_wins ? Outgoing::Kind::LatestWins : Outgoing::Kind::Ordered, frame});
}

void BatchedOutbox::close(SessionId session) {
    batch_.push_back({session, Outgoing::Kind::Close, nullptr});
}

void BatchedOutbox::handled(SessionId session) {
    batch_.push_back({session, Outgoing::Kind::Handled, nullptr});
}

void BatchedOutbox::flush() {
    if (batch_.empty()) return;
    asio::post(network_context_,
               [this, batch = std::exchange(batch_, {})] { network_.carry_out(batch); });
}

}  // namespace billiards::server
