// Takes a match; gives how long its player may take.
#include "common/match/clock.h"

namespace billiards::match {

std::optional<double> allowance_s(const MatchState& match) {
    const Settings& settings = match.settings;
    if (match.stage == Stage::Over || settings.game == rules::Game::Practice) return std::nullopt;
    const bool is_break = match.rack.phase == rules::Phase::Break;
    const double clock_s = is_break ? settings.break_shot_clock_s : settings.shot_clock_s;
    if (clock_s <= 0.0) return std::nullopt;
    const bool is_extended = match.extended_in[match.to_act] == match.turn;
    return is_extended ? clock_s + settings.extension_s : clock_s;
}

std::optional<double> warning_after_s(const MatchState& match) {
    const std::optional<double> allowed_s = allowance_s(match);
    if (!allowed_s || *allowed_s <= kWarning_s) return std::nullopt;
    return *allowed_s - kWarning_s;
}

}  // namespace billiards::match
