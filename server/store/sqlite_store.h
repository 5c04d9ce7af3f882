// Takes the path of a database file; gives a MatchStore in SQLite.
#pragma once

#include "server/store/match_store.h"
#include "server/store/store_clock.h"

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>

namespace billiards::server {

struct SqliteOptions {
    /// How long a commit waits for another process that holds the file, such as a backup.
    std::chrono::milliseconds busy_timeout{5000};
    StoreClock clock = system_times;
    std::optional<std::int64_t> most_pages{};  ///< A smaller disk than there is.
};

/// Opens the file, makes it where it is missing, and brings an older one up to this version's
/// tables. One thread at a time may use the store. What commit() said is durable survives a killed
/// process and a lost power supply: write-ahead log, one flush to the disk a commit. A file that
/// was deleted or replaced meanwhile is Gone, until it is back.
StoreResult<std::unique_ptr<MatchStore>> open_sqlite_store(const std::filesystem::path& file,
                                                           const SqliteOptions& options = {});

/// For looking into the file, also beside a server that is writing it: nothing is changed, and
/// commit() fails.
StoreResult<std::unique_ptr<MatchStore>> open_sqlite_reader(const std::filesystem::path& file,
                                                            const SqliteOptions& options = {});

}  // namespace billiards::server
