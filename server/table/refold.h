// Takes a match as it was stored; gives it as it stood after each of its steps, without solving
// anything again.
#pragma once

#include "common/base/result.h"
#include "common/match/match_state.h"
#include "common/model/seat.h"
#include "common/protocol/codec_journal.h"
#include "common/protocol/messages.h"
#include "server/store/match_store.h"

#include <cstdint>
#include <optional>
#include <span>
#include <string>

namespace billiards::server {

/// One entry after another; the errors say which does not follow from those before it, and why.
class JournalFold {
  public:
    static base::Result<JournalFold, std::string> begin(const StoredMatch& match);

    /// The entry's record is not read. After an error nothing has changed.
    base::Result<protocol::JournalEntry, std::string> add(const StoredEntry& stored);

    const match::MatchState& state() const { return state_; }
    std::uint64_t entries() const { return entries_; }

  private:
    explicit JournalFold(match::MatchState state) : state_(std::move(state)) {}

    match::MatchState state_;
    std::uint64_t entries_ = 0;
};

/// What everyone was told of a step that led to `after`: a CueBallPlaced, ShotPlayed or MatchMoved.
/// Its sequence is the entry's, its times are not set.
base::Result<protocol::ServerMessage, std::string> told_of(const StoredEntry& stored,
                                                           const match::MatchState& after);

struct Refolded {
    match::MatchState state;
    std::uint64_t entries = 0;
    /// Each seat's last shot, so that its repeat is answered; as told_of has it.
    model::PerSeat<std::optional<protocol::server::ShotPlayed>> last_shots;
};

base::Result<Refolded, std::string> refold_journal(const StoredMatch& match,
                                                   std::span<const StoredEntry> entries);
/// As it stands in the store, with no more than three entries in memory.
base::Result<Refolded, std::string> refold_journal(const StoredMatch& match, MatchStore& store);

}  // namespace billiards::server
