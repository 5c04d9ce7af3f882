// Gives matches that two bots have played, as replays.
#include "tests/common/replay/bot_match.h"

#include "common/base/check.h"
#include "common/base/random.h"
#include "common/bot/choose.h"
#include "common/match/match.h"
#include "common/replay/verify.h"

#include <utility>

namespace billiards::replay {

Replay bot_match(const match::Settings& settings, std::uint64_t seed, std::size_t most_entries) {
    constexpr double kUnsteady_rad = 0.01;
    base::Random random(seed);
    Replay replay;
    replay.header.settings = settings;
    replay.header.seed = seed;
    replay.header.players = {{"Ada#3f21", "Grace#84ac"}};
    replay.header.table = "Friday";
    replay.header.started_s = 1'795'260'600;
    auto started = match::start(settings, seed);
    CHECK(started.ok());
    match::MatchState state = std::move(started).value();
    while (state.stage != match::Stage::Over && replay.entries.size() < most_entries) {
        match::Command command = bot::choose(state, random);
        if (auto* take = std::get_if<match::TakeShot>(&command)) {
            take->shot.angle_rad += random.uniform(-kUnsteady_rad, kUnsteady_rad);
        }
        const model::Seat seat = state.to_act;
        auto step = match::apply(state, seat, command);
        CHECK(step.ok());
        replay.entries.push_back(
            kept(seat, command, replay.entries.size() + 1, step->outcome).value());
        state = std::move(step).value().next;
    }
    return replay;
}

}  // namespace billiards::replay
