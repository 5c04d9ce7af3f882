// Takes JSON; gives a ruling to be made, or a fault that names the field.
#include "tools/sim/read_ruling.h"

#include "common/base/random.h"
#include "common/model/table_spec.h"
#include "common/physics/simulate.h"
#include "common/rules/ruleset.h"
#include "tools/sim/words.h"

#include <algorithm>
#include <charconv>
#include <optional>
#include <string>

namespace billiards::tools {

namespace {

using model::BallId;
using model::BallSet;
using model::EventKind;
using model::PerSeat;
using model::ShotEvent;
using rules::Game;
using rules::Group;

constexpr int kObjectBalls = 15;
/// Of scores and of fouls in a row: beyond any match, and sums of it are far from what an int ends.
constexpr int kMaxCount = 1'000'000;

/// "cue", or an object ball as 5 or as "5".
BallId read_ball(const JsonNode& node) {
    int number = 0;
    if (node.is_text()) {
        const std::string text = node.text();
        if (text == "cue") return model::kCueBall;
        std::from_chars(text.data(), text.data() + text.size(), number);
        if (text != std::to_string(number)) number = 0;
    } else {
        number = node.integer(1, kObjectBalls);
    }
    if (number >= 1 && number <= kObjectBalls) return {static_cast<std::uint8_t>(number)};
    node.report("must be \"cue\" or a ball from 1 to 15");
    return {};
}

/// The object balls of a list.
BallSet read_balls(const JsonNode& node) {
    BallSet balls;
    for (const JsonNode& item : node.items()) balls.insert(read_ball(item));
    balls.erase(model::kCueBall);
    return balls;
}

BallSet full_rack(Game game) {
    base::Random any_order(0);
    const model::Layout layout = rules::ruleset_of(game).rack(
        {}, model::table_of(model::TableSize::NineFoot), model::BallSpec{}.radius_m, any_order);
    BallSet balls;
    for (const model::PlacedBall& placed : layout.balls) balls.insert(placed.ball);
    balls.erase(model::kCueBall);
    return balls;
}

model::PocketId read_pocket(const JsonNode& node) {
    return {static_cast<std::uint8_t>(node.integer(0, model::kPockets - 1))};
}

/// One value a seat.
std::vector<JsonNode> read_pair(const JsonNode& node) {
    std::vector<JsonNode> items = node.items();
    if (items.size() != model::kSeats.size()) node.report("must have one value a player");
    return items;
}

PerSeat<int> read_counts(const JsonNode& node, int least) {
    PerSeat<int> counts;
    if (!node.is_present()) return counts;
    const std::vector<JsonNode> items = read_pair(node);
    for (std::size_t i = 0; i < std::min(items.size(), counts.values.size()); ++i) {
        counts.values[i] = items[i].integer(least, kMaxCount);
    }
    return counts;
}

PerSeat<Group> read_groups(const JsonNode& node) {
    const PerSeat<Group> usual{{Group::Solids, Group::Stripes}};
    if (!node.is_present()) return usual;
    const std::vector<JsonNode> items = read_pair(node);
    if (items.size() != model::kSeats.size()) return usual;
    const PerSeat<Group> groups{{read_word<Group>(items[0]), read_word<Group>(items[1])}};
    if (groups.values[0] == groups.values[1]) node.report("must be one group a player");
    return groups;
}

rules::Options read_options(const JsonNode& node, const JsonNode& target) {
    rules::Options options;
    options.call = node["call"].truth_or(options.call);
    options.nine_on_foot_spot = node["nine_on_foot_spot"].truth_or(options.nine_on_foot_spot);
    options.ten_wins_any_time = node["ten_wins_any_time"].truth_or(options.ten_wins_any_time);
    if (target.is_present()) options.target_points = target.integer(1, rules::kMaxTargetPoints);
    return options;
}

rules::RackState read_state(const JsonNode& node, Game game) {
    rules::RackState state;
    state.phase = read_word_or(node["phase"], state.phase);
    if (node["shooter"].is_present() && node["shooter"].integer(0, 1) == 1) {
        state.shooter = model::Seat::Second;
    }
    const bool has_groups = game == Game::EightBall && state.phase == rules::Phase::Groups;
    if (has_groups) state.groups = read_groups(node["groups"]);
    const JsonNode on_table = node["on_table"];
    state.on_table = on_table.is_present() ? read_balls(on_table) : full_rack(game);
    const bool may_be_clear = game == Game::Practice;
    if (state.on_table.empty() && !may_be_clear) on_table.report("must have a ball to play");
    state.in_hand = read_word_or(node["in_hand"], state.in_hand);
    state.behind_head_string = read_balls(node["behind_head_string"]);
    state.consecutive_fouls = read_counts(node["consecutive_fouls"], 0);
    state.push_out_allowed = node["push_out_allowed"].truth_or(state.push_out_allowed);
    state.scores = read_counts(node["scores"], -kMaxCount);
    return state;
}

model::Call read_call(const JsonNode& node) {
    if (!node.is_present()) return model::NoCall{};
    if (node.is_text()) {
        if (node.one_of({"safety", "push-out"}) == 0) return model::Safety{};
        return model::PushOut{};
    }
    const BallId ball = read_ball(node["ball"]);
    if (ball == model::kCueBall) node["ball"].report("must be an object ball");
    return model::CalledBall{ball, read_pocket(node["pocket"])};
}

ShotEvent read_meeting(const JsonNode& node, double time_s) {
    const std::vector<JsonNode> items = node.items();
    if (items.size() != 2) {
        node.report("must be two balls");
        return {};
    }
    const BallId one = read_ball(items[0]);
    const BallId other = read_ball(items[1]);
    if (one == other) node.report("must be two different balls");
    return ShotEvent::ball_ball(time_s, one, other);
}

ShotEvent read_crossing(const JsonNode& node, double time_s) {
    const JsonNode direction = node["direction"];
    return ShotEvent::head_string(time_s, direction.is_present() ? direction.integer(-1, 1) : 1);
}

/// None where the rules take no notice of such an event.
std::optional<ShotEvent> read_event(const JsonNode& node) {
    const auto kind = read_word<EventKind>(node["kind"]);
    if (kind == EventKind::Motion || kind == EventKind::Landing) return std::nullopt;
    const double time_s = node["t"].number();
    if (time_s < 0) node["t"].report("must not be negative");
    if (kind == EventKind::BallBall) return read_meeting(node["balls"], time_s);
    const BallId ball = read_ball(node["ball"]);
    if (kind == EventKind::Pocketed) {
        return ShotEvent::pocketed(time_s, ball, read_pocket(node["pocket"]));
    }
    if (kind == EventKind::OffTable) return ShotEvent::off_table(time_s, ball);
    if (kind == EventKind::HeadString) {
        if (ball != model::kCueBall) return std::nullopt;
        return read_crossing(node, time_s);
    }
    const bool held = node["held"].truth_or(false);
    return kind == EventKind::Cushion ? ShotEvent::cushion(time_s, ball, 0, held)
                                      : ShotEvent::jaw(time_s, ball, 0, held);
}

std::vector<ShotEvent> read_events(const JsonNode& node) {
    if (!node.is_present()) node.report("is missing");
    const std::vector<JsonNode> items = node.items();
    if (items.size() > physics::kMaxEvents) {
        node.report("must be at most " + std::to_string(physics::kMaxEvents));
        return {};
    }
    std::vector<ShotEvent> events;
    for (const JsonNode& item : items) {
        if (const auto event = read_event(item)) events.push_back(*event);
    }
    std::ranges::stable_sort(events, {}, &ShotEvent::time_s);
    return events;
}

}  // namespace

RulingCase read_ruling(const JsonNode& node) {
    RulingCase ruling;
    ruling.game = read_word<Game>(node["game"]);
    ruling.options = read_options(node["options"], node["state"]["target"]);
    ruling.state = read_state(node["state"], ruling.game);
    ruling.call = read_call(node["call"]);
    ruling.events = read_events(node["events"]);
    return ruling;
}

}  // namespace billiards::tools
