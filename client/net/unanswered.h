// Takes what a client asks and what the server says; gives what must be asked again on a new link.
#pragma once

#include "common/model/seat.h"
#include "common/protocol/messages.h"

#include <vector>

namespace billiards::client {

/// Whether asking twice does no more than asking once, so that it may be asked again where the link
/// was lost before an answer came: a shot by its id; what names its turn and ends it or can be done
/// once in it; to concede, to claim, to leave. Not to be ready, for what will be played may have
/// been changed meanwhile; not an offer, which may have been declined; not chat; not what opens or
/// joins a table, nor practice.
bool may_be_repeated(const protocol::ClientMessageBody& request);

/// Whether `message` says what became of `request`, or shows that it is no longer worth asking.
/// `mine`: the seats of whoever asks.
bool is_answer(const protocol::ServerMessage& message, const protocol::ClientMessage& request,
               const std::vector<model::Seat>& mine);

class Unanswered {
  public:
    /// Keeps what may be repeated; of each kind the newest alone. To leave takes back all before
    /// it. Whether it was kept.
    bool sent(const protocol::ClientMessage& request);
    void received(const protocol::ServerMessage& message);

    /// In the order in which they were sent; never more than there are kinds.
    const std::vector<protocol::ClientMessage>& all() const { return requests_; }

  private:
    std::vector<protocol::ClientMessage> requests_;
    std::vector<model::Seat> mine_;
};

}  // namespace billiards::client
