// Takes what the game sends within one call; gives it to the network in one piece.
#include "server/net/batched_outbox.h"

#include "common/base/check.h"

#include <asio/post.hpp>
#include <utility>

namespace billiards::server {
namespace {

Outgoing::Kind kind_of(Delivery delivery) {
    switch (delivery) {
        case Delivery::Ordered:
            return Outgoing::Kind::Ordered;
        case Delivery::LatestWins:
            return Outgoing::Kind::LatestWins;
        case Delivery::Sheddable:
            return Outgoing::Kind::Sheddable;
        case Delivery::Fresh:
            return Outgoing::Kind::Fresh;
    }
    CHECK(false);
    return Outgoing::Kind::Ordered;
}

}  // namespace

void BatchedOutbox::deliver(SessionId to, const protocol::SharedFrame& frame, Delivery delivery) {
    batch_.push_back({to, kind_of(delivery), frame});
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
