// Takes what a known player says that needs no more than an answer; gives that, within limits.
#include "common/base/check.h"
#include "common/protocol/limits.h"
#include "common/protocol/text.h"
#include "server/lobby/world.h"

namespace billiards::server {

namespace client = protocol::client;
using protocol::RefusedCode;

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
