// Gives why a match does not take a command or its settings.
#pragma once

#include "common/base/result.h"

#include <cstdint>
#include <string>

namespace billiards::match {

/// The order is part of the wire format; only append.
enum class RefusalCode : std::uint8_t {
    BadSettings,
    MatchOver,
    NotYourTurn,
    StaleTurn,         ///< The turn number is not the current one.
    WrongStage,        ///< A shot while a choice is due, or the other way round.
    NotInHand,         ///< The cue ball may not be placed now.
    CueBallNotPlaced,  ///< It is in hand, and was not set down.
    BadPlacement,      ///< Outside the zone, over a pocket or cushion, or on another ball.
    BadShot,           ///< A number that makes no sense; detail names it.
    BadCall,           ///< This ball, pocket or call is not allowed now.
    BadChoice,         ///< Not one of those offered.
    Unsolvable,        ///< The engine gave up on this shot; nothing was played.
    BadOutcome,        ///< refold only: the journalled outcome does not belong to this command.
    NoExtension,       ///< No clock runs, extensions are off, or this rack's is used.
    BadOffer,          ///< Another offer stands, or there is nothing to play again yet.
    NoOffer,           ///< There is no offer of the opponent's to answer.
    BadClaim,          ///< A stalemate is claimed already, or there is nothing to play again yet.
    NotSpottable,      ///< Not in hand behind the head string, or a legal ball is before it.
    WrongGame,         ///< Of practice in a match of two, or the other way round.
    NothingToUndo,     ///< Practice has no earlier position, or no shot to repeat.
};

struct Refusal {
    RefusalCode code = RefusalCode::NotYourTurn;
    std::string detail;

    friend bool operator==(const Refusal&, const Refusal&) = default;
};

template <class T>
using Result = base::Result<T, Refusal>;

}  // namespace billiards::match
