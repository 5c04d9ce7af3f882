// Takes the path of a database file; gives a MatchStore in SQLite.
#pragma once

#include "server/store/match_store.h"

#include <filesystem>
#include <memory>

namespace billiards::server {

/// Opens the file, makes it where it is missing, and brings an older one up to this version's
/// tables. One thread at a time may use the store. What commit() said is durable survives a killed
/// process and a lost power supply: write-ahead log, one flush to the disk a commit.
StoreResult<std::unique_ptr<MatchStore>> open_sqlite_store(const std::filesystem::path& file);

/// For looking into the file, also beside a server that is writing it: nothing is changed, and
/// commit() fails.
StoreResult<std::unique_ptr<MatchStore>> open_sqlite_reader(const std::filesystem::path& file);

}  // namespace billiards::server
