// Gives the seam to the database: what is durable, and the few calls it takes.
#pragma once

#include "common/base/result.h"
#include "common/base/time.h"
#include "common/model/seat.h"
#include "common/protocol/codec_journal.h"
#include "common/protocol/messages.h"
#include "server/rating/glicko.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
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

/// A match that is kept with its journal.
struct KnownMatch {
    StoredMatch match;
    bool is_over = false;
    std::uint64_t entries = 0;  ///< Of its journal.
    friend bool operator==(const KnownMatch&, const KnownMatch&) = default;
};

/// A match that is over, as the history has it; its journal may be gone.
struct StoredResult {
    MatchId match;
    std::int64_t ended_s = 0;  ///< Since 1970-01-01 UTC, by the database's clock: to be shown.
    model::PerSeat<PlayerId> players;
    model::PerSeat<std::string> names;  ///< As they are shown today.
    MatchResult result;
    friend bool operator==(const StoredResult&, const StoredResult&) = default;
};

struct HistoryQuery {
    PlayerId asker;                    ///< Sees their own matches, and those for everybody.
    std::optional<PlayerId> player{};  ///< None: everybody's.
    std::uint64_t before = 0;          ///< Only matches with a lower number; 0: all.
    std::size_t at_most = 0;
};

/// What a player has achieved in matches between two players that did not end abandoned.
struct Standing {
    std::uint32_t games = 0;
    std::uint32_t wins = 0;
    std::uint32_t draws = 0;
    Rating rating{};  ///< As it is today: grown old since the last game.
    friend bool operator==(const Standing&, const Standing&) = default;
};

struct StoredEntry {
    std::uint64_t sequence = 0;  ///< 1, 2, 3 ... within its match.
    protocol::EncodedEntry entry;
};
/// Gives whether to go on to the next entry.
using EntryVisitor = std::function<bool(StoredEntry entry)>;

/// What is kept of what has ended. Ages are the store's own: they grow only while it is in use,
/// and by kLongestStop_s at most from one opening to the next, whatever the calendar says.
struct Retention {
    std::int64_t kept_s = 0;       ///< 0: for ever.
    std::uint64_t most_bytes = 0;  ///< Of the file, as long as journals can be dropped; 0: any.
    std::size_t entries_at_once = 256;  ///< The most that one sweep drops; guests likewise.
    /// Instead of journals: guests who were not seen for so long and never finished a match; not
    /// while anybody knows them by heart.
    bool guests = false;
};
inline constexpr std::int64_t kLongestStop_s = 24 * 60 * 60;

struct Swept {
    std::size_t entries = 0;
    std::size_t matches = 0;
    bool is_done = true;  ///< Otherwise there is more to drop.
};

/// Inserts, or replaces the player's name and hashes. The player has been seen now.
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
/// Nothing for a match that is not live. One without a shot is deleted; of any other, the result is
/// kept, with what it makes of both players' standing.
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
    Busy,    ///< Another process holds the file; later it may work.
    Disk,    ///< The system cannot write or read; detail names its reason.
    Gone,    ///< The file is no longer the one that was opened: deleted, moved or replaced.
    Failed,  ///< Of these writes alone; others may work.
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
    /// In ascending TableId.
    virtual StoreResult<std::vector<StoredTable>> tables() = 0;
    /// Matches without a FinishMatch, in ascending MatchId.
    virtual StoreResult<std::vector<StoredMatch>> live_matches() = 0;
    /// Those with one, likewise, as long as their journals are kept.
    virtual StoreResult<std::vector<EndedMatch>> ended_matches() = 0;
    /// The newest that is kept of those played at the table.
    virtual StoreResult<std::optional<KnownMatch>> last_match(protocol::TableId table) = 0;
    virtual StoreResult<std::optional<KnownMatch>> find_match(MatchId match) = 0;
    /// A match's entries in ascending sequence, one at a time; those below `records_from` without
    /// their records, which are most of their bytes.
    virtual StoreResult<base::Done> journal(MatchId match, const EntryVisitor& visit,
                                            std::uint64_t records_from) = 0;
    /// The highest ids ever given, also to what is gone; 0 where there were none.
    struct HighestIds {
        std::uint64_t player = 0;
        std::uint64_t match = 0;
        std::uint32_t table = 0;
    };
    virtual StoreResult<HighestIds> highest_ids() = 0;

    virtual StoreResult<std::optional<PlayerId>> player_named(const std::string& name) = 0;
    /// The newest first. Of matches at private tables, and of those still hidden, only the asker's.
    virtual StoreResult<std::vector<StoredResult>> history(const HistoryQuery& query) = 0;
    /// Whether the match is over and history() would give it to the asker.
    virtual StoreResult<bool> may_see(MatchId match, PlayerId asker) = 0;
    /// To others than the player as if their private and hidden matches had not been.
    virtual StoreResult<Standing> standing(PlayerId player, PlayerId asker) = 0;

    /// Drops what need not be kept any longer, in one commit; a live match never.
    virtual StoreResult<Swept> sweep(const Retention& retention) = 0;
};

/// The whole journal at once, for whoever needs all of it.
StoreResult<std::vector<StoredEntry>> whole_journal(MatchStore& store, MatchId match);

}  // namespace billiards::server
