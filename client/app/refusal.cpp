// Takes the code of a refusal; gives what it means to whoever asked.
#include "client/app/refusal.h"

#include <string_view>

namespace billiards::client {

namespace {

using match::RefusalCode;
using protocol::RefusedCode;

/// "nothing to undo: no shot has been played", or the first half where there is no second.
std::string with_detail(std::string_view what, const std::string& detail) {
    std::string text(what);
    if (!detail.empty()) text.append(": ").append(detail);
    return text;
}

std::string words(RefusalCode code, const std::string& detail) {
    switch (code) {
        case RefusalCode::BadSettings:
            return with_detail("this cannot be played", detail);
        case RefusalCode::MatchOver:
            return "the match is over";
        case RefusalCode::NotYourTurn:
            return "it is the other player's turn";
        case RefusalCode::StaleTurn:
            return "that came too late: the turn is over";
        case RefusalCode::WrongStage:
            return detail.empty() ? "that is not what is due now" : detail;
        case RefusalCode::NotInHand:
            return "the cue ball is not in hand";
        case RefusalCode::CueBallNotPlaced:
            return "the cue ball must be set down first";
        case RefusalCode::BadPlacement:
            return with_detail("the ball may not lie there", detail);
        case RefusalCode::BadShot:
            return with_detail("this shot cannot be played", detail);
        case RefusalCode::BadCall:
            return with_detail("this may not be called", detail);
        case RefusalCode::BadChoice:
            return "this choice is not offered";
        case RefusalCode::Unsolvable:
            return "too much happens in this shot; nothing was played";
        case RefusalCode::BadOutcome:
            return "the server could not make sense of this; nothing was played";
        case RefusalCode::NoExtension:
            return with_detail("there is no extension", detail);
        case RefusalCode::BadOffer:
            return with_detail("this cannot be offered now", detail);
        case RefusalCode::NoOffer:
            return "there is no offer to answer";
        case RefusalCode::BadClaim:
            return with_detail("no stalemate can be claimed now", detail);
        case RefusalCode::NotSpottable:
            return with_detail("no ball is spotted now", detail);
        case RefusalCode::WrongGame:
            return with_detail("not in this game", detail);
        case RefusalCode::NothingToUndo:
            return detail.empty() ? "there is nothing to undo" : detail;
    }
    return detail;
}

}  // namespace

std::string words(const protocol::server::Refused& refused) {
    const std::string& detail = refused.detail;
    switch (refused.code) {
        case RefusedCode::Malformed:
            return "the server did not understand what was asked of it";
        case RefusedCode::NotInThisPhase:
            return "that cannot be done now";
        case RefusedCode::TooMany:
            return with_detail("too much or too often", detail);
        case RefusedCode::GreetingTimeout:
            return "the server heard no greeting in time";
        case RefusedCode::IdleTimeout:
            return "the server heard nothing for too long";
        case RefusedCode::BadName:
            return "this name cannot be used: it is empty, too long or no text";
        case RefusedCode::UnknownToken:
            return "the server does not know this player any more";
        case RefusedCode::UnknownTable:
            return "there is no such table";
        case RefusedCode::SeatTaken:
            return "both seats are taken";
        case RefusedCode::TableFull:
            return "there is no room left to watch";
        case RefusedCode::TooEarly:
            return "the balls are still rolling";
        case RefusedCode::MatchRunning:
            return "not while a match is played";
        case RefusedCode::StorageFailed:
            return "the server cannot store anything now; the last step was undone";
        case RefusedCode::ShuttingDown:
            return "the server is going down";
        case RefusedCode::Match:
            return refused.match_code ? words(*refused.match_code, detail) : detail;
        case RefusedCode::NotOwner:
            return "only the owner of the table may do that";
        case RefusedCode::WrongSecret:
            return "this invite or passcode does not open the table, or no longer";
        case RefusedCode::NotAllowed:
            return detail.empty() ? "that is not allowed now" : detail;
        case RefusedCode::UnknownPlayer:
            return "there is nobody of this name";
        case RefusedCode::UnknownMatch:
            return "this match is not kept, or not yours to see";
        case RefusedCode::Busy:
            return "the server is busy; ask again in a moment";
    }
    return detail;
}

}  // namespace billiards::client
