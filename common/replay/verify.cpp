// Takes a replay; gives whether this engine would play the same match, to the bit.
#include "common/replay/verify.h"

#include "common/match/match.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <optional>
#include <utility>
#include <vector>

namespace billiards::replay {

namespace {

using protocol::JournalEntry;

std::string where_differs(const model::Layout& kept, const model::Layout& again) {
    for (const model::PlacedBall& placed : again.balls) {
        const model::PlacedBall* other = kept.find(placed.ball);
        if (other != nullptr && *other == placed) continue;
        return fmt::format("ball {} comes to rest elsewhere", placed.ball.number);
    }
    return "it has more balls";
}

std::string where_differs(const rules::Verdict& kept, const rules::Verdict& again) {
    std::vector<const char*> fields;
    const auto compare = [&](const char* name, const auto& a, const auto& b) {
        if (!(a == b)) fields.push_back(name);
    };
    compare("fouls", kept.fouls, again.fouls);
    compare("who continues", kept.turn_continues, again.turn_continues);
    compare("next player", kept.next_player, again.next_player);
    compare("ball in hand", kept.in_hand, again.in_hand);
    compare("choices", kept.choices, again.choices);
    compare("groups", kept.groups, again.groups);
    compare("winner", kept.winner, again.winner);
    compare("reason", kept.reason, again.reason);
    if (fields.empty()) return "the ruling is another";
    return fmt::format("the ruling is another: {}", fmt::join(fields, ", "));
}

/// Empty where nothing differs.
std::string difference(const JournalEntry& kept, const JournalEntry& again) {
    if (kept.final_layout.has_value() != again.final_layout.has_value() ||
        kept.record.has_value() != again.record.has_value() ||
        kept.verdict.has_value() != again.verdict.has_value()) {
        return "it has no such outcome";
    }
    if (kept.final_layout != again.final_layout) {
        return where_differs(*kept.final_layout, *again.final_layout);
    }
    if (kept.record && kept.record->hash != again.record->hash) {
        return fmt::format("the hash of its record is {:016x}, solved again {:016x}",
                           kept.record->hash, again.record->hash);
    }
    if (kept.record != again.record) return "its record is not the one that its hash is of";
    if (kept.verdict != again.verdict) return where_differs(*kept.verdict, *again.verdict);
    return "";
}

NotVerified differs(std::size_t index, int shots_played, const JournalEntry& entry,
                    const std::string& how) {
    const bool is_shot = std::holds_alternative<match::TakeShot>(entry.command);
    return {NotVerifiedCode::Differs,
            fmt::format("{} {} (entry {}): {}", is_shot ? "shot" : "after shot",
                        shots_played + (is_shot ? 1 : 0), index + 1, how)};
}

}  // namespace

base::Result<JournalEntry, protocol::DecodeError> kept(model::Seat seat,
                                                       const match::Command& command,
                                                       std::uint64_t shot_id,
                                                       match::Outcome outcome) {
    JournalEntry entry;
    entry.seat = seat;
    entry.command = command;
    entry.shot_id = shot_id;
    entry.verdict = std::move(outcome.verdict);
    if (outcome.record) entry.final_layout = outcome.record->final_layout;
    entry.record = std::move(outcome.record);
    return protocol::decode_entry(protocol::encode_entry(entry));
}

base::Result<base::Done, NotVerified> verify(const Replay& replay) {
    const Header& header = replay.header;
    if (header.engine != kEngineVersion) {
        return NotVerified{NotVerifiedCode::OtherEngine,
                           fmt::format("played by engine {}, this is engine {}: it plays, but "
                                       "cannot be verified",
                                       header.engine, kEngineVersion)};
    }
    auto start = match::start(header.settings, header.seed);
    if (!start) return NotVerified{NotVerifiedCode::Differs, "settings: " + start.error().detail};
    match::MatchState state = std::move(start).value();
    for (std::size_t index = 0; index < replay.entries.size(); ++index) {
        const JournalEntry& entry = replay.entries[index];
        auto step = match::apply(state, entry.seat, entry.command);
        if (!step) {
            return differs(index, state.shots_played, entry, "refused: " + step.error().detail);
        }
        const auto again = kept(entry.seat, entry.command, entry.shot_id, std::move(step->outcome));
        const std::string how = again ? difference(entry, *again) : again.error().detail;
        if (!how.empty()) return differs(index, state.shots_played, entry, how);
        state = std::move(step).value().next;
    }
    return base::Done{};
}

}  // namespace billiards::replay
