// Gives everything that may be said between a client and a server, as plain values. The codec
// turns them into bytes; nothing else knows how they look on the wire.
#pragma once

#include "common/base/vec.h"
#include "common/match/match.h"
#include "common/match/match_state.h"
#include "common/model/seat.h"
#include "common/model/shot.h"
#include "common/rules/verdict.h"
#include "common/timeline/shot_record.h"

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace billiards::protocol {

// The order of every enum and variant here is part of the wire format; only append.

struct TableId {
    std::uint32_t value = 0;
    friend auto operator<=>(TableId, TableId) = default;
};

/// 256 secret bits that let a player come back after a lost connection.
using ResumeToken = std::array<std::uint8_t, 32>;

enum class Role : std::uint8_t { Player, Spectator, BothSeats };

/// What the client says of itself and asks, client to server.
namespace client {

/// The first message. With a token: come back as the player who was given it.
struct Hello {
    std::string name;  ///< At most kMaxNameLength code points; the server cleans it.
    std::optional<ResumeToken> token;
    friend bool operator==(const Hello&, const Hello&) = default;
};
struct ListTables {
    friend bool operator==(ListTables, ListTables) = default;
};
/// Opens a table and takes `role` at it; answered by a TableSnapshot.
struct CreateTable {
    std::string name;
    match::Settings settings;
    Role role = Role::Player;
    friend bool operator==(const CreateTable&, const CreateTable&) = default;
};
/// Answered by a TableSnapshot.
struct Join {
    TableId table;
    Role role = Role::Player;
    friend bool operator==(const Join&, const Join&) = default;
};
/// Back to the lobby, answered by a TableList. Not during a match: Concede comes first.
struct Leave {
    friend bool operator==(Leave, Leave) = default;
};
/// The match starts when every seat is taken and ready.
struct Ready {
    friend bool operator==(Ready, Ready) = default;
};
struct PlaceCueBall {
    model::TurnNumber turn;
    base::Vec2 position_m{};
    friend bool operator==(const PlaceCueBall&, const PlaceCueBall&) = default;
};
/// Ephemeral: shown to the others, never stored, shed first under load.
struct Aim {
    model::TurnNumber turn;
    model::Shot shot;
    friend bool operator==(const Aim&, const Aim&) = default;
};
/// shot_id is chosen by the client and never used twice in a match: a repeat after a reconnect is
/// answered, not played again.
struct TakeShot {
    model::TurnNumber turn;
    std::uint64_t shot_id = 0;
    model::Shot shot;
    model::Call call;
    friend bool operator==(const TakeShot&, const TakeShot&) = default;
};
/// The player has watched the shot with this sequence number to its end.
struct Seen {
    std::uint64_t sequence = 0;
    friend bool operator==(const Seen&, const Seen&) = default;
};
struct Choose {
    model::TurnNumber turn;
    rules::Choice choice = rules::Choice::Accept;
    friend bool operator==(const Choose&, const Choose&) = default;
};
struct Concede {
    friend bool operator==(Concede, Concede) = default;
};
struct Chat {
    std::string text;  ///< At most kMaxChatLength code points.
    friend bool operator==(const Chat&, const Chat&) = default;
};
struct Ping {
    std::int64_t client_time_us = 0;  ///< Returned untouched.
    friend bool operator==(const Ping&, const Ping&) = default;
};

}  // namespace client

using ClientMessageBody =
    std::variant<client::Hello, client::ListTables, client::CreateTable, client::Join,
                 client::Leave, client::Ready, client::PlaceCueBall, client::Aim, client::TakeShot,
                 client::Seen, client::Choose, client::Concede, client::Chat, client::Ping>;

/// One frame from a client. request_id is its own count; Refused gives it back.
struct ClientMessage {
    std::uint32_t request_id = 0;
    ClientMessageBody body;
    friend bool operator==(const ClientMessage&, const ClientMessage&) = default;
};

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
    Match,  ///< match::Refusal; match_code says which.
};

/// What the server answers and announces, server to client.
namespace server {

struct SeatView {
    bool taken = false;
    bool connected = false;
    bool ready = false;
    std::string name;  ///< With its discriminator, such as "Ada#3f21".
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
/// A choice was made, the clock ran out, or a player conceded: the match moved on without a shot.
struct MatchMoved {
    std::uint64_t sequence = 0;
    model::Seat seat = model::Seat::First;
    std::optional<rules::Choice> choice;    ///< What was chosen.
    std::optional<rules::Verdict> verdict;  ///< The ruling of a clock that ran out.
    match::MatchState after;
    Turn turn;
    friend bool operator==(const MatchMoved&, const MatchMoved&) = default;
};
struct MatchOver {
    std::uint64_t sequence = 0;
    std::optional<model::Seat> winner;  ///< None after a draw or practice.
    model::PerSeat<int> racks_won;
    std::uint32_t shots = 0;
    bool conceded = false;
    friend bool operator==(const MatchOver&, const MatchOver&) = default;
};
struct ChatSaid {
    std::string name;
    std::string text;
    friend bool operator==(const ChatSaid&, const ChatSaid&) = default;
};

enum class NoticeCode : std::uint8_t { ShuttingDown, TableClosed, ReplacedByNewConnection };
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

}  // namespace server

using ServerMessage =
    std::variant<server::Welcome, server::Refused, server::TableList, server::TableSnapshot,
                 server::SeatChanged, server::MatchStarted, server::CueBallPlaced, server::AimShown,
                 server::ShotPlayed, server::TurnOpened, server::MatchMoved, server::MatchOver,
                 server::ChatSaid, server::Notice, server::Pong>;

}  // namespace billiards::protocol
