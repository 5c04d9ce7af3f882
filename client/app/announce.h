// Takes what happens around a match: who comes and goes, what is changed, made and kept; gives the
// sentences that people read.
#pragma once

#include "client/app/client_state.h"
#include "common/protocol/messages.h"

#include <cstdint>
#include <string>

namespace billiards::client {

// As in narrate.h: each takes the table as it was before the message; no capital, no full stop.

/// "Grace#3f21 is away", "Grace#3f21 is back; Ada#12ab is ready"; empty where only spectators
/// moved.
std::string tell(const TableView& before, const protocol::server::SeatChanged& changed);
/// "the table is changed: 9-ball, race to 5; only for invited people"
std::string tell(const TableView& before, const protocol::server::TableChanged& changed);
/// "Ada#12ab: good luck"
std::string tell(const ChatLine& line);
std::string tell(const protocol::server::Notice& notice);
/// "this invite lets one person play; it is good for 24 h"
std::string tell(const protocol::server::InviteMade& invite, std::int64_t server_now_us);
/// "8-ball: Ada#12ab beat Grace#3f21 3-1"
std::string tell(const protocol::server::HistoryRow& played);
/// "Ada#12ab: 3 of 5 matches won, 1 drawn; rating 1512 (+/- 120)"
std::string tell(const protocol::server::PlayerRecord& record);

/// How long a seat's player may still be away, for whoever sits opposite: "Grace is away: you may
/// claim the match in 43 s", "Grace is away: you may claim the match, or wait". Empty where that
/// player is here, or nothing can be claimed.
std::string absence_of(const TableView& table, model::Seat seat, std::int64_t server_now_us);

/// "8-ball", "straight pool", ...
std::string words(rules::Game game);
/// "9-ball, race to 5, 45 s a shot"
std::string words(const match::Settings& settings);

}  // namespace billiards::client
