// Takes what a known player says; gives the lobby's answers, or hands it to the player's table.
#include "common/base/check.h"
#include "common/match/match.h"
#include "common/protocol/codec.h"
#include "common/protocol/limits.h"
#include "common/protocol/text.h"
#include "server/lobby/world.h"

#include <iterator>
#include <string>
#include <utility>

namespace billiards::server {

namespace client = protocol::client;
using protocol::RefusedCode;

namespace {

std::string detail_of(RefusedCode code) {
    switch (code) {
        case RefusedCode::SeatTaken:
            return "no such seat is free";
        case RefusedCode::TableFull:
            return "no room for another spectator";
        case RefusedCode::MatchRunning:
            return "a match is being played: concede it first";
        default:
            return {};
    }
}

}  // namespace

void Lobby::World::on(const Heard& heard, const client::ListTables& /*message*/) {
    if (may_ask_lobby(heard)) send_tables(heard.now, heard.session.id);
}

void Lobby::World::on(const Heard& heard, const client::CreateTable& message) {
    if (refuse_while_closing(heard) || !may_ask_lobby(heard)) return;
    const auto name = protocol::clean_text(message.name, protocol::kMaxTableNameLength);
    if (!name) {
        refuse(around, heard.asker(), RefusedCode::BadName,
               "the table's name is too long or no text");
        return;
    }
    const auto tried = match::start(message.settings, 0);
    if (!tried) {
        refuse(around, heard.asker(), tried.error());
        return;
    }
    Player& player = player_at(heard);
    close_idle_table_of(player);
    if (tables.size() >= static_cast<std::size_t>(around.limits.max_tables)) {
        refuse(around, heard.asker(), RefusedCode::TooMany, "tables on this server");
        return;
    }
    const protocol::TableId id{++last_table};
    tables.try_emplace(id, id, name->empty() ? player.stored.name : *name, message.settings,
                       Access(around.limits, {player.stored.player, player.stored.name}), around,
                       heard.now);
    player.opened = id;
    take_place(heard, id, message.role);
}

void Lobby::World::on(const Heard& heard, const client::Join& message) {
    if (!may_ask_lobby(heard)) return;
    if (table_of(message.table) == nullptr) {
        refuse(around, heard.asker(), RefusedCode::UnknownTable, "there is no such table");
        return;
    }
    take_place(heard, message.table, message.role);
}

void Lobby::World::on(const Heard& heard, const client::Leave& /*message*/) {
    if (!may_ask_lobby(heard)) return;
    const protocol::TableId id = *heard.session.table;
    const auto left = table_at(heard).leave(heard.now, heard.session.id);
    if (!left) {
        refuse(around, heard.asker(), left.error(), detail_of(left.error()));
        return;
    }
    heard.session.table.reset();
    heard.session.phase = Phase::Lobby;
    player_at(heard).table.reset();
    refresh_deadline(id);
    table_list.reset();
    send_tables(heard.now, heard.session.id);
}

void Lobby::World::on(const Heard& heard, const client::Chat& message) {
    if (!heard.session.chat.allows(heard.now)) {
        refuse(around, heard.asker(), RefusedCode::TooMany, "chat");
        return;
    }
    const auto text = protocol::clean_text(message.text, protocol::kMaxChatLength);
    if (!text || text->empty()) {
        refuse(around, heard.asker(), RefusedCode::Malformed, "chat: empty, too long or no text");
        return;
    }
    table_at(heard).say(heard.now, heard.asker(), player_at(heard).stored.name, *text);
}

void Lobby::World::on(const Heard& heard, const client::Ping& message) {
    tell(heard.session.id, protocol::server::Pong{.client_time_us = message.client_time_us,
                                                  .server_time_us = wire_time(heard.now)});
}

void Lobby::World::on(const Heard& heard, const client::FollowTables& /*message*/) {
    if (may_ask_lobby(heard)) send_tables(heard.now, heard.session.id);
}

void Lobby::World::on(const Heard& heard, const client::QuickMatch& message) {
    match::Settings settings;
    settings.game = message.game;
    on(heard,
       client::CreateTable{.name = {}, .settings = settings, .role = protocol::Role::Player});
}

void Lobby::World::on(const Heard& heard, const client::AskHistory& /*message*/) {
    refuse(around, heard.asker(), RefusedCode::Busy, "no archive yet");
}

void Lobby::World::on(const Heard& heard, const client::AskRecord& /*message*/) {
    refuse(around, heard.asker(), RefusedCode::Busy, "no archive yet");
}

void Lobby::World::on(const Heard& heard, const client::AskReplay& /*message*/) {
    refuse(around, heard.asker(), RefusedCode::Busy, "no archive yet");
}

bool Lobby::World::may_ask_lobby(const Heard& heard) {
    if (heard.session.lobby_requests.allows(heard.now)) return true;
    refuse(around, heard.asker(), RefusedCode::TooMany, "requests to the lobby");
    return false;
}

bool Lobby::World::refuse_while_closing(const Heard& heard) {
    if (!is_closing) return false;
    refuse(around, heard.asker(), RefusedCode::ShuttingDown, "nothing new starts");
    return true;
}

void Lobby::World::take_place(const Heard& heard, protocol::TableId id, protocol::Role role) {
    Player& player = player_at(heard);
    const auto joined = table_of(id)->join(
        heard.now, {heard.session.id, player.stored.player, player.stored.name}, role);
    if (!joined) {
        refuse(around, heard.asker(), joined.error(), detail_of(joined.error()));
        return;
    }
    player.table = id;
    heard.session.table = id;
    heard.session.phase = role == protocol::Role::Spectator ? Phase::Watching : Phase::Seated;
    table_list.reset();
}

/// Who opens another table has no use for an empty one left behind; so nobody can fill the server
/// with them.
void Lobby::World::close_idle_table_of(Player& player) {
    if (!player.opened) return;
    const Table* table = table_of(*player.opened);
    if (table != nullptr && table->is_idle()) close_table(*player.opened);
    player.opened.reset();
}

/// The newest come first, and the oldest are left out where there are too many.
void Lobby::World::send_tables(base::Instant now, SessionId to) {
    if (!table_list || now - table_list->made > around.limits.table_list_kept) {
        protocol::server::TableList list;
        for (auto table = tables.rbegin();
             table != tables.rend() && list.tables.size() < protocol::kMaxTableRows; ++table) {
            list.tables.push_back(table->second.row());
        }
        table_list = TableListFrame{protocol::encode(std::move(list)), now};
    }
    around.outbox.deliver(to, table_list->frame, Delivery::Ordered);
}

Table& Lobby::World::table_at(const Heard& heard) {
    CHECK(heard.session.table.has_value());
    Table* table = table_of(*heard.session.table);
    CHECK(table != nullptr);
    return *table;
}

Player& Lobby::World::player_at(const Heard& heard) {
    Player* player = players.find(*heard.session.player);
    CHECK(player != nullptr);
    return *player;
}

}  // namespace billiards::server
