// Takes Hello; gives Welcome, once the player and the new token are durable.
#include "common/base/check.h"
#include "common/protocol/limits.h"
#include "common/protocol/text.h"
#include "server/lobby/world.h"
#include "server/session/token.h"

#include <array>
#include <optional>
#include <string>
#include <utility>

namespace billiards::server {

using protocol::RefusedCode;

namespace {

std::uint16_t draw(const RandomBytes& random) {
    std::array<std::uint8_t, 2> bytes{};
    random(bytes);
    return static_cast<std::uint16_t>(bytes[0] * 256U + bytes[1]);
}

/// Who watched while everyone could needs a secret like anybody else once the table is private.
bool may_come_back(const Table& table, const Player& player) {
    const PlayerId id = player.stored.player;
    if (table.access().is_kicked(id) || !table.has_place_for(id)) return false;
    const bool door_was_closed = table.access().is_private() && player.left_open_door;
    return table.seating().is_seated(id) || !door_was_closed;
}

}  // namespace

void Lobby::World::on(const Heard& heard, const protocol::client::Hello& hello) {
    if (refuse_while_closing(heard)) return;
    if (hello.token) {
        resume(heard, *hello.token, hello.followed);
    } else {
        enrol(heard, hello.name);
    }
}

void Lobby::World::enrol(const Heard& heard, const std::string& name) {
    const auto clean = protocol::clean_text(name, protocol::kMaxNameLength);
    if (!clean || clean->empty()) {
        refuse(around, heard.asker(), RefusedCode::BadName,
               "the name is empty, too long or no text");
        return;
    }
    if (players.size() >= static_cast<std::size_t>(around.limits.max_players)) {
        refuse(around, heard.asker(), RefusedCode::TooMany, "players known to this server");
        return;
    }
    auto shown = players.free_name(*clean, draw(around.random));
    if (!shown) {
        refuse(around, heard.asker(), RefusedCode::BadName, "too many players have this name");
        return;
    }
    const protocol::ResumeToken token = new_token(around.random);
    Player& player = players.add(
        {.player = {++last_player}, .name = std::move(*shown), .token_hash = hash_of(token)});
    enter(heard, player, {.token = token, .followed = {}, .is_new = true});
}

/// Any wrong token counts, so that they cannot be tried out.
void Lobby::World::resume(const Heard& heard, const protocol::ResumeToken& used,
                          const std::optional<protocol::client::Followed>& followed) {
    const TokenHash used_hash = hash_of(used);
    Player* player = players.find(used_hash);
    if (player == nullptr) {
        refuse_illegal(heard.now, heard.session, heard.request_id, RefusedCode::UnknownToken,
                       "no player has this token");
        return;
    }
    if (player->session) {
        Session* replaced = session_of(*player->session);
        CHECK(replaced != nullptr);
        tell(replaced->id,
             protocol::server::Notice{.code = protocol::server::NoticeCode::ReplacedByNewConnection,
                                      .detail = "the player came back on another connection"});
        close(heard.now, *replaced);
    }
    const protocol::ResumeToken fresh = new_token(around.random);
    players.rotate(*player, used_hash, hash_of(fresh));
    enter(heard, *player, {.token = fresh, .followed = followed, .is_new = false});
}

void Lobby::World::enter(const Heard& heard, Player& player, Entering entering) {
    heard.session.phase = Phase::Entering;
    heard.session.heard = heard.now;
    heard.session.player = player.stored.player;
    player.session = heard.session.id;
    entering.asker = heard.asker();
    entering.player = player.stored.player;
    around.committer.submit({SavePlayer{player.stored}},
                            [this, entering, submitted = heard.now](const Committed& committed) {
                                around.stats.storage_failing = !committed.result.ok();
                                settle(submitted + committed.took, entering, committed.result.ok());
                            });
}

/// The session may be gone by now, and the player with another one.
void Lobby::World::settle(base::Instant now, const Entering& entering, bool durable) {
    Player* player = players.find(entering.player);
    CHECK(player != nullptr);
    const bool is_here = player->session == entering.asker.session;
    if (is_here && durable) {
        welcome(now, *session_of(entering.asker.session), *player, entering);
        return;
    }
    if (is_here) {
        Session& session = *session_of(entering.asker.session);
        session.phase = Phase::Greeting;
        session.player.reset();
        player->session.reset();
        refuse(around, entering.asker, RefusedCode::StorageFailed,
               "the player could not be stored");
    }
    if (entering.is_new) players.remove(entering.player);  // Nobody was told its token.
}

void Lobby::World::welcome(base::Instant now, Session& session, Player& player,
                           const Entering& entering) {
    Table* table = player.table ? table_of(*player.table) : nullptr;
    if (table != nullptr && !may_come_back(*table, player)) table = nullptr;
    if (table == nullptr) player.table.reset();
    tell(session.id, protocol::server::Welcome{.name = player.stored.name,
                                               .token = entering.token,
                                               .server_time_us = wire_time(now),
                                               .table = player.table});
    session.phase = Phase::Lobby;
    if (table == nullptr) return;
    session.table = player.table;
    session.phase =
        table->seating().is_seated(player.stored.player) ? Phase::Seated : Phase::Watching;
    table->come_back(now, {session.id, player.stored.player, player.stored.name},
                     entering.followed);
    refresh_deadline(*session.table);
}

/// The first message after Welcome says that the new token arrived: the previous one dies.
void Lobby::World::confirm_token(Session& session) {
    if (session.phase <= Phase::Entering) return;
    Player* player = players.find(*session.player);
    if (!players.confirm(*player)) return;
    around.committer.submit({SavePlayer{player->stored}}, [this](const Committed& committed) {
        around.stats.storage_failing = !committed.result.ok();
    });
}

}  // namespace billiards::server
