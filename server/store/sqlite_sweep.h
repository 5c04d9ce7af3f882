// Takes an open SQLite database; drops from it what need not be kept any longer.
#pragma once

#include "server/store/match_store.h"

#include <SQLiteCpp/Database.h>
#include <cstdint>

namespace billiards::server {

/// Within the caller's transaction. The oldest ended matches go first, each from its end, and
/// out of everybody's sight from the first moment on. Throws SQLite::Exception.
Swept sweep_journals(SQLite::Database& database, const Retention& retention, std::int64_t age_s);

/// Guests who were not seen for so long, never finished a match, and have no place at any table.
/// Likewise.
Swept forget_guests(SQLite::Database& database, const Retention& retention, std::int64_t age_s);

/// Outside of any transaction: hands free pages at the file's end back to the system, a few at a
/// time. A file from before there was such a thing keeps its pages, and uses them again.
void give_pages_back(SQLite::Database& database);

}  // namespace billiards::server
