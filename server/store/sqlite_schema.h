// Takes an open SQLite database; gives it the tables of this version.
#pragma once

#include "server/store/match_store.h"

#include <SQLiteCpp/Database.h>
#include <filesystem>

namespace billiards::server {

/// Applies every migration that the file lacks, each whole or not at all. A file from a newer
/// version is left as it is, and refused. Throws SQLite::Exception.
StoreResult<base::Done> migrate(SQLite::Database& database, const std::filesystem::path& file);

/// Refuses a file that lacks a migration, and one from a newer version. Throws likewise.
StoreResult<base::Done> check_version(SQLite::Database& database,
                                      const std::filesystem::path& file);

}  // namespace billiards::server
