// Gives everything that a server may say, as plain values.
#pragma once

#include "common/base/vec.h"
#include "common/match/match_state.h"
#include "common/match/refusal.h"
#include "common/model/seat.h"
#include "common/model/shot.h"
#include "common/protocol/identity.h"
#include "common/rules/verdict.h"
#include "common/timeline/shot_record.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace billiards::protocol {

// The order of every enum and variant here is part of the wire format; only append.

enum class RefusedCode : std::uint8_t {
    Malformed,       ///< Bytes that are no message.
    NotInThisPhase,  ///< The message has no place in this phase of the session.
    TooMany,         ///< Over a rate or count limit; detail names it.
    GreetingTimeout,
    IdleTimeout,
    BadName,
    UnknownToken,
    UnknownTable,
    SeatTaken,
    TableFull,
    TooEarly,       ///< A shot while the balls still roll.
    MatchRunning,   ///< Not while a match is played.
    StorageFailed,  ///< The step could not be made durable, and was undone.
    ShuttingDown,
    Match,          ///< match::Refusal; match_code says which.
    NotOwner,       ///< Only whoever opened the table may do that.
    WrongSecret,    ///< No such invite or passcode, or no more.
    NotAllowed,     ///< Not now, or not for this one; detail says why.
    UnknownPlayer,  ///< Of this name.
    UnknownMatch,   ///< Not kept, or not for this one to see.
    Busy,           ///< Ask again later.
};

