// Takes a server's data folder as a kill has left it; gives what stands in its journals, and what
// promise that breaks.
#pragma once

#include "common/base/result.h"
#include "tests/soak/account.h"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <span>
#include <string>

namespace billiards::soak {

struct Journal {
    std::uint64_t match = 0;
    bool is_ended = false;
    std::size_t entries = 0;
    std::map<int, Shot> shots;
    match::MatchState state;  ///< At the end of it.
};

/// By table: each has one match. The folder is copied and the copy opened, so that the server finds
/// what it left. The error names the match and the entry that is half applied, out of order or does
/// not follow from those before it.
base::Result<std::map<std::uint32_t, Journal>, std::string> read_journals(
    const std::filesystem::path& data);

/// What accounts and journal disagree about. Of a match that is under way the journal may hold one
/// shot more than anybody was told of; of one that is `complete`, nothing may be missing.
std::optional<std::string> broken_promise(const Journal& journal, std::span<const Account> accounts,
                                          bool complete);

}  // namespace billiards::soak
