// Takes a case of balls on a table; gives its events, samples, energy and hash.
#include "tools/sim/solve.h"

#include "common/base/hex.h"
#include "common/physics/cue.h"
#include "common/physics/simulate.h"
#include "common/timeline/evaluate.h"
#include "tools/sim/ball_names.h"
#include "tools/sim/read_setup.h"
#include "tools/sim/words.h"

#include <algorithm>
#include <string>
#include <vector>

namespace billiards::tools {

namespace {

using model::EventKind;

constexpr double kMostTime_s = 1e9;

Json event_of(const model::ShotEvent& event, const BallNames& names) {
    Json json{{"t", event.time_s}, {"kind", word_of(event.kind)}};
    if (event.kind == EventKind::BallBall) {
        json["balls"] = {names.name_of(event.ball), names.name_of(event.other)};
        return json;
    }
    json["ball"] = names.name_of(event.ball);
    if (event.kind == EventKind::Cushion || event.kind == EventKind::Jaw) {
        json["index"] = event.index;
        if (event.held) json["held"] = true;
    } else if (event.kind == EventKind::Pocketed) {
        json["pocket"] = event.index;
    } else if (event.kind == EventKind::Motion) {
        json["to"] = word_of(event.to);
    } else if (event.kind == EventKind::HeadString) {
        json["direction"] = event.direction;
    }
    return json;
}

Json sample_at(const timeline::ShotRecord& record, double time_s, const BallNames& names) {
    Json balls = Json::object();
    for (const timeline::BallTrack& track : record.timeline.tracks) {
        const model::BallState state = timeline::evaluate(track, time_s);
        balls[names.name_of(track.ball)] = {{"position_m", json_of(state.position_m)},
                                            {"velocity_mps", json_of(state.velocity_mps)},
                                            {"spin_radps", json_of(state.spin_radps)},
                                            {"motion", word_of(state.motion)}};
    }
    return {{"t", time_s}, {"balls", std::move(balls)}};
}

Json final_of(const timeline::ShotRecord& record, const BallNames& names) {
    Json balls = Json::object();
    for (const timeline::BallTrack& track : record.timeline.tracks) {
        const model::BallState state = timeline::evaluate(track, record.duration_s);
        balls[names.name_of(track.ball)] = {{"position_m", json_of(state.position_m)},
                                            {"motion", word_of(state.motion)}};
    }
    return balls;
}

/// Gives the ball named "cue" what the cue gives it.
void strike_cue_ball(const JsonNode& node, const physics::Parameters& parameters,
                     const BallNames& names, std::vector<physics::BallStart>& balls) {
    const auto cue_ball = std::find_if(
        balls.begin(), balls.end(),
        [&](const physics::BallStart& ball) { return names.name_of(ball.ball) == "cue"; });
    if (cue_ball == balls.end()) return node.report("there is no ball named cue");
    const model::Shot shot = read_shot(node);
    if (const auto valid = physics::validate(shot); !valid) {
        return report_shot(valid.error(), node);
    }
    const physics::Strike struck =
        physics::strike(parameters, cue_ball->spec, shot,
                        physics::cue_speed_mps(parameters, cue_ball->spec, shot.power));
    cue_ball->velocity_mps = struck.velocity_mps;
    cue_ball->spin_radps = struck.spin_radps;
}

Json answer_of(const timeline::ShotRecord& record, const physics::Diagnostics& diagnostics,
               const std::vector<double>& sample_times_s, const BallNames& names) {
    Json answer{{"duration_s", record.duration_s}, {"events", Json::array()}};
    for (const model::ShotEvent& event : record.events) {
        answer["events"].push_back(event_of(event, names));
    }
    answer["final"] = final_of(record, names);
    answer["samples"] = Json::array();
    for (const double time_s : sample_times_s) {
        answer["samples"].push_back(sample_at(record, time_s, names));
    }
    answer["max_energy_rise_j"] = diagnostics.max_energy_rise_j;
    answer["min_gap_m"] = nullptr;
    if (diagnostics.min_gap_m) answer["min_gap_m"] = *diagnostics.min_gap_m;
    answer["hash"] = base::to_hex(record.hash);
    return answer;
}

}  // namespace

Json solve(const JsonNode& input, Fault& fault) {
    const PhysicsSetup setup = read_physics(input["physics"]);
    const model::TableSpec table = read_table(input["table"], setup.ball);
    std::vector<std::string> ball_names;
    for (const auto& [name, ball] : input["balls"].members()) ball_names.push_back(name);
    if (ball_names.empty() || ball_names.size() > model::kMaxBalls) {
        fault.report("balls", "there must be 1 to " + std::to_string(model::kMaxBalls));
        return {};
    }
    const BallNames names(ball_names);
    std::vector<physics::BallStart> balls = read_balls(input["balls"], names, setup.ball);
    if (input["shot"].is_present() && !fault.is_found()) {
        strike_cue_ball(input["shot"], setup.parameters, names, balls);
    }
    std::vector<double> sample_times_s;
    for (const JsonNode& time : input["sample_times_s"].items()) {
        sample_times_s.push_back(time.number_in(0.0, kMostTime_s));
    }
    if (fault.is_found()) return {};

    physics::Diagnostics diagnostics;
    const auto record = physics::simulate(table, setup.parameters, balls, &diagnostics);
    if (!record) {
        report(record.error(), names, fault);
        return {};
    }
    return answer_of(*record, diagnostics, sample_times_s, names);
}

}  // namespace billiards::tools
