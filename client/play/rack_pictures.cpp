// Takes a table before and after a message; gives which moments of its last shot to draw.
#include "client/play/rack_pictures.h"

#include <algorithm>
#include <fmt/format.h>

namespace billiards::client {

namespace {

/// The rack is open by then, and still rolls.
constexpr double kIntoBreak_s = 0.6;

bool is_half_down(const model::Layout& layout) {
    const auto left = std::ranges::count_if(layout.balls, [](const model::PlacedBall& placed) {
        return placed.ball != model::kCueBall && placed.place == model::Place::OnTable;
    });
    return 2 * left <= std::ssize(layout.balls) - 1;
}

}  // namespace

std::vector<DuePicture> RackPictures::due(const TableView& before, const TableView& after) {
    if (!before.match) return {};
    std::vector<DuePicture> found;
    const auto add = [&](const char* what, std::optional<double> at_s) {
        const std::string name = fmt::format("rack{}-{}", before.match->rack_number, what);
        if (taken_.insert(name).second) found.push_back({.name = name, .at_s = at_s});
    };
    if (after.last_shot &&
        (!before.last_shot || before.last_shot->sequence != after.last_shot->sequence)) {
        const protocol::server::ShotPlayed& shot = *after.last_shot;
        const double half_s = shot.record.duration_s / 2;
        const bool wins = shot.verdict.winner.has_value();
        const bool is_break = before.match->rack.phase == rules::Phase::Break;
        if (is_break) add("break", std::min(kIntoBreak_s, half_s));
        if (wins || is_half_down(shot.record.final_layout)) add("middle", half_s);
        // The last rack's end waits for the word that the match is over.
        if (wins && shot.after.stage != match::Stage::Over) add("end", std::nullopt);
    }
    if (after.over && !before.over) add("end", std::nullopt);
    return found;
}

}  // namespace billiards::client
