// Takes a stored match; folds its journal into a state.
#include "server/table/refold.h"

#include "common/match/match.h"
#include "common/protocol/moves.h"

#include <utility>
#include <variant>

namespace billiards::server {
namespace {

namespace say = protocol::server;

std::string at_entry(const StoredEntry& entry, const std::string& reason) {
    return "entry " + std::to_string(entry.sequence) + ": " + reason;
}

/// What everyone was told of one command.
struct Told {
    std::uint64_t sequence;
    protocol::JournalEntry& entry;
    const match::MatchState& after;

    say::CueBallPlaced operator()(const match::PlaceCueBall& placed) const {
        return {.sequence = sequence, .seat = entry.seat, .position_m = placed.position_m};
    }
    say::ShotPlayed operator()(const match::TakeShot& shot) const {
        say::ShotPlayed played;
        played.sequence = sequence;
        played.seat = entry.seat;
        played.shot_id = entry.shot_id;
        played.shot = shot.shot;
        played.call = shot.call;
        if (entry.record) played.record = std::move(*entry.record);
        if (entry.verdict) played.verdict = std::move(*entry.verdict);
        played.after = after;
        return played;
    }
    template <class Other>
    say::MatchMoved operator()(const Other& command) const {
        say::MatchMoved moved;
        moved.sequence = sequence;
        moved.seat = entry.seat;
        if constexpr (std::is_same_v<Other, match::Choose>) moved.choice = command.choice;
        moved.verdict = std::move(entry.verdict);
        moved.after = after;
        moved.move = protocol::move_of(entry.command);
        return moved;
    }
};

/// A fold that remembers where each seat's last shot was.
class LastShots {
  public:
    explicit LastShots(JournalFold fold) : fold_(std::move(fold)) {}

    base::Result<base::Done, std::string> add(const StoredEntry& stored) {
        const auto entry = fold_.add(stored);
        if (!entry) return entry.error();
        if (std::holds_alternative<match::TakeShot>(entry->command)) {
            last_[entry->seat] = Found{stored, fold_.state()};
        }
        return base::Done{};
    }

    base::Result<Refolded, std::string> result() const {
        Refolded refolded{.state = fold_.state(), .entries = fold_.entries(), .last_shots = {}};
        for (const model::Seat seat : model::kSeats) {
            if (!last_[seat]) continue;
            auto told = told_of(last_[seat]->entry, last_[seat]->after);
            if (!told) return told.error();
            refolded.last_shots[seat] = std::get<say::ShotPlayed>(std::move(told).value());
        }
        return refolded;
    }

  private:
    struct Found {
        StoredEntry entry;
        match::MatchState after;
    };
    JournalFold fold_;
    model::PerSeat<std::optional<Found>> last_;
};

}  // namespace

base::Result<JournalFold, std::string> JournalFold::begin(const StoredMatch& match) {
    const auto settings = protocol::decode_settings(match.settings);
    if (!settings) return "settings: " + settings.error().detail;
    auto start = match::start(settings->settings, settings->seed);
    if (!start) return "settings: " + start.error().detail;
    return JournalFold(std::move(start).value());
}

base::Result<protocol::JournalEntry, std::string> JournalFold::add(const StoredEntry& stored) {
    if (stored.sequence != entries_ + 1) {
        return at_entry(stored, "expected sequence " + std::to_string(entries_ + 1));
    }
    auto entry = protocol::decode_entry({.command = stored.entry.command,
                                         .verdict = stored.entry.verdict,
                                         .final_layout = stored.entry.final_layout,
                                         .record = {}});
    if (!entry) return at_entry(stored, entry.error().detail);
    auto next =
        match::refold(state_, entry->seat, entry->command, entry->final_layout, entry->verdict);
    if (!next) return at_entry(stored, "refused: " + next.error().detail);
    state_ = std::move(next).value();
    ++entries_;
    return std::move(entry).value();
}

base::Result<protocol::ServerMessage, std::string> told_of(const StoredEntry& stored,
                                                           const match::MatchState& after) {
    auto entry = protocol::decode_entry(stored.entry);
    if (!entry) return at_entry(stored, entry.error().detail);
    const bool is_shot = std::holds_alternative<match::TakeShot>(entry->command);
    if (is_shot && (!entry->record || !entry->verdict)) {
        return at_entry(stored, "a shot without its outcome");
    }
    const auto told = [&](const auto& command) -> protocol::ServerMessage {
        return Told{stored.sequence, *entry, after}(command);
    };
    return std::visit(told, entry->command);
}

base::Result<Refolded, std::string> refold_journal(const StoredMatch& match,
                                                   std::span<const StoredEntry> entries) {
    auto fold = JournalFold::begin(match);
    if (!fold) return fold.error();
    LastShots shots(std::move(fold).value());
    for (const StoredEntry& entry : entries) {
        const auto added = shots.add(entry);
        if (!added) return added.error();
    }
    return shots.result();
}

base::Result<Refolded, std::string> refold_journal(const StoredMatch& match, MatchStore& store) {
    auto fold = JournalFold::begin(match);
    if (!fold) return fold.error();
    LastShots shots(std::move(fold).value());
    base::Result<base::Done, std::string> added = base::Done{};
    const auto add = [&](const StoredEntry& entry) {
        added = shots.add(entry);
        return added.ok();
    };
    const auto read = store.journal(match.match, add, 0);
    if (!read) return read.error().detail;
    if (!added) return added.error();
    return shots.result();
}

}  // namespace billiards::server
