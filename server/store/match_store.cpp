// Takes a store; gives what every one of them can do by its few calls.
#include "server/store/match_store.h"

#include <utility>

namespace billiards::server {

StoreResult<std::vector<StoredEntry>> whole_journal(MatchStore& store, MatchId match) {
    std::vector<StoredEntry> entries;
    const auto visit = [&entries](StoredEntry entry) {
        entries.push_back(std::move(entry));
        return true;
    };
    const auto read = store.journal(match, visit, 0);
    if (!read) return read.error();
    return entries;
}

}  // namespace billiards::server
