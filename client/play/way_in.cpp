// Takes text; reads it as an invite, else as an address.
#include "client/play/way_in.h"

#include "client/net/invite.h"

namespace billiards::client {

std::optional<WayIn> way_in(std::string_view text, protocol::Role role) {
    if (const auto invite = parse_invite(text)) {
        return WayIn{.address = invite->address,
                     .join = protocol::client::Join{
                         .table = invite->table, .role = role, .invite = invite->secret}};
    }
    const auto address = parse_address(text);
    return address ? std::optional(WayIn{.address = *address}) : std::nullopt;
}

std::string link_of(const protocol::server::InviteMade& invite, const ServerAddress& server) {
    return to_text(Invite{.address = server, .table = invite.table, .secret = invite.secret});
}

}  // namespace billiards::client
