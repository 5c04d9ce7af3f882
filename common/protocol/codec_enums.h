// Takes an enum of ours and gives the wire's, and back. For codec*.cpp only.
#pragma once

#include "common/base/check.h"
#include "common/match/match.h"
#include "common/match/match_state.h"
#include "common/model/ball.h"
#include "common/model/layout.h"
#include "common/model/seat.h"
#include "common/model/table_spec.h"
#include "common/protocol/codec_message.h"
#include "common/protocol/messages.h"
#include "common/rules/verdict.h"
#include "proto/client.capnp.h"
#include "proto/match.capnp.h"
#include "proto/model.capnp.h"
#include "proto/server.capnp.h"

#include <string_view>

namespace billiards::protocol {

/// Both sides number their enumerants alike. One line an enum: the last of each.
template <class Ours, class Wire>
struct Last {
    using WireType = Wire;
    Ours ours;
    Wire wire;
};
template <class Ours, class Wire>
Last(Ours, Wire) -> Last<Ours, Wire>;  // clang-14 does not find it by itself.

// clang-format off
constexpr auto last_of(model::Seat) { return Last{model::Seat::Second, wire::Seat::SECOND}; }
constexpr auto last_of(model::Motion) { return Last{model::Motion::OffTable, wire::Motion::OFF_TABLE}; }
constexpr auto last_of(model::Place) { return Last{model::Place::OffTable, wire::Place::OFF_TABLE}; }
constexpr auto last_of(model::TableSize) { return Last{model::TableSize::NineFoot, wire::TableSize::NINE_FOOT}; }
constexpr auto last_of(rules::Game) { return Last{rules::Game::Practice, wire::Game::PRACTICE}; }
constexpr auto last_of(rules::Group) { return Last{rules::Group::Stripes, wire::Group::STRIPES}; }
constexpr auto last_of(rules::Phase) { return Last{rules::Phase::AfterBreak, wire::Phase::AFTER_BREAK}; }
constexpr auto last_of(rules::Zone) { return Last{rules::Zone::BehindHeadString, wire::Zone::BEHIND_HEAD_STRING}; }
constexpr auto last_of(rules::Foul) { return Last{rules::Foul::BreakingFoul, wire::Foul::BREAKING_FOUL}; }
constexpr auto last_of(rules::Choice) { return Last{rules::Choice::PassBack, wire::Choice::PASS_BACK}; }
constexpr auto last_of(rules::Rerack) { return Last{rules::Rerack::Fifteen, wire::Rerack::FIFTEEN}; }
constexpr auto last_of(rules::Reason) { return Last{rules::Reason::Practice, wire::Reason::PRACTICE}; }
constexpr auto last_of(match::BreakOrder) { return Last{match::BreakOrder::Loser, wire::BreakOrder::LOSER}; }
constexpr auto last_of(match::PhysicsPreset) { return Last{match::PhysicsPreset::Classic, wire::PhysicsPreset::CLASSIC}; }
constexpr auto last_of(match::Stage) { return Last{match::Stage::Over, wire::Stage::OVER}; }
constexpr auto last_of(match::OfferKind) { return Last{match::OfferKind::Draw, wire::OfferKind::DRAW}; }
constexpr auto last_of(match::RefusalCode) { return Last{match::RefusalCode::NothingToUndo, wire::RefusalCode::NOTHING_TO_UNDO}; }
constexpr auto last_of(Role) { return Last{Role::BothSeats, wire::Role::BOTH_SEATS}; }
constexpr auto last_of(RefusedCode) { return Last{RefusedCode::Busy, wire::RefusedCode::BUSY}; }
constexpr auto last_of(server::NoticeCode) { return Last{server::NoticeCode::Kicked, wire::NoticeCode::KICKED}; }
constexpr auto last_of(server::Move) { return Last{server::Move::Reracking, wire::Move::RERACKING}; }
constexpr auto last_of(server::Ending) { return Last{server::Ending::Abandoned, wire::Ending::ABANDONED}; }
// clang-format on

template <class Ours>
using WireOf = typename decltype(last_of(Ours{}))::WireType;

template <class Ours>
WireOf<Ours> to_wire(Ours value) {
    constexpr auto last = last_of(Ours{});
    static_assert(static_cast<int>(last.ours) == static_cast<int>(last.wire));
    CHECK(value <= last.ours);
    return static_cast<WireOf<Ours>>(value);
}

/// An enumerant that this version does not have is UnknownKind.
template <class Ours>
Ours from_wire(WireOf<Ours> value, std::string_view field) {
    if (value > last_of(Ours{}).wire) fail(DecodeErrorCode::UnknownKind, field);
    return static_cast<Ours>(value);
}

}  // namespace billiards::protocol
