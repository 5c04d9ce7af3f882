// Takes what a table's owner decides about it; gives the change to everyone there.
#include "common/base/check.h"
#include "common/match/match.h"
#include "common/protocol/codec.h"
#include "server/lobby/world.h"

#include <string>
#include <utility>

namespace billiards::server {

namespace client = protocol::client;
using protocol::RefusedCode;

/// Nobody is thrown out by it: it counts for those who come.
void Lobby::World::on(const Heard& heard, const client::ChangeTable& message) {
    Table* table = owned_table(heard, "only its owner changes a table");
    if (table == nullptr) return;
    if (const auto tried = match::start(message.settings, 0); !tried) {
        refuse(around, heard.asker(), tried.error());
        return;
    }
    const Access before = table->access();
    if (!table->access().change(message.is_private, message.passcode, around.random)) {
        refuse(around, heard.asker(), RefusedCode::Malformed, "the passcode is no text");
        return;
    }
    const auto changed = table->change_settings(heard.now, message.settings);
    if (!changed) {
        table->access() = before;
        refuse(around, heard.asker(), changed.error(), "a match is being played");
    }
    table_list.reset();
}

void Lobby::World::on(const Heard& heard, const client::MakeInvite& message) {
    Table* table = owned_table(heard, "only its owner invites to a table");
    if (table == nullptr) return;
    const bool is_for_playing = message.role != protocol::Role::Spectator;
    const auto made = table->access().invite(heard.now, is_for_playing, around.random);
    if (!made) {
        refuse(around, heard.asker(), made.error(), "invites that are not used yet: revoke them");
        return;
    }
    table->save();
    tell(heard.session.id, protocol::server::InviteMade{.table = *heard.session.table,
                                                        .is_for_playing = is_for_playing,
                                                        .secret = made->secret,
                                                        .expires_us = wire_time(made->expires)});
}

void Lobby::World::on(const Heard& heard, const client::RevokeInvites& /*message*/) {
    Table* table = owned_table(heard, "only its owner revokes invites");
    if (table == nullptr) return;
    table->access().revoke_invites();
    table->save();
}

void Lobby::World::on(const Heard& heard, const client::Kick& message) {
    Table* table = owned_table(heard, "only its owner kicks from a table");
    if (table == nullptr) return;
    Player* guest = players.find_named(message.name);
    if (guest == nullptr || !is_at(*guest, *heard.session.table)) {
        refuse(around, heard.asker(), RefusedCode::UnknownPlayer, "nobody of this name is here");
        return;
    }
    if (guest->stored.player == *heard.session.player) {
        refuse(around, heard.asker(), RefusedCode::NotAllowed, "leave the table instead");
        return;
    }
    send_away(heard, *table, *guest);
}

void Lobby::World::send_away(const Heard& heard, Table& table, Player& guest) {
    Session* session = guest.session ? session_of(*guest.session) : nullptr;
    if (session != nullptr && !session->table) session = nullptr;  // Not welcomed yet.
    base::Result<base::Done, RefusedCode> gone = base::Done{};
    if (table.seating().is_seated(guest.stored.player)) {
        gone = table.vacate(heard.now, guest.stored.player);
    } else if (session != nullptr) {
        gone = table.leave(heard.now, session->id);
    }
    if (!gone) {
        refuse(around, heard.asker(), gone.error(), "players stay until their match is over");
        return;
    }
    table.access().kick(guest.stored.player);
    table.save();
    guest.table.reset();
    table_list.reset();
    if (session == nullptr) return;
    tell(session->id, protocol::server::Notice{.code = protocol::server::NoticeCode::Kicked,
                                               .detail = "the owner has sent you away"});
    return_to_lobby(heard.now, *session);
}

/// Whoever would come back there, too, while their connection is lost.
bool Lobby::World::is_at(const Player& player, protocol::TableId id) {
    return player.table == id || table_of(id)->seating().is_seated(player.stored.player);
}

/// Refused, and none, where the one who asks is not the owner of the table there.
Table* Lobby::World::owned_table(const Heard& heard, const char* otherwise) {
    if (!may_ask_lobby(heard)) return nullptr;
    Table& table = table_at(heard);
    if (table.access().is_owner(*heard.session.player)) return &table;
    refuse(around, heard.asker(), RefusedCode::NotOwner, otherwise);
    return nullptr;
}

/// The owner has left for good: whoever still sits there has the say.
void Lobby::World::pass_on(base::Instant now, Table& table) {
    for (const model::Seat seat : model::kSeats) {
        const auto& holder = table.seating()[seat];
        if (!holder || table.access().is_owner(holder->player)) continue;
        table.access().pass_to({holder->player, holder->name});
        table.owner_changed(now);
        return;
    }
}

}  // namespace billiards::server
