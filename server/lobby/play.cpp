// Takes what a seated player says; hands it to the player's table, as commands where the match is
// what it is about.
#include "server/lobby/world.h"

#include <utility>

namespace billiards::server {

namespace client = protocol::client;
using protocol::RefusedCode;

void Lobby::World::ask(const Heard& heard, Table::Command command) {
    table_at(heard).request(heard.now, heard.asker(), std::move(command));
}

void Lobby::World::on(const Heard& heard, const client::Ready& /*message*/) {
    if (refuse_while_closing(heard)) return;
    table_at(heard).ready(heard.now, heard.asker());
}

void Lobby::World::on(const Heard& heard, const client::Rematch& /*message*/) {
    if (refuse_while_closing(heard)) return;
    table_at(heard).rematch(heard.now, heard.asker());
}

void Lobby::World::on(const Heard& heard, const match::Command& command) {
    ask(heard, {.command = command});
}

void Lobby::World::on(const Heard& heard, const client::PlaceCueBall& message) {
    ask(heard, {.command = match::PlaceCueBall{message.position_m}, .only_turn = message.turn});
}

void Lobby::World::on(const Heard& heard, const client::Aim& message) {
    table_at(heard).aim(heard.now, heard.session.id, message);
}

void Lobby::World::on(const Heard& heard, const client::TakeShot& message) {
    if (!heard.session.unsolvable.has_room(heard.now)) {
        refuse(around, heard.asker(), RefusedCode::TooMany, "shots that nobody can solve");
        return;
    }
    ask(heard, {.command = match::TakeShot{message.turn, message.shot, message.call},
                .shot_id = message.shot_id});
}

void Lobby::World::on(const Heard& heard, const client::Seen& message) {
    table_at(heard).seen(heard.now, heard.session.id, message.sequence);
}

void Lobby::World::on(const Heard& heard, const client::ClaimMatch& /*message*/) {
    table_at(heard).claim(heard.now, heard.asker());
}

}  // namespace billiards::server
