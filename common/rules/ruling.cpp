// Takes rulings; gives the verdict of the first that applies.
#include "common/rules/ruling.h"

#include "common/base/check.h"

#include <algorithm>
#include <utility>

namespace billiards::rules {

Ruling win_for(model::Seat winner, bool applies, Reason reason) {
    return {applies, reason, winner, Zone::None, {}, true};
}

std::vector<Ruling> in_order(std::vector<Ruling> first, const std::vector<Ruling>& then) {
    first.insert(first.end(), then.begin(), then.end());
    return first;
}

Verdict verdict_of(const RackState& state, std::vector<Foul> fouls,
                   std::span<const Ruling> rulings) {
    const auto ruling = std::ranges::find_if(rulings, &Ruling::applies);
    CHECK(ruling != rulings.end());
    Verdict verdict;
    verdict.fouls = std::move(fouls);
    verdict.reason = ruling->reason;
    verdict.next_player = ruling->next_player;
    verdict.turn_continues =
        ruling->next_player == state.shooter && ruling->choices.empty() && !ruling->ends_rack;
    verdict.in_hand = ruling->in_hand;
    verdict.choices = ruling->choices;
    if (!verdict.choices.empty()) verdict.chooser = ruling->next_player;
    if (ruling->ends_rack) verdict.winner = ruling->next_player;
    verdict.groups = state.groups;
    verdict.consecutive_fouls = state.consecutive_fouls;
    verdict.phase = state.phase;
    return verdict;
}

}  // namespace billiards::rules
