// Takes rulings; gives the sentences that people read.
#pragma once

#include "client/app/client_state.h"
#include "client/app/rule_words.h"
#include "common/model/seat.h"
#include "common/protocol/messages.h"

#include <string>

namespace billiards::client {

// Each takes the table as it was before the message. A name stands in full where a sentence opens,
// and without its discriminator after that, unless both players are called the same.

/// "rack 1, shot 7: Ada#12ab called 5 in pocket 2: pocketed 5; Ada continues"
std::string narrate(const TableView& before, const protocol::server::ShotPlayed& shot);
/// "rack 2, after shot 31: Ada#12ab chose to re-rack and break; Ada to break"
std::string narrate(const TableView& before, const protocol::server::MatchMoved& moved);
/// "Ada#12ab wins the match 2-1: Grace stayed away"
std::string narrate(const TableView& before, const protocol::server::MatchOver& over);

/// The same without their numbers: "Ada#12ab called 5 in pocket 2: pocketed 5; Ada continues"
std::string tell(const TableView& before, const protocol::server::ShotPlayed& shot);
std::string tell(const TableView& before, const protocol::server::MatchMoved& moved);

/// The name of a seat's player with its discriminator; "Player 1" and "Player 2" where one session
/// has both seats.
std::string full_name(const TableView& table, model::Seat seat);
/// The name of a seat's player as it is said in passing.
std::string short_name(const TableView& table, model::Seat seat);

}  // namespace billiards::client
