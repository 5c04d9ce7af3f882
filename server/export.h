// Takes a data folder; gives the matches in it that have ended, or one of them as a file.
#pragma once

#include "server/store/match_store.h"

#include <filesystem>
#include <iosfwd>
#include <optional>

namespace billiards::server {

struct ExportOrder {
    std::filesystem::path data;
    std::optional<MatchId> match;  ///< None: the matches are listed.
    std::filesystem::path file;    ///< Empty: match-ID.billiards, here.
};

/// Also beside a server that runs. Only matches that have ended: a replay holds the seed of every
/// rack. Gives the exit code: 0, or 1 after one line on `err` that says why.
int export_match(const ExportOrder& order, std::ostream& out, std::ostream& err);

}  // namespace billiards::server
