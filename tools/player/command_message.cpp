// Takes a command; gives its message, one function each.
#include "tools/player/command_message.h"

#include "common/base/check.h"

#include <variant>

namespace billiards::tools {

namespace {

namespace client = protocol::client;

struct ToMessage {
    using Body = protocol::ClientMessageBody;
    model::TurnNumber turn;
    std::uint64_t shot_id;

    Body operator()(const match::PlaceCueBall& place) const {
        return client::PlaceCueBall{.turn = turn, .position_m = place.position_m};
    }
    Body operator()(const match::TakeShot& take) const {
        return client::TakeShot{
            .turn = take.turn, .shot_id = shot_id, .shot = take.shot, .call = take.call};
    }
    Body operator()(const match::Choose& choose) const {
        return client::Choose{.turn = choose.turn, .choice = choose.choice};
    }
    Body operator()(const match::Timeout&) const { return only_of_a_table(); }
    Body operator()(const match::Concede&) const { return client::Concede{}; }
    Body operator()(const match::Extend& extend) const { return client::Extend{extend.turn}; }
    Body operator()(const match::Offer& offer) const {
        return client::Offer{.turn = offer.turn, .kind = offer.kind};
    }
    Body operator()(const match::Answer& answer) const {
        return client::Answer{.turn = answer.turn, .accept = answer.accept};
    }
    Body operator()(const match::ClaimStalemate& claim) const {
        return client::ClaimStalemate{claim.turn};
    }
    Body operator()(const match::SpotNearest& spot) const { return client::SpotNearest{spot.turn}; }
    Body operator()(const match::PlaceBall& place) const {
        return client::PlaceBall{.ball = place.ball, .position_m = place.position_m};
    }
    Body operator()(const match::Undo&) const { return client::Undo{}; }
    Body operator()(const match::Repeat&) const { return client::Repeat{}; }
    Body operator()(const match::Rerack&) const { return client::Rerack{}; }
    Body operator()(const match::Forfeit&) const { return only_of_a_table(); }

    static Body only_of_a_table() {
        CHECK(false);
        return client::Concede{};
    }
};

}  // namespace

protocol::ClientMessageBody message_of(const match::Command& command, model::TurnNumber turn,
                                       std::uint64_t shot_id) {
    return std::visit(ToMessage{.turn = turn, .shot_id = shot_id}, command);
}

}  // namespace billiards::tools
