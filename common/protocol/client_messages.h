// Gives everything that a client may say, as plain values.
#pragma once

#include "common/base/vec.h"
#include "common/match/command.h"
#include "common/match/settings.h"
#include "common/model/ball.h"
#include "common/model/seat.h"
#include "common/model/shot.h"
#include "common/protocol/identity.h"
#include "common/rules/verdict.h"

#include <cstdint>
#include <optional>
#include <string>
#include <variant>

namespace billiards::protocol {

// The order of every enum and variant here is part of the wire format; only append.

/// What the client says of itself and asks, client to server.
namespace client {

/// How far a client had followed its table when it lost its link.
struct Followed {
    TableId table;
    std::uint64_t stream = 0;    ///< TableSnapshot's.
    std::uint64_t sequence = 0;  ///< Of the last event that it knows.
    friend bool operator==(const Followed&, const Followed&) = default;
};
/// The first message. With a token: come back as the player who was given it. With `followed`, the
/// server sends only what happened since, where it still has that: Resumed instead of a snapshot.
struct Hello {
    std::string name;  ///< At most kMaxNameLength code points; the server cleans it.
    std::optional<ResumeToken> token;
    std::optional<Followed> followed{};
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
    bool is_private = false;  ///< In no list, and open only to invites and the passcode.
    std::string passcode{};   ///< At most kMaxPasscodeLength code points; empty: none.
    friend bool operator==(const CreateTable&, const CreateTable&) = default;
};
/// Answered by a TableSnapshot.
struct Join {
    TableId table;
    Role role = Role::Player;
    std::optional<InviteSecret> invite{};
    std::string passcode{};
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
struct Chat {
    std::string text;  ///< At most kMaxChatLength code points.
    friend bool operator==(const Chat&, const Chat&) = default;
};
struct Ping {
    std::int64_t client_time_us = 0;  ///< Returned untouched.
    friend bool operator==(const Ping&, const Ping&) = default;
};

// The lobby and the table.

/// As ListTables, and from then on every change of the list, until the session takes a place.
struct FollowTables {
    friend bool operator==(FollowTables, FollowTables) = default;
};
/// A seat at a public table where somebody waits for this game, else at a new one.
struct QuickMatch {
    rules::Game game = rules::Game::EightBall;
    friend bool operator==(const QuickMatch&, const QuickMatch&) = default;
};
/// By the owner, while no match runs: the next one is played so. Whoever was ready is asked again.
struct ChangeTable {
    match::Settings settings;
    bool is_private = false;
    std::optional<std::string> passcode;  ///< None: as it is. Empty: none from now on.
    friend bool operator==(const ChangeTable&, const ChangeTable&) = default;
};
/// By the owner: a secret that opens the table to play (once) or to watch. Answered by InviteMade.
struct MakeInvite {
    Role role = Role::Player;  ///< Not BothSeats.
    friend bool operator==(const MakeInvite&, const MakeInvite&) = default;
};
/// By the owner: no invite that was made so far is good any more.
struct RevokeInvites {
    friend bool operator==(RevokeInvites, RevokeInvites) = default;
};
/// By the owner: a spectator, or a player while no match runs, who cannot come back to this table.
struct Kick {
    std::string name;  ///< As shown, with its discriminator.
    friend bool operator==(const Kick&, const Kick&) = default;
};
/// Once a match is over: ready for the next between the same two.
struct Rematch {
    friend bool operator==(Rematch, Rematch) = default;
};
/// By a player whose opponent has been away for longer than the grace: ends the match for them.
struct ClaimMatch {
    friend bool operator==(ClaimMatch, ClaimMatch) = default;
};

// What a match takes beside shots, as it takes it.

using match::Answer;
using match::Choose;
using match::ClaimStalemate;
using match::Concede;
using match::Extend;
using match::Offer;
using match::PlaceBall;
using match::Repeat;
using match::Rerack;
using match::SpotNearest;
using match::Undo;

// What has been played.

/// Matches that are over, the newest first; answered by a HistoryPage.
struct AskHistory {
    std::string player;        ///< As shown; empty: everybody.
    std::uint64_t before = 0;  ///< Only matches with a lower number; 0: from the newest on.
    friend bool operator==(const AskHistory&, const AskHistory&) = default;
};
/// Answered by a PlayerRecord.
struct AskRecord {
    std::string player;  ///< As shown; empty: one's own.
    friend bool operator==(const AskRecord&, const AskRecord&) = default;
};
/// A match from any of its steps on: to rewind the one at one's table, or to see one that is over.
/// Answered by a ReplayChunk.
struct AskReplay {
    std::uint64_t match = 0;  ///< 0: the one at one's table, or the last one there.
    std::uint64_t first = 0;  ///< The step to begin with; 0: how it began.
    friend bool operator==(const AskReplay&, const AskReplay&) = default;
};

}  // namespace client

using ClientMessageBody =
    std::variant<client::Hello, client::ListTables, client::CreateTable, client::Join,
                 client::Leave, client::Ready, client::PlaceCueBall, client::Aim, client::TakeShot,
                 client::Seen, client::Choose, client::Concede, client::Chat, client::Ping,
                 client::QuickMatch, client::ChangeTable, client::MakeInvite, client::RevokeInvites,
                 client::Kick, client::Rematch, client::Extend, client::Offer, client::Answer,
                 client::ClaimStalemate, client::SpotNearest, client::ClaimMatch, client::PlaceBall,
                 client::Undo, client::Repeat, client::Rerack, client::AskHistory,
                 client::AskRecord, client::AskReplay, client::FollowTables>;

/// One frame from a client. request_id is its own count; Refused gives it back.
struct ClientMessage {
    std::uint32_t request_id = 0;
    ClientMessageBody body;
    friend bool operator==(const ClientMessage&, const ClientMessage&) = default;
};

}  // namespace billiards::protocol
