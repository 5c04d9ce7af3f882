// Takes an open SQLite database; keeps the tables in it, each with its invites and whom it keeps
// out.
#include "server/store/sqlite_tables.h"

#include "server/store/sqlite_row.h"

#include <utility>

namespace billiards::server {
namespace {

void bind_player(SQLite::Statement& statement, int index, const std::optional<PlayerId>& player) {
    if (player) {
        statement.bind(index, stored(player->value));
    } else {
        statement.bind(index);  // NULL
    }
}

std::optional<PlayerId> read_player(const SQLite::Column& column) {
    if (column.isNull()) return std::nullopt;
    return PlayerId{read_number(column)};
}

StoredTable read_table(SQLite::Statement& row) {
    StoredTable table;
    table.table.value = static_cast<std::uint32_t>(row.getColumn(0).getInt64());
    table.name = row.getColumn(1).getString();
    table.settings = read_bytes(row.getColumn(2));
    table.owner.value = read_number(row.getColumn(3));
    table.is_private = row.getColumn(4).getInt() != 0;
    table.passcode_hash = read_array<std::tuple_size_v<SecretHash>>(row.getColumn(5));
    table.passcode_salt = read_array<16>(row.getColumn(6)).value_or(table.passcode_salt);
    table.seats[model::Seat::First] = read_player(row.getColumn(7));
    table.seats[model::Seat::Second] = read_player(row.getColumn(8));
    return table;
}

}  // namespace

void SqliteTables::save(const StoredTable& table) {
    {
        const Use use(save_);
        use->bind(1, stored(table.table.value));
        use->bindNoCopy(2, table.name);
        bind_bytes(*use, 3, table.settings);
        use->bind(4, stored(table.owner.value));
        use->bind(5, table.is_private ? 1 : 0);
        bind_bytes(*use, 6, table.passcode_hash);
        bind_bytes(*use, 7, table.passcode_salt);
        bind_player(*use, 8, table.seats[model::Seat::First]);
        bind_player(*use, 9, table.seats[model::Seat::Second]);
        use->exec();
    }
    forget_lists(table.table);
    int position = 0;
    for (const StoredInvite& invite : table.invites) {
        const Use use(invite_);
        use->bind(1, stored(table.table.value));
        use->bind(2, position++);
        bind_bytes(*use, 3, invite.hash);
        use->bind(4, invite.is_for_playing ? 1 : 0);
        use->exec();
    }
    for (const PlayerId player : table.kicked) {
        const Use use(kick_);
        use->bind(1, stored(table.table.value));
        use->bind(2, position++);
        use->bind(3, stored(player.value));
        use->exec();
    }
}

void SqliteTables::remove(protocol::TableId table) {
    forget_lists(table);
    const Use use(remove_);
    use->bind(1, stored(table.value));
    use->exec();
}

void SqliteTables::forget_lists(protocol::TableId table) {
    for (SQLite::Statement* forget : {&forget_invites_, &forget_kicked_}) {
        const Use use(*forget);
        use->bind(1, stored(table.value));
        use->exec();
    }
}

std::vector<StoredTable> SqliteTables::all() {
    std::vector<StoredTable> tables;
    SQLite::Statement rows(database_,
                           "SELECT id, name, settings, owner, is_private, passcode_hash, "
                           "passcode_salt, first_seat, second_seat FROM tables ORDER BY id");
    while (rows.executeStep()) tables.push_back(read_table(rows));
    for (StoredTable& table : tables) read_lists(table);
    return tables;
}

void SqliteTables::read_lists(StoredTable& table) {
    SQLite::Statement invites(
        database_,
        "SELECT hash, is_for_playing FROM table_invites WHERE table_id = ? ORDER BY position");
    invites.bind(1, stored(table.table.value));
    while (invites.executeStep()) {
        const auto hash = read_array<std::tuple_size_v<SecretHash>>(invites.getColumn(0));
        if (hash) table.invites.push_back({*hash, invites.getColumn(1).getInt() != 0});
    }
    SQLite::Statement kicked(
        database_, "SELECT player FROM table_kicked WHERE table_id = ? ORDER BY position");
    kicked.bind(1, stored(table.table.value));
    while (kicked.executeStep()) table.kicked.push_back({read_number(kicked.getColumn(0))});
}

}  // namespace billiards::server
