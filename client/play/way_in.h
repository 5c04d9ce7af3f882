// Takes what somebody typed or was sent to come somewhere; gives the server, and the table there.
#pragma once

#include "client/net/address.h"
#include "common/protocol/messages.h"

#include <optional>
#include <string>
#include <string_view>

namespace billiards::client {

struct WayIn {
    ServerAddress address;
    std::optional<protocol::client::Join> join{};  ///< By an invite; none: to look around.

    friend bool operator==(const WayIn&, const WayIn&) = default;
};

/// An address, or an invite. None where it is neither.
std::optional<WayIn> way_in(std::string_view text, protocol::Role role);

/// The link to be sent to whoever shall come to the table, at a server that they reach there.
std::string link_of(const protocol::server::InviteMade& invite, const ServerAddress& server);

}  // namespace billiards::client
