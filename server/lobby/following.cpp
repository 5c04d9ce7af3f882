// Takes who wants to know which tables there are; gives the list, and to followers its changes.
#include "common/protocol/codec.h"
#include "common/protocol/limits.h"
#include "server/lobby/world.h"

#include <utility>

namespace billiards::server {

namespace client = protocol::client;

void Lobby::World::on(const Heard& heard, const client::ListTables& /*message*/) {
    if (may_ask_lobby(heard)) send_tables(heard.now, heard.session.id);
}

void Lobby::World::on(const Heard& heard, const client::FollowTables& /*message*/) {
    if (!may_ask_lobby(heard)) return;
    if (!feed.is_followed()) {
        TableFeed::Rows rows;
        for (const auto& [id, table] : tables) {
            if (auto row = public_row(id)) rows.emplace(id, std::move(*row));
        }
        feed.begin(heard.now, std::move(rows));
    }
    feed.follow(heard.session.id);
    around.outbox.deliver(heard.session.id, feed.list(), Delivery::Ordered);
}

void Lobby::World::tell_followers(base::Instant now) {
    const auto frames =
        feed.take_changes(now, [this](protocol::TableId id) { return public_row(id); });
    for (const protocol::SharedFrame& frame : frames) {
        feed.for_each_follower(
            [&](SessionId to) { around.outbox.deliver(to, frame, Delivery::Ordered); });
    }
}

/// The newest come first, and the oldest are left out where there are too many.
void Lobby::World::send_tables(base::Instant now, SessionId to) {
    if (!table_list || now - table_list->made > around.limits.table_list_kept) {
        protocol::server::TableList list;
        for (auto table = tables.rbegin();
             table != tables.rend() && list.tables.size() < protocol::kMaxTableRows; ++table) {
            if (auto row = public_row(table->first)) list.tables.push_back(std::move(*row));
        }
        table_list = TableListFrame{protocol::encode(std::move(list)), now};
    }
    around.outbox.deliver(to, table_list->frame, Delivery::Ordered);
}

std::optional<protocol::server::TableRow> Lobby::World::public_row(protocol::TableId id) {
    const Table* table = table_of(id);
    if (table == nullptr || table->access().is_private()) return std::nullopt;
    return table->row();
}

}  // namespace billiards::server
