// Takes what a table's owner decides about it; gives the change to everyone there.
#include "server/lobby/world.h"

namespace billiards::server {

namespace client = protocol::client;
using protocol::RefusedCode;

void Lobby::World::on(const Heard& heard, const client::ChangeTable& /*message*/) {
    refuse(around, heard.asker(), RefusedCode::NotOwner, "only its owner changes a table");
}

void Lobby::World::on(const Heard& heard, const client::MakeInvite& /*message*/) {
    refuse(around, heard.asker(), RefusedCode::NotOwner, "only its owner invites to a table");
}

void Lobby::World::on(const Heard& heard, const client::RevokeInvites& /*message*/) {
    refuse(around, heard.asker(), RefusedCode::NotOwner, "only its owner revokes invites");
}

void Lobby::World::on(const Heard& heard, const client::Kick& /*message*/) {
    refuse(around, heard.asker(), RefusedCode::NotOwner, "only its owner kicks from a table");
}

}  // namespace billiards::server
