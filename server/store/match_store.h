// Gives the seam to the database: what is durable, and the few calls it takes.
#pragma once

#include "common/base/result.h"
#include "common/base/time.h"
#include "common/model/seat.h"
#include "common/protocol/codec_journal.h"
#include "common/protocol/messages.h"

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <variant>
#include <vector>

namespace billiards::server {

/// A guest for as long as the server's data lives.
struct PlayerId {
    std::uint64_t value = 0;
    friend auto operator<=>(PlayerId, PlayerId) = default;
};

struct MatchId {
    std::uint64_t value = 0;
    friend auto operator<=>(MatchId, MatchId) = default;
};

/// SHA-256 of a resume token: the token itself is never stored.
using TokenHash = std::array<std::uint8_t, 32>;

struct StoredPlayer {
    PlayerId player;
    std::string name;  ///< With its discriminator.
    TokenHash token_hash{};
    /// The token before: good until the first message under the new one, so that neither a lost
    /// answer nor a restart at that moment locks a player out.
    std::optional<TokenHash> previous_token_hash{};
    friend bool operator==(const StoredPlayer&, const StoredPlayer&) = default;
};

/// A match that was not over when it was last written, with the table it is played on.
struct StoredMatch {
    MatchId match;
    protocol::TableId table;
    std::string table_name;
    model::PerSeat<PlayerId> players;
    protocol::Bytes settings;  ///< protocol::encode_settings
    std::string engine;        ///< replay::kEngineVersion when it began.
    friend bool operator==(const StoredMatch&, const StoredMatch&) = default;
};

/// A match that is over, or that was closed because nobody came back to it.
struct EndedMatch {
    StoredMatch match;
    std::int64_t started_s = 0;  ///< Since 1970-01-01 UTC, by the database's clock; 0: unknown.
    friend bool operator==(const EndedMatch&, const EndedMatch&) = default;
};

/// SHA-256 of an invite, or of a passcode after its table's salt.
using SecretHash = std::array<std::uint8_t, 32>;

struct StoredInvite {
    SecretHash hash{};
    bool is_for_playing = false;  ///< Otherwise for watching.
    friend bool operator==(const StoredInvite&, const StoredInvite&) = default;
};

/// A table as it stands between two matches; what is played on it is a StoredMatch's affair.
struct StoredTable {
    protocol::TableId table;
    std::string name;
    protocol::Bytes settings;  ///< protocol::encode_settings, of the next match; the seed is 0.
    PlayerId owner;
    bool is_private = false;
    std::optional<SecretHash> passcode_hash{};
    std::array<std::uint8_t, 16> passcode_salt{};
    std::vector<StoredInvite> invites{};
    std::vector<PlayerId> kicked{};
    model::PerSeat<std::optional<PlayerId>> seats{};
    friend bool operator==(const StoredTable&, const StoredTable&) = default;
};

/// How a match ended, for the history and the players' records.
struct MatchResult {
    protocol::server::Ending ending = protocol::server::Ending::Played;
    std::optional<model::Seat> winner{};
    model::PerSeat<int> racks_won{};
    std::uint32_t shots = 0;  ///< 0: the match is not kept.
    rules::Game game = rules::Game::EightBall;
    bool is_private = false;      ///< Shown to its players alone.
    base::Duration hidden_for{};  ///< As long as its spectators were delayed.
    friend bool operator==(const MatchResult&, const MatchResult&) = default;
};

struct StoredEntry {
    std::uint64_t sequence = 0;  ///< 1, 2, 3 ... within its match.
    protocol::EncodedEntry entry;
};

/// Inserts, or replaces the player's name and hashes.
struct SavePlayer {
    StoredPlayer player;
};
struct SaveMatch {
    StoredMatch match;
};
struct AppendEntry {
    MatchId match;
    StoredEntry entry;
};
struct FinishMatch {
    MatchId match;
    MatchResult result{};
};
/// Inserts, or replaces the whole.
struct SaveTable {
    StoredTable table;
};
/// Its number is never given again.
struct RemoveTable {
    protocol::TableId table;
};

using Write = std::variant<SavePlayer, SaveMatch, AppendEntry, FinishMatch, SaveTable, RemoveTable>;

enum class StoreErrorCode : std::uint8_t {
    CannotOpen,  ///< detail names the file and the system's reason.
    Newer,       ///< Written by a newer version of this program.
    Corrupt,
    Full,
    Busy,
    Failed,
};

struct StoreError {
    StoreErrorCode code = StoreErrorCode::Failed;
    std::string detail;
    friend bool operator==(const StoreError&, const StoreError&) = default;
};

template <class T>
using StoreResult = base::Result<T, StoreError>;

/// One implementation a database; tests/server/store/match_store_contract.h is its contract.
class MatchStore {
  public:
    virtual ~MatchStore() = default;

    /// All of the writes or none; durable when it returns.
    virtual StoreResult<base::Done> commit(std::span<const Write> writes) = 0;
    virtual StoreResult<std::vector<StoredPlayer>> players() = 0;
    /// Matches without a FinishMatch, in ascending MatchId.
    virtual StoreResult<std::vector<StoredMatch>> live_matches() = 0;
    /// Those with one, likewise.
    virtual StoreResult<std::vector<EndedMatch>> ended_matches() = 0;
    /// A match's entries in ascending sequence.
    virtual StoreResult<std::vector<StoredEntry>> journal(MatchId match) = 0;
    /// The highest ids ever given; 0 where there were none.
    struct HighestIds {
        std::uint64_t player = 0;
        std::uint64_t match = 0;
        std::uint32_t table = 0;
    };
    virtual StoreResult<HighestIds> highest_ids() = 0;
};

}  // namespace billiards::server
