// Takes a step of a match; gives how the protocol calls it.
#include "common/protocol/moves.h"

#include "common/base/check.h"

#include <variant>

namespace billiards::protocol {
namespace {

using server::Move;

struct MoveOf {
    Move operator()(const match::PlaceCueBall&) const { CHECK(false); }
    Move operator()(const match::TakeShot&) const { CHECK(false); }
    Move operator()(const match::Choose&) const { return Move::Choice; }
    Move operator()(const match::Timeout&) const { return Move::Timeout; }
    Move operator()(const match::Concede&) const { return Move::Concession; }
    Move operator()(const match::Forfeit&) const { return Move::Forfeit; }
    Move operator()(const match::Extend&) const { return Move::Extension; }
    Move operator()(const match::Offer&) const { return Move::Offer; }
    Move operator()(const match::Answer& answer) const {
        return answer.accept ? Move::Acceptance : Move::Rejection;
    }
    Move operator()(const match::ClaimStalemate&) const { return Move::StalemateClaim; }
    Move operator()(const match::SpotNearest&) const { return Move::Spotting; }
    Move operator()(const match::PlaceBall&) const { return Move::Placing; }
    Move operator()(const match::Undo&) const { return Move::Undoing; }
    Move operator()(const match::Repeat&) const { return Move::Repeating; }
    Move operator()(const match::Rerack&) const { return Move::Reracking; }
};

}  // namespace

server::Move move_of(const match::Command& command) {
    return std::visit(MoveOf{}, command);
}

server::Ending ending_of(const match::Command& last) {
    if (std::holds_alternative<match::Concede>(last)) return server::Ending::Conceded;
    if (std::holds_alternative<match::Forfeit>(last)) return server::Ending::Claimed;
    return server::Ending::Played;
}

}  // namespace billiards::protocol