/// What the server answers and announces, server to client.
namespace server {

struct SeatView {
    bool taken = false;
    bool connected = false;
    bool ready = false;
    std::string name;  ///< With its discriminator, such as "Ada#3f21".
    /// The player is away, and from this server time on the opponent may claim the match.
    std::optional<std::int64_t> claimable_us{};
    friend bool operator==(const SeatView&, const SeatView&) = default;
};

struct TableRow {
    TableId table;
    std::string name;
    match::Settings settings;
    model::PerSeat<SeatView> seats;
    model::PerSeat<int> racks_won;
    bool playing = false;
    std::uint32_t spectators = 0;
    bool is_private = false;
    bool has_passcode = false;
    std::string owner{};  ///< As shown; empty once they have left for good.
    friend bool operator==(const TableRow&, const TableRow&) = default;
};

/// Answer to Hello. table: the seat or stand that the token still holds; a snapshot follows.
struct Welcome {
    std::string name;
    ResumeToken token{};  ///< Replaces the one in Hello.
    std::int64_t server_time_us = 0;
    std::optional<TableId> table;
    friend bool operator==(const Welcome&, const Welcome&) = default;
};
struct Refused {
    RefusedCode code = RefusedCode::Malformed;
    std::optional<match::RefusalCode> match_code;
    std::string detail;
    std::uint32_t in_reply_to = 0;  ///< The request_id; 0 for none.
    friend bool operator==(const Refused&, const Refused&) = default;
};
struct TableList {
    std::vector<TableRow> tables;
    friend bool operator==(const TableList&, const TableList&) = default;
};

/// When the seat to act may act, and until when: on the server's clock.
struct Turn {
    std::int64_t opens_us = 0;
    std::optional<std::int64_t> deadline_us;  ///< None: no clock, or not yet running.
    friend bool operator==(const Turn&, const Turn&) = default;
};

/// One shot as everybody gets it. `after` is the match once it was judged.
struct ShotPlayed {
    std::uint64_t sequence = 0;
    std::int64_t struck_us = 0;  ///< Server time of the strike.
    model::Seat seat = model::Seat::First;
    std::uint64_t shot_id = 0;
    model::Shot shot;
    model::Call call;
    timeline::ShotRecord record;  ///< Its segments went through 32-bit floats; its hash did not.
    rules::Verdict verdict;
    match::MatchState after;  ///< Without its seed.
    Turn turn;
    std::uint32_t commit_us = 0;  ///< How long the storage took to make it durable.
    friend bool operator==(const ShotPlayed&, const ShotPlayed&) = default;
};

/// Everything a newcomer needs.
struct TableSnapshot {
    std::uint64_t sequence = 0;
    TableRow row;
    std::vector<model::Seat> your_seats;     ///< Empty for a spectator.
    std::optional<match::MatchState> match;  ///< None before the first match.
    std::optional<ShotPlayed> rolling;       ///< The last shot, while its balls still roll.
    Turn turn;
    std::int64_t server_time_us = 0;
    std::uint64_t stream = 0;  ///< Of these sequence numbers: another one after a restart.
    friend bool operator==(const TableSnapshot&, const TableSnapshot&) = default;
};
struct SeatChanged {
    std::uint64_t sequence = 0;
    model::PerSeat<SeatView> seats;
    std::uint32_t spectators = 0;
    friend bool operator==(const SeatChanged&, const SeatChanged&) = default;
};
struct MatchStarted {
    std::uint64_t sequence = 0;
    match::MatchState state;
    Turn turn;
    friend bool operator==(const MatchStarted&, const MatchStarted&) = default;
};
struct CueBallPlaced {
    std::uint64_t sequence = 0;
    model::Seat seat = model::Seat::First;
    base::Vec2 position_m{};
    friend bool operator==(const CueBallPlaced&, const CueBallPlaced&) = default;
};
struct AimShown {
    model::Seat seat = model::Seat::First;
    model::TurnNumber turn;
    model::Shot shot;
    friend bool operator==(const AimShown&, const AimShown&) = default;
};
/// The turn that the last step announced is open now: the balls rest, or all have seen it.
struct TurnOpened {
    std::uint64_t sequence = 0;
    model::TurnNumber number;
    Turn turn;
    friend bool operator==(const TurnOpened&, const TurnOpened&) = default;
};
/// What moved a match on without a shot.
enum class Move : std::uint8_t {
    Choice,
    Timeout,
    Concession,
    Forfeit,  ///< `seat` stayed away, and its opponent has claimed the match.
    Extension,
    Offer,
    Acceptance,  ///< Of an offer.
    Rejection,
    StalemateClaim,
    Spotting,
    Placing,  ///< Of any ball, in practice; the rest likewise.
    Undoing,
    Repeating,
    Reracking,
};
struct MatchMoved {
    std::uint64_t sequence = 0;
    model::Seat seat = model::Seat::First;
    std::optional<rules::Choice> choice;    ///< What was chosen.
    std::optional<rules::Verdict> verdict;  ///< The ruling of a clock that ran out.
    match::MatchState after;
    Turn turn;
    Move move = Move::Choice;
    friend bool operator==(const MatchMoved&, const MatchMoved&) = default;
};
enum class Ending : std::uint8_t {
    Played,  ///< Won, or drawn by agreement.
    Conceded,
    Claimed,    ///< The loser stayed away.
    Abandoned,  ///< Nobody came back to it; it has no winner.
};
struct MatchOver {
    std::uint64_t sequence = 0;
    std::optional<model::Seat> winner;  ///< None after a draw or practice.
    model::PerSeat<int> racks_won;
    std::uint32_t shots = 0;
    Ending ending = Ending::Played;
    friend bool operator==(const MatchOver&, const MatchOver&) = default;
};
struct ChatSaid {
    std::string name;
    std::string text;
    friend bool operator==(const ChatSaid&, const ChatSaid&) = default;
};

enum class NoticeCode : std::uint8_t {
    ShuttingDown,
    TableClosed,
    ReplacedByNewConnection,
    Kicked,  ///< Back to the lobby, by the table's owner.
};
struct Notice {
    NoticeCode code = NoticeCode::ShuttingDown;
    std::string detail;
    friend bool operator==(const Notice&, const Notice&) = default;
};
struct Pong {
    std::int64_t client_time_us = 0;
    std::int64_t server_time_us = 0;
    friend bool operator==(const Pong&, const Pong&) = default;
};

/// After Welcome, instead of a snapshot: nothing was missed but the events that follow at once.
struct Resumed {
    TableId table;
    std::vector<model::Seat> your_seats;
    std::int64_t server_time_us = 0;
    friend bool operator==(const Resumed&, const Resumed&) = default;
};
/// The owner changed what is played, or who may come in. Nobody is ready any more.
struct TableChanged {
    std::uint64_t sequence = 0;
    TableRow row;
    friend bool operator==(const TableChanged&, const TableChanged&) = default;
};
/// To whoever follows the list.
struct TableListChange {
    std::vector<TableRow> changed;  ///< New, or in place of the row with its number.
    std::vector<TableId> gone;
    friend bool operator==(const TableListChange&, const TableListChange&) = default;
};
struct InviteMade {
    TableId table;
    bool is_for_playing = false;  ///< Otherwise for watching.
    InviteSecret secret{};
    std::int64_t expires_us = 0;  ///< Server time.
    friend bool operator==(const InviteMade&, const InviteMade&) = default;
};
struct HistoryRow {
    std::uint64_t match = 0;
    std::int64_t ended_s = 0;  ///< Since 1970-01-01 UTC, by the server's calendar.
    rules::Game game = rules::Game::EightBall;
    model::PerSeat<std::string> names;
    model::PerSeat<int> racks_won;
    std::optional<model::Seat> winner;
    std::uint32_t shots = 0;
    Ending ending = Ending::Played;
    friend bool operator==(const HistoryRow&, const HistoryRow&) = default;
};
struct HistoryPage {
    std::vector<HistoryRow> rows;  ///< The newest first; at most kMaxHistoryRows.
    bool has_more = false;         ///< Before the last of them.
    friend bool operator==(const HistoryPage&, const HistoryPage&) = default;
};
/// Of matches between two players that did not end abandoned.
struct PlayerRecord {
    std::string name;
    std::uint32_t games = 0;
    std::uint32_t wins = 0;
    std::uint32_t draws = 0;
    double rating = 0.0;     ///< Glicko; of guests, so for information.
    double deviation = 0.0;  ///< Of the rating: the truth is within twice this, 19 times of 20.
    friend bool operator==(const PlayerRecord&, const PlayerRecord&) = default;
};
/// Steps of a match, told as they were when it was played: MatchStarted first, then CueBallPlaced,
/// ShotPlayed and MatchMoved; their sequence is the step, and their times count from 0.
struct ReplayChunk {
    std::uint64_t match = 0;
    std::uint64_t first = 0;  ///< The step of the first message.
    std::uint64_t total = 0;  ///< So many steps there are now, with how it began.
    std::vector<std::vector<std::byte>> messages;  ///< For decode_server.
    friend bool operator==(const ReplayChunk&, const ReplayChunk&) = default;
};

}  // namespace server

using ServerMessage =
    std::variant<server::Welcome, server::Refused, server::TableList, server::TableSnapshot,
                 server::SeatChanged, server::MatchStarted, server::CueBallPlaced, server::AimShown,
                 server::ShotPlayed, server::TurnOpened, server::MatchMoved, server::MatchOver,
                 server::ChatSaid, server::Notice, server::Pong, server::Resumed,
                 server::TableChanged, server::TableListChange, server::InviteMade,
                 server::HistoryPage, server::PlayerRecord, server::ReplayChunk>;

}  // namespace billiards::protocol
