// Takes a verdict; gives its fields as words and numbers.
#include "tools/sim/verdict_json.h"

#include "tools/sim/words.h"

namespace billiards::tools {

namespace {

Json json_of(const std::optional<model::Seat>& seat) {
    return seat ? Json(static_cast<int>(*seat)) : Json();
}

Json json_of(const model::PerSeat<int>& numbers) {
    return Json(numbers.values);
}

Json json_of(const std::optional<model::PerSeat<rules::Group>>& groups) {
    if (!groups) return {};
    Json words = Json::array();
    for (const rules::Group group : groups->values) words.push_back(word_of(group));
    return words;
}

template <class Enum>
Json words_in(const std::vector<Enum>& values) {
    Json words = Json::array();
    for (const Enum value : values) words.push_back(word_of(value));
    return words;
}

}  // namespace

Json json_of(const rules::Verdict& verdict) {
    Json spotted = Json::array();
    for (const model::BallId ball : verdict.spotted) spotted.push_back(ball.number);
    const bool reracked = verdict.rerack != rules::Rerack::None;
    return {{"fouls", words_in(verdict.fouls)},
            {"turn_continues", verdict.turn_continues},
            {"next_player", static_cast<int>(verdict.next_player)},
            {"in_hand", word_of(verdict.in_hand)},
            {"choices", words_in(verdict.choices)},
            {"chooser", json_of(verdict.chooser)},
            {"groups", json_of(verdict.groups)},
            {"spotted", std::move(spotted)},
            {"winner", json_of(verdict.winner)},
            {"consecutive_fouls", json_of(verdict.consecutive_fouls)},
            {"score_change", json_of(verdict.score_change)},
            {"rerack", reracked ? Json(word_of(verdict.rerack)) : Json()},
            {"reason", word_of(verdict.reason)}};
}

}  // namespace billiards::tools
