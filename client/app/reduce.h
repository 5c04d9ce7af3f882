// Takes what a client knows and a message; gives what it knows then.
#pragma once

#include "client/app/client_state.h"
#include "common/base/time.h"
#include "common/protocol/messages.h"

namespace billiards::client {

/// Pure. local_now is the client's own clock when the message was read.
ClientState reduce(ClientState state, const protocol::ServerMessage& message,
                   base::Instant local_now);

}  // namespace billiards::client
