// Takes who wants to sit or stand where; opens tables, lets people in, and out again.
#include "common/base/check.h"
#include "common/match/match.h"
#include "common/protocol/limits.h"
#include "common/protocol/text.h"
#include "server/lobby/world.h"

#include <algorithm>
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
        case RefusedCode::UnknownTable:
            return "there is no such table";
        case RefusedCode::WrongSecret:
            return "this table needs an invite or its passcode";
        case RefusedCode::TooMany:
            return "wrong invites and passcodes at this table: try again in a minute";
        case RefusedCode::NotAllowed:
            return "the owner has sent you away from this table";
        default:
            return {};
    }
}

/// Whether the two play the same; when spectators see it is another matter.
bool are_alike(match::Settings a, const match::Settings& b) {
    a.spectator_delay_s = b.spectator_delay_s;
    return a == b;
}

bool is_one_waiting(const Seating& seating) {
    return std::count_if(model::kSeats.begin(), model::kSeats.end(),
                         [&](model::Seat seat) { return seating[seat].has_value(); }) == 1 &&
           seating.is_anyone_connected();
}

}  // namespace

void Lobby::World::on(const Heard& heard, const client::CreateTable& message) {
    if (refuse_while_closing(heard) || !may_ask_lobby(heard)) return;
    const auto name = protocol::clean_text(message.name, protocol::kMaxTableNameLength);
    if (!name) {
        refuse(around, heard.asker(), RefusedCode::BadName,
               "the table's name is too long or no text");
        return;
    }
    const StoredPlayer& player = player_at(heard).stored;
    Access access(around.limits, {player.player, player.name});
    if (!access.change(message.is_private, message.passcode, around.random)) {
        refuse(around, heard.asker(), RefusedCode::Malformed, "the passcode is no text");
        return;
    }
    open_table(heard, name->empty() ? player.name : *name, message.settings, std::move(access),
               message.role);
}

void Lobby::World::open_table(const Heard& heard, const std::string& name,
                              const match::Settings& settings, Access access, protocol::Role role) {
    const auto tried = match::start(settings, 0);
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
    if (opened_tables.count(heard.session.from) >= around.limits.tables_per_address) {
        refuse(around, heard.asker(), RefusedCode::TooMany, "tables opened from your address");
        return;
    }
    const protocol::TableId id{++last_table};
    tables.try_emplace(id, id, name, settings, std::move(access), around, heard.now);
    opened_tables.add(id, heard.session.from);
    player.opened = id;
    take_place(heard, id, role, {});
}

void Lobby::World::on(const Heard& heard, const client::Join& message) {
    if (!may_ask_lobby(heard)) return;
    if (table_of(message.table) == nullptr) {
        refuse(around, heard.asker(), RefusedCode::UnknownTable,
               detail_of(RefusedCode::UnknownTable));
        return;
    }
    take_place(heard, message.table, message.role,
               {.invite = message.invite, .passcode = message.passcode});
}

void Lobby::World::on(const Heard& heard, const client::QuickMatch& message) {
    if (refuse_while_closing(heard) || !may_ask_lobby(heard)) return;
    match::Settings settings;
    settings.game = message.game;
    if (const auto waiting = waiting_table(settings, *heard.session.player)) {
        take_place(heard, *waiting, protocol::Role::Player, {});
        return;
    }
    const StoredPlayer& player = player_at(heard).stored;
    open_table(heard, player.name, settings, Access(around.limits, {player.player, player.name}),
               protocol::Role::Player);
}

/// The oldest public table at which one player who is there waits for another.
std::optional<protocol::TableId> Lobby::World::waiting_table(const match::Settings& settings,
                                                             PlayerId asker) const {
    for (const auto& [id, table] : tables) {
        if (table.access().is_private() || table.access().is_kicked(asker)) continue;
        if (table.is_playing() || table.seating().is_seated(asker)) continue;
        if (!is_one_waiting(table.seating()) || !are_alike(table.settings(), settings)) continue;
        return id;
    }
    return std::nullopt;
}

void Lobby::World::take_place(const Heard& heard, protocol::TableId id, protocol::Role role,
                              const Shown& shown) {
    Player& player = player_at(heard);
    Table& table = *table_of(id);
    const auto admitted = table.access().admits(heard.now, player.stored.player, role, shown);
    if (!admitted) {
        refuse(around, heard.asker(), admitted.error(), detail_of(admitted.error()));
        return;
    }
    const auto joined = table.join(
        heard.now, {heard.session.id, player.stored.player, player.stored.name}, role, *admitted);
    if (!joined) {
        refuse(around, heard.asker(), joined.error(), detail_of(joined.error()));
        return;
    }
    player.table = id;
    heard.session.table = id;
    heard.session.phase =
        table.seating().seats_of(heard.session.id).empty() ? Phase::Watching : Phase::Seated;
    feed.unfollow(heard.session.id);
    table_list.reset();
}

void Lobby::World::on(const Heard& heard, const client::Leave& /*message*/) {
    if (!may_ask_lobby(heard)) return;
    const protocol::TableId id = *heard.session.table;
    Table& table = table_at(heard);
    const auto left = table.leave(heard.now, heard.session.id);
    if (!left) {
        refuse(around, heard.asker(), left.error(), detail_of(left.error()));
        return;
    }
    if (table.access().is_owner(*heard.session.player)) pass_on(heard.now, table);
    player_at(heard).table.reset();
    refresh_deadline(id);
    table_list.reset();
    return_to_lobby(heard.now, heard.session);
}

void Lobby::World::return_to_lobby(base::Instant now, Session& session) {
    session.table.reset();
    session.phase = Phase::Lobby;
    send_tables(now, session.id);
}

/// Who opens another table has no use for an empty one left behind; so nobody can fill the server
/// with them.
void Lobby::World::close_idle_table_of(Player& player) {
    if (!player.opened) return;
    const Table* table = table_of(*player.opened);
    if (table != nullptr && table->is_idle() && table->access().is_owner(player.stored.player)) {
        close_table(*player.opened);
    }
    player.opened.reset();
}

}  // namespace billiards::server
