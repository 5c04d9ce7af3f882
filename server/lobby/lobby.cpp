// Takes calls from the network's side; hands them to the world, if they are about someone known.
#include "server/lobby/lobby.h"

#include "server/lobby/world.h"

#include <utility>

namespace billiards::server {

Lobby::Lobby(const LobbyLimits& limits, Outbox& outbox, Committer& committer, Archive& archive,
             RandomBytes random)
    : world_(std::make_unique<World>(limits, outbox, committer, archive, std::move(random))) {}

Lobby::~Lobby() = default;

std::vector<std::string> Lobby::restore(base::Instant now, const StoredWorld& stored) {
    world_->last_player = stored.highest.player;
    world_->last_table = stored.highest.table;
    world_->around.last_match = stored.highest.match;
    for (const StoredPlayer& player : stored.players) world_->players.add(player);
    std::vector<std::string> left_alone;
    for (const StoredTable& table : stored.tables) {
        const auto restored = world_->restore(now, stored, table);
        if (!restored) left_alone.push_back(restored.error());
    }
    return left_alone;
}

void Lobby::connected(base::Instant now, SessionId session, AddressKey from) {
    world_->connect(now, session, from);
}

void Lobby::received(base::Instant now, SessionId session, const protocol::ClientMessage& message) {
    if (Session* known = world_->session_of(session)) world_->receive(now, *known, message);
}

void Lobby::malformed(base::Instant now, SessionId session, const std::string& detail) {
    Session* known = world_->session_of(session);
    if (known == nullptr) return;
    world_->refuse_illegal(now, *known, 0, protocol::RefusedCode::Malformed, detail);
}

/// Whoever has left the table meanwhile is up to date: elsewhere nothing is shed.
void Lobby::fell_behind(base::Instant now, SessionId session) {
    const Session* known = world_->session_of(session);
    if (known == nullptr || !known->table) return;
    world_->table_of(*known->table)->refresh(now, session);
}

void Lobby::disconnected(base::Instant now, SessionId session) {
    if (Session* known = world_->session_of(session)) world_->forget(now, *known);
}

std::optional<base::Instant> Lobby::next_deadline() const {
    if (world_->are_saves_due()) return base::Instant{};  // At once.
    std::optional<base::Instant> next = world_->session_deadlines.next();
    for (const auto other : {world_->table_deadlines.next(), world_->next_errand()}) {
        if (other && (!next || *other < *next)) next = other;
    }
    return next;
}

void Lobby::advance_time(base::Instant now) {
    if (world_->are_saves_due()) world_->save_what_failed();
    for (const SessionId session : world_->session_deadlines.take_due(now)) {
        if (Session* known = world_->session_of(session)) world_->expire(now, *known);
    }
    for (const protocol::TableId table : world_->table_deadlines.take_due(now)) {
        if (Table* known = world_->table_of(table)) world_->advance(now, *known, table);
    }
    world_->run_errands(now);
}

void Lobby::shut_down(base::Instant /*now*/) {
    world_->is_closing = true;
    world_->announce(
        {.code = protocol::server::NoticeCode::ShuttingDown, .detail = "the server is going down"});
}

LobbyStats Lobby::stats() const {
    LobbyStats stats = world_->around.stats;
    stats.sessions = world_->sessions.size();
    stats.tables = world_->tables.size();
    for (const auto& [id, table] : world_->tables) {
        if (table.is_playing()) ++stats.matches_running;
    }
    return stats;
}

}  // namespace billiards::server
