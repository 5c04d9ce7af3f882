// Takes an open SQLite database; keeps the tables in it, each with its invites and whom it keeps
// out.
#pragma once

#include "server/store/match_store.h"

#include <SQLiteCpp/Database.h>
#include <SQLiteCpp/Statement.h>
#include <vector>

namespace billiards::server {

/// Everything here throws SQLite::Exception.
class SqliteTables {
  public:
    explicit SqliteTables(SQLite::Database& database) : database_(database) {}

    void save(const StoredTable& table);
    void remove(protocol::TableId table);
    /// In ascending TableId.
    std::vector<StoredTable> all();

  private:
    void forget_lists(protocol::TableId table);
    void read_lists(StoredTable& table);

    SQLite::Database& database_;
    SQLite::Statement save_{
        database_,
        "INSERT INTO tables (id, name, settings, owner, is_private, passcode_hash, passcode_salt, "
        "first_seat, second_seat) VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?) ON CONFLICT (id) DO UPDATE "
        "SET name = excluded.name, settings = excluded.settings, owner = excluded.owner, "
        "is_private = excluded.is_private, passcode_hash = excluded.passcode_hash, "
        "passcode_salt = excluded.passcode_salt, first_seat = excluded.first_seat, "
        "second_seat = excluded.second_seat"};
    SQLite::Statement remove_{database_, "DELETE FROM tables WHERE id = ?"};
    SQLite::Statement forget_invites_{database_, "DELETE FROM table_invites WHERE table_id = ?"};
    SQLite::Statement forget_kicked_{database_, "DELETE FROM table_kicked WHERE table_id = ?"};
    SQLite::Statement invite_{database_, "INSERT INTO table_invites VALUES (?, ?, ?, ?)"};
    SQLite::Statement kick_{database_, "INSERT INTO table_kicked VALUES (?, ?, ?)"};
};

}  // namespace billiards::server
