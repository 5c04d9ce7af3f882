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
    Body operator()(const match::Timeout&) const { return only_of_a_table(); }
    Body operator()(const match::Forfeit&) const { return only_of_a_table(); }
    /// What the client says in the match's own words.
    Body operator()(Body command) const { return command; }

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
