// Gives everything that a seat may ask of a match. Values only.
#pragma once

#include "common/base/vec.h"
#include "common/model/ball.h"
#include "common/model/seat.h"
#include "common/model/shot.h"
#include "common/rules/verdict.h"

#include <cstdint>
#include <variant>

namespace billiards::match {

// The order of every enum and variant here is part of the journal's format; only append. A command
// names the turn that it was meant for where another one's step could change what it means.

struct PlaceCueBall {
    base::Vec2 position_m{};
    friend bool operator==(const PlaceCueBall&, const PlaceCueBall&) = default;
};
struct TakeShot {
    model::TurnNumber turn;
    model::Shot shot;
    model::Call call;
    friend bool operator==(const TakeShot&, const TakeShot&) = default;
};
struct Choose {
    model::TurnNumber turn;
    rules::Choice choice = rules::Choice::Accept;
    friend bool operator==(const Choose&, const Choose&) = default;
};
/// From the clock, on behalf of the seat that is to act.
struct Timeout {
    model::TurnNumber turn;
    friend bool operator==(const Timeout&, const Timeout&) = default;
};
/// Ends the match for the other seat, or the practice. It names no turn: whoever gives up does so
/// whatever has happened meanwhile.
struct Concede {
    friend bool operator==(Concede, Concede) = default;
};
/// More time for this turn: once a rack for each seat.
struct Extend {
    model::TurnNumber turn;
    friend bool operator==(const Extend&, const Extend&) = default;
};

enum class OfferKind : std::uint8_t {
    Stalemate,  ///< The rack is played again.
    Draw,       ///< The match ends, and nobody has won it.
};
/// By either seat, at any time. It stands until it is answered or the turn ends: with the next
/// shot, choice or timeout. One stands at a time.
struct Offer {
    model::TurnNumber turn;
    OfferKind kind = OfferKind::Stalemate;
    friend bool operator==(const Offer&, const Offer&) = default;
};
/// By the seat that did not make the offer.
struct Answer {
    model::TurnNumber turn;
    bool accept = false;
    friend bool operator==(const Answer&, const Answer&) = default;
};
/// By the seat that is to shoot: unless a ball falls or a foul is played in the next three turns
/// of each seat, the rack is played again.
struct ClaimStalemate {
    model::TurnNumber turn;
    friend bool operator==(const ClaimStalemate&, const ClaimStalemate&) = default;
};
/// In hand behind the head string where every legal ball lies behind it too: the one nearest to
/// it is spotted on the foot spot.
struct SpotNearest {
    model::TurnNumber turn;
    friend bool operator==(const SpotNearest&, const SpotNearest&) = default;
};

// Practice only. None names a turn: nobody else is there.

/// Any ball of the game, wherever it is, to any free place.
struct PlaceBall {
    model::BallId ball;
    base::Vec2 position_m{};
    friend bool operator==(const PlaceBall&, const PlaceBall&) = default;
};
/// What the last shot, PlaceBall, Repeat or Rerack did; at most kMostUndone of them in a row.
struct Undo {
    friend bool operator==(Undo, Undo) = default;
};
/// The balls back to where they lay before the last shot.
struct Repeat {
    friend bool operator==(Repeat, Repeat) = default;
};
struct Rerack {
    friend bool operator==(Rerack, Rerack) = default;
};

/// From the table, on behalf of a seat whose player stayed away for too long, when the other seat
/// claims the match. Whether that is so is the table's to know. It names no turn, as Concede.
struct Forfeit {
    friend bool operator==(Forfeit, Forfeit) = default;
};

/// Everything that can move a match on.
using Command =
    std::variant<PlaceCueBall, TakeShot, Choose, Timeout, Concede, Extend, Offer, Answer,
                 ClaimStalemate, SpotNearest, PlaceBall, Undo, Repeat, Rerack, Forfeit>;

}  // namespace billiards::match
