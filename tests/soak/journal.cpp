// Takes a copy of the database; folds each journal by itself, entry by entry.
#include "tests/soak/journal.h"

#include "common/match/match.h"
#include "common/protocol/codec_journal.h"
#include "server/store/sqlite_store.h"
#include "tests/support/temporary_folder.h"

#include <algorithm>
#include <fmt/format.h>
#include <set>
#include <utility>
#include <variant>
#include <vector>

namespace billiards::soak {
namespace {

using Broken = std::optional<std::string>;
using protocol::JournalEntry;
template <class T>
using Read = base::Result<T, std::string>;

constexpr const char* kDatabase = "billiards.db";

/// What a server that is killed leaves of its database: the file, and the log that is written
/// ahead.
void copy_database(const std::filesystem::path& from, const std::filesystem::path& to) {
    for (const char* suffix : {"", "-wal"}) {
        const std::string name = std::string(kDatabase) + suffix;
        if (std::filesystem::exists(from / name))
            std::filesystem::copy_file(from / name, to / name);
    }
}

std::optional<std::string> incomplete(const JournalEntry& entry) {
    const bool is_shot = std::holds_alternative<match::TakeShot>(entry.command);
    const bool has_outcome = entry.record && entry.verdict && entry.final_layout;
    if (is_shot && !has_outcome) return "a shot without its outcome";
    if (!is_shot && entry.record) return "a record without a shot";
    return std::nullopt;
}

std::optional<std::string> add(Journal& journal, const server::StoredEntry& stored) {
    if (stored.sequence != journal.entries + 1) {
        return fmt::format("{} entries, then number {}", journal.entries, stored.sequence);
    }
    const auto entry = protocol::decode_entry(stored.entry);
    if (!entry) return entry.error().detail;
    if (auto what = incomplete(*entry)) return what;
    auto next = match::refold(journal.state, entry->seat, entry->command, entry->final_layout,
                              entry->verdict);
    if (!next) return "refused: " + next.error().detail;
    journal.state = std::move(next).value();
    ++journal.entries;
    if (!entry->record) return std::nullopt;
    Shot shot{
        .shot_id = entry->shot_id, .record_hash = entry->record->hash, .after = journal.state};
    shot.after.seed = 0;
    journal.shots.emplace(journal.state.shots_played, std::move(shot));
    return std::nullopt;
}

Read<Journal> read_journal(server::MatchStore& store, const server::StoredMatch& match) {
    const auto settings = protocol::decode_settings(match.settings);
    if (!settings) return settings.error().detail;
    auto start = match::start(settings->settings, settings->seed);
    if (!start) return start.error().detail;
    const auto entries = whole_journal(store, match.match);
    if (!entries) return entries.error().detail;
    Journal journal;
    journal.match = match.match.value;
    journal.state = std::move(start).value();
    for (const server::StoredEntry& stored : *entries) {
        if (auto what = add(journal, stored)) {
            return fmt::format("entry {}: {}", stored.sequence, *what);
        }
    }
    return journal;
}

struct Found {
    server::StoredMatch match;
    bool is_ended = false;
};

Read<std::vector<Found>> all_matches(server::MatchStore& store) {
    auto live = store.live_matches();
    if (!live) return live.error().detail;
    auto ended = store.ended_matches();
    if (!ended) return ended.error().detail;
    std::vector<Found> found;
    for (server::StoredMatch& match : *live) found.push_back({std::move(match), false});
    for (server::EndedMatch& match : *ended) found.push_back({std::move(match.match), true});
    return found;
}

Broken disagreement(const Journal& journal, const Account& account) {
    for (const auto& [number, shot] : account.shots) {
        const auto found = journal.shots.find(number);
        if (found == journal.shots.end()) {
            return fmt::format("shot {} was told and is not in the journal", number);
        }
        if (found->second.shot_id != shot.shot_id) {
            return fmt::format("shot {} was told as {:016x}, and the journal has {:016x}", number,
                               shot.shot_id, found->second.shot_id);
        }
        if (found->second.record_hash != shot.record_hash) {
            return fmt::format("shot {} has another record in the journal", number);
        }
        if (found->second.after != shot.after) {
            return fmt::format("shot {} led to another state in the journal", number);
        }
    }
    return std::nullopt;
}

Broken repeated_shot(const Journal& journal) {
    std::set<std::uint64_t> ids;
    for (const auto& [number, shot] : journal.shots) {
        if (!ids.insert(shot.shot_id).second) return fmt::format("shot {} is a repeat", number);
    }
    return std::nullopt;
}

Broken unlike_the_end(const Journal& journal, const Account& account) {
    if (!account.over) return std::nullopt;
    const bool is_same =
        account.over->winner == journal.state.winner &&
        account.over->racks_won == journal.state.racks_won &&
        account.over->shots == static_cast<std::uint32_t>(journal.state.shots_played);
    if (journal.state.stage != match::Stage::Over || !is_same) {
        return std::string("the end was told otherwise than the journal has it");
    }
    return std::nullopt;
}

/// A kill may come between a shot's commit and its telling; then a snapshot is all that tells of
/// it.
Broken unfinished(const Journal& journal, int known) {
    if (!journal.is_ended) return std::string("the match is not marked as ended");
    if (journal.state.shots_played > known) {
        return fmt::format("of {} shots nobody knows of more than {}", journal.state.shots_played,
                           known);
    }
    return std::nullopt;
}

}  // namespace

Read<std::map<std::uint32_t, Journal>> read_journals(const std::filesystem::path& data) {
    const support::TemporaryFolder folder;
    copy_database(data, folder.path());
    const auto store = server::open_sqlite_store(folder.path() / kDatabase);
    if (!store) return store.error().detail;
    const auto matches = all_matches(**store);
    if (!matches) return matches.error();
    std::map<std::uint32_t, Journal> journals;
    for (const Found& found : *matches) {
        auto journal = read_journal(**store, found.match);
        if (!journal) return fmt::format("match {}: {}", found.match.match.value, journal.error());
        journal->is_ended = found.is_ended;
        journals.insert_or_assign(found.match.table.value, std::move(journal).value());
    }
    return journals;
}

Broken broken_promise(const Journal& journal, std::span<const Account> accounts, bool complete) {
    if (auto what = repeated_shot(journal)) return what;
    int known = 0;
    for (const Account& account : accounts) {
        if (auto what = disagreement(journal, account)) return what;
        if (auto what = unlike_the_end(journal, account)) return what;
        known = std::max(known, account.known);
    }
    if (journal.state.shots_played > known + 1) {
        return fmt::format("{} shots in the journal, of which nobody was told of more than {}",
                           journal.state.shots_played, known);
    }
    return complete ? unfinished(journal, known) : std::nullopt;
}

}  // namespace billiards::soak
