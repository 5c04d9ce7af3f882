// Takes a database file, also one that a server is writing; gives a copy of it as it is at one
// moment.
#pragma once

#include "server/store/match_store.h"

#include <filesystem>

namespace billiards::server {

/// The copy is checked, on the disk, and for its owner alone, before it takes its name; a file of
/// that name is never replaced. The server goes on meanwhile.
StoreResult<base::Done> copy_database(const std::filesystem::path& from,
                                      const std::filesystem::path& to);

}  // namespace billiards::server
