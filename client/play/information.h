// Takes a game; gives the sentences of the information box: what happened, and what follows.
#pragma once

#include "client/play/game.h"
#include "common/base/time.h"

#include <optional>
#include <string>
#include <vector>

namespace billiards::client {

/// What happened, the oldest first, and last what follows now: whose turn it is, with which group,
/// and what is to be done.
std::vector<std::string> information(const Game& game);

/// The last of them alone.
std::string what_follows(const Game& game);

/// What else is to be known now, a sentence each: who is away and until when, what is offered, who
/// wants a rematch, how late a watcher sees it. A whole second counts down.
std::vector<std::string> notes(const Game& game, base::Instant now);

/// Of a table in a list: "8-ball", "Ada 1 - 0 Grace", "race to 3", "playing, 2 watching".
struct RowText {
    std::string game;
    std::string players;
    std::string race;
    std::string state;
    friend bool operator==(const RowText&, const RowText&) = default;
};
RowText text_of(const protocol::server::TableRow& row);
/// Whether somebody who does not watch may sit down there.
bool has_room(const protocol::server::TableRow& row);

/// "2 : 1", of racks; at straight pool "45 : 30 of 100", of points.
std::string score_of(const TableView& table);

/// Whole seconds left to whoever is to act; none where no clock runs.
std::optional<int> seconds_left(const Game& game, base::Instant now);
/// So few that whoever is to act is warned.
bool is_low(int seconds_left);

}  // namespace billiards::client
