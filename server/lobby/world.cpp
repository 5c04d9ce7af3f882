// Takes connections, their messages and the time; keeps who is here and lets the tables go on.
#include "server/lobby/world.h"

#include "common/base/check.h"
#include "common/protocol/codec.h"
#include "server/session/phase.h"

#include <algorithm>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace billiards::server {

using protocol::RefusedCode;

Lobby::World::World(const LobbyLimits& limits, Outbox& outbox, Committer& committer, Archive& asked,
                    RandomBytes random)
    : around{.limits = limits,
             .outbox = outbox,
             .committer = committer,
             .random = std::move(random),
             .moved = [this](protocol::TableId table) { refresh_deadline(table); },
             .unsolvable = [this](SessionId session) { count_unsolvable(session); }},
      archive(asked),
      feed(limits.table_changes_every) {}

void Lobby::World::connect(base::Instant now, SessionId id, AddressKey from) {
    if (is_closing) {
        tell(id, protocol::server::Notice{.code = protocol::server::NoticeCode::ShuttingDown,
                                          .detail = "the server is going down"});
        around.outbox.close(id);
        return;
    }
    const auto [place, added] = sessions.try_emplace(id, id, from, now, around.limits);
    CHECK(added);
    session_deadlines.set(id, place->second.expires());
}

void Lobby::World::receive(base::Instant now, Session& session,
                           const protocol::ClientMessage& message) {
    if (!around.stats.storage_failing) probed = now;
    if (session.phase != Phase::Greeting) session.heard = now;
    // However late the loop's timer is: a shot after the turn has opened is not too early.
    if (session.table) table_of(*session.table)->advance(now);
    if (!is_legal(session.phase, message.body)) {
        refuse_illegal(now, session, message.request_id, RefusedCode::NotInThisPhase,
                       std::string(name_of(message.body)) + " has no place in phase " +
                           std::string(name_of(session.phase)));
        return;
    }
    confirm_token(session);
    const SessionId id = session.id;
    const Heard heard{now, session, message.request_id};
    std::visit([&](const auto& body) { on(heard, body); }, message.body);
    const Session* still = session_of(id);  // A handler may have closed it.
    if (still != nullptr && still->table) refresh_deadline(*still->table);
}

void Lobby::World::refuse_illegal(base::Instant now, Session& session, std::uint32_t request_id,
                                  RefusedCode code, const std::string& detail) {
    refuse(around, {session.id, request_id}, code, detail);
    if (++session.illegal_messages >= around.limits.illegal_messages) close(now, session);
}

void Lobby::World::close(base::Instant now, Session& session) {
    around.outbox.close(session.id);
    forget(now, session);
}

void Lobby::World::forget(base::Instant now, Session& session) {
    if (session.table) {
        table_of(*session.table)->lose(now, session.id);
        refresh_deadline(*session.table);
    }
    if (session.player) {
        Player& player = *players.find(*session.player);
        player.session.reset();
        if (session.table) {
            player.left_open_door = !table_of(*session.table)->access().is_private();
        }
    }
    session_deadlines.set(session.id, std::nullopt);
    feed.unfollow(session.id);
    sessions.erase(session.id);
}

/// A message only moves `heard`; the deadline is looked at again when it comes.
void Lobby::World::expire(base::Instant now, Session& session) {
    if (session.expires() > now) {
        session_deadlines.set(session.id, session.expires());
        return;
    }
    if (session.phase == Phase::Greeting) {
        refuse(around, {session.id}, RefusedCode::GreetingTimeout, "no Hello came in time");
    } else {
        refuse(around, {session.id}, RefusedCode::IdleTimeout, "nothing was heard for too long");
    }
    close(now, session);
}

void Lobby::World::advance(base::Instant now, Table& table, protocol::TableId id) {
    table.advance(now);
    if (table.is_abandoned(now)) {
        close_table(id);
    } else {
        refresh_deadline(id);
    }
}

/// Players' own notes of the table may stay: its id is never given again.
void Lobby::World::close_table(protocol::TableId id) {
    Table* table = table_of(id);
    CHECK(table != nullptr);
    table->close();
    table->seating().for_each_spectator([&](SessionId watching) {
        Session* session = session_of(watching);
        CHECK(session != nullptr);
        session->table.reset();
        session->phase = Phase::Lobby;
    });
    table_deadlines.set(id, std::nullopt);
    tables.erase(id);
    opened_tables.remove(id);
    feed.touch(id);
    table_list.reset();
}

void Lobby::World::refresh_deadline(protocol::TableId id) {
    const Table* table = table_of(id);
    if (table == nullptr) return;
    table_deadlines.set(id, table->next_deadline());
    feed.touch(id);
}

std::optional<base::Instant> Lobby::World::next_errand() const {
    const auto change = feed.due();
    const auto probe = probe_due();
    if (change && probe) return std::min(*change, *probe);
    return change ? change : probe;
}

void Lobby::World::run_errands(base::Instant now) {
    if (!around.stats.storage_failing) probed = now;
    if (const auto due = feed.due(); due && *due <= now) tell_followers(now);
    if (const auto due = probe_due(); due && *due <= now) probe_storage(now);
}

std::optional<base::Instant> Lobby::World::probe_due() const {
    if (!around.stats.storage_failing || is_probing) return std::nullopt;
    return probed + around.limits.storage_probe_every;
}

/// Writes what is durable already, for only a write finds out whether the disk takes one. Where
/// nobody is known yet, there is nothing to write, and the next player to come finds it out.
void Lobby::World::probe_storage(base::Instant now) {
    is_probing = true;
    probed = now;
    std::vector<Write> writes;
    if (const Player* player = players.anyone()) writes.push_back(SavePlayer{player->stored});
    around.committer.submit(std::move(writes), [this](const Committed& committed) {
        is_probing = false;
        around.stats.storage_failing = !committed.result.ok();
    });
}

/// At the time of its last message: the refusal may have waited for a disk.
void Lobby::World::count_unsolvable(SessionId id) {
    if (Session* session = session_of(id)) session->unsolvable.allows(session->heard);
}

void Lobby::World::save_what_failed() {
    for (const protocol::TableId id : std::exchange(around.unsaved, {})) {
        if (Table* table = table_of(id)) table->save_again();
    }
}

Session* Lobby::World::session_of(SessionId id) {
    const auto known = sessions.find(id);
    return known == sessions.end() ? nullptr : &known->second;
}

Table* Lobby::World::table_of(protocol::TableId id) {
    const auto known = tables.find(id);
    return known == tables.end() ? nullptr : &known->second;
}

void Lobby::World::tell(SessionId to, const protocol::ServerMessage& message) {
    around.outbox.deliver(to, protocol::encode(message), Delivery::Ordered);
}

void Lobby::World::announce(const protocol::server::Notice& notice) {
    const protocol::SharedFrame frame = protocol::encode(notice);
    for (const auto& [id, session] : sessions) {
        around.outbox.deliver(id, frame, Delivery::Ordered);
    }
}

}  // namespace billiards::server
