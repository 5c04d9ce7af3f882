// Takes a table of rulings in order of rank; gives the verdict of the first that applies. Every
// game is written as such tables.
#pragma once

#include "common/model/seat.h"
#include "common/rules/verdict.h"

#include <span>
#include <vector>

namespace billiards::rules {

/// One line of a table of rulings.
struct Ruling {
    bool applies = false;
    Reason reason = Reason::NothingPotted;
    /// Whoever has a choice, or else plays on; the winner of a rack.
    model::Seat next_player = model::Seat::First;
    Zone in_hand = Zone::None;
    std::vector<Choice> choices = {};
    bool ends_rack = false;
};

/// A line that ends the rack.
Ruling win_for(model::Seat winner, bool applies, Reason reason);

/// One table made of two.
std::vector<Ruling> in_order(std::vector<Ruling> first, const std::vector<Ruling>& then);

/// The first ruling that applies; one does. Everything that a ruling does not name stays as it was
/// before the shot.
Verdict verdict_of(const RackState& state, std::vector<Foul> fouls,
                   std::span<const Ruling> rulings);

}  // namespace billiards::rules
