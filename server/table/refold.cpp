// Takes a stored match; folds its journal into a state.
#include "server/table/refold.h"

#include "common/base/check.h"
#include "common/match/match.h"
#include "common/protocol/codec_journal.h"

#include <cstddef>
#include <utility>
#include <variant>

namespace billiards::server {
namespace {

/// Where a seat's last shot stands in the journal, and the match once it was judged.
struct ShotFound {
    std::size_t index = 0;
    match::MatchState after;
};

struct Fold {
    match::MatchState state;
    model::PerSeat<std::optional<ShotFound>> last_shots;
};

std::string at_entry(const StoredEntry& entry, const std::string& reason) {
    return "entry " + std::to_string(entry.sequence) + ": " + reason;
}

/// The record is left out: the fold does not read it.
base::Result<protocol::JournalEntry, std::string> decode_without_record(const StoredEntry& stored) {
    auto entry = protocol::decode_entry({.command = stored.entry.command,
                                         .verdict = stored.entry.verdict,
                                         .final_layout = stored.entry.final_layout,
                                         .record = {}});
    if (!entry) return at_entry(stored, entry.error().detail);
    return std::move(entry).value();
}

base::Result<base::Done, std::string> add(Fold& fold, std::span<const StoredEntry> entries,
                                          std::size_t index) {
    const StoredEntry& stored = entries[index];
    if (stored.sequence != index + 1) {
        return at_entry(stored, "expected sequence " + std::to_string(index + 1));
    }
    const auto entry = decode_without_record(stored);
    if (!entry) return entry.error();
    auto next =
        match::refold(fold.state, entry->seat, entry->command, entry->final_layout, entry->verdict);
    if (!next) return at_entry(stored, "refused: " + next.error().detail);
    fold.state = std::move(next).value();
    if (std::holds_alternative<match::TakeShot>(entry->command)) {
        fold.last_shots[entry->seat] = ShotFound{index, fold.state};
    }
    return base::Done{};
}

base::Result<protocol::server::ShotPlayed, std::string> shot_played(const ShotFound& found,
                                                                    const StoredEntry& stored) {
    auto entry = protocol::decode_entry(stored.entry);
    if (!entry) return at_entry(stored, entry.error().detail);
    const auto* command = std::get_if<match::TakeShot>(&entry->command);
    CHECK(command != nullptr);
    if (!entry->record || !entry->verdict) return at_entry(stored, "a shot without its outcome");
    protocol::server::ShotPlayed played;
    played.sequence = stored.sequence;
    played.seat = entry->seat;
    played.shot_id = entry->shot_id;
    played.shot = command->shot;
    played.call = command->call;
    played.record = std::move(*entry->record);
    played.verdict = std::move(*entry->verdict);
    played.after = found.after;
    return played;
}

}  // namespace

base::Result<Refolded, std::string> refold_journal(const StoredMatch& match,
                                                   std::span<const StoredEntry> entries) {
    const auto settings = protocol::decode_settings(match.settings);
    if (!settings) return "settings: " + settings.error().detail;
    auto start = match::start(settings->settings, settings->seed);
    if (!start) return "settings: " + start.error().detail;

    Fold fold{.state = std::move(start).value(), .last_shots = {}};
    for (std::size_t index = 0; index < entries.size(); ++index) {
        const auto added = add(fold, entries, index);
        if (!added) return added.error();
    }
    Refolded refolded{.state = std::move(fold.state), .entries = entries.size(), .last_shots = {}};
    for (const model::Seat seat : model::kSeats) {
        const auto& found = fold.last_shots[seat];
        if (!found) continue;
        auto played = shot_played(*found, entries[found->index]);
        if (!played) return played.error();
        refolded.last_shots[seat] = std::move(played).value();
    }
    return refolded;
}

}  // namespace billiards::server
