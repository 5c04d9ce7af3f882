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

void Lobby::World::on(const Heard& heard, const client::Choose& message) {
    ask(heard, {.command = match::Choose{message.turn, message.choice}});
}

void Lobby::World::on(const Heard& heard, const client::Concede& /*message*/) {
    ask(heard, {.command = match::Concede{}});
}

void Lobby::World::on(const Heard& heard, const client::ClaimMatch& /*message*/) {
    table_at(heard).claim(heard.now, heard.asker());
}

void Lobby::World::on(const Heard& heard, const client::Extend& message) {
    ask(heard, {.command = match::Extend{message.turn}});
}

void Lobby::World::on(const Heard& heard, const client::Offer& message) {
    ask(heard, {.command = match::Offer{message.turn, message.kind}});
}

void Lobby::World::on(const Heard& heard, const client::Answer& message) {
    ask(heard, {.command = match::Answer{message.turn, message.accept}});
}

void Lobby::World::on(const Heard& heard, const client::ClaimStalemate& message) {
    ask(heard, {.command = match::ClaimStalemate{message.turn}});
}

void Lobby::World::on(const Heard& heard, const client::SpotNearest& message) {
    ask(heard, {.command = match::SpotNearest{message.turn}});
}

void Lobby::World::on(const Heard& heard, const client::PlaceBall& message) {
    ask(heard, {.command = match::PlaceBall{message.ball, message.position_m}});
}

void Lobby::World::on(const Heard& heard, const client::Undo& /*message*/) {
    ask(heard, {.command = match::Undo{}});
}

void Lobby::World::on(const Heard& heard, const client::Repeat& /*message*/) {
    ask(heard, {.command = match::Repeat{}});
}

void Lobby::World::on(const Heard& heard, const client::Rerack& /*message*/) {
    ask(heard, {.command = match::Rerack{}});
}

}  // namespace billiards::server
