// Takes the fields of a case; gives what the engine starts from.
#include "tools/sim/read_setup.h"

#include "common/base/elementary.h"

#include <array>
#include <limits>
#include <utility>

namespace billiards::tools {

namespace {

using base::Vec2;

constexpr double kEdgeBeyondCushions_m = 0.2;
constexpr double kNoseHeightOverDiameter = 0.635;

void read_models(const JsonNode& node, physics::Parameters& parameters) {
    const JsonNode ball_ball = node["ball_ball"];
    if (ball_ball["model"].is_present()) {
        constexpr std::array kModels{physics::BallBallModel::Frictional,
                                     physics::BallBallModel::Elastic};
        parameters.ball_ball = kModels[ball_ball["model"].one_of({"frictional", "elastic"})];
    }
    parameters.ball_ball_restitution =
        ball_ball["restitution"].number_or(parameters.ball_ball_restitution);
    const JsonNode cushion = node["cushion"];
    if (cushion["model"].is_present()) {
        constexpr std::array kModels{physics::CushionModel::Han2005, physics::CushionModel::Mirror};
        parameters.cushion = kModels[cushion["model"].one_of({"han2005", "mirror"})];
    }
    parameters.cushion_restitution =
        cushion["restitution"].number_or(parameters.cushion_restitution);
    parameters.cushion_friction = cushion["friction"].number_or(parameters.cushion_friction);
}

model::TableSpec named_table(const JsonNode& node) {
    const std::size_t which = node.one_of({"7ft", "8ft", "9ft", "open"});
    constexpr std::array kSizes{model::TableSize::SevenFoot, model::TableSize::EightFoot,
                                model::TableSize::NineFoot};
    return which < kSizes.size() ? model::table_of(kSizes[which]) : model::open_table();
}

void set_edge(model::TableSpec& table) {
    if (table.cushions.empty()) return;
    Vec2 low{std::numeric_limits<double>::infinity()};
    Vec2 high = -low;
    for (const model::CushionSegment& cushion : table.cushions) {
        low = glm::min(low, glm::min(cushion.from_m, cushion.to_m));
        high = glm::max(high, glm::max(cushion.from_m, cushion.to_m));
    }
    table.center_m = (low + high) / 2.0;
    table.half_outer_m = (high - low) / 2.0 + kEdgeBeyondCushions_m;
}

/// Fields of the engine that the contract calls by another name.
std::string contract_name(const std::string& detail) {
    constexpr std::array<std::pair<const char*, const char*>, 8> kNames{{
        {"ball_ball_restitution", "physics.ball_ball.restitution"},
        {"cushion_restitution", "physics.cushion.restitution"},
        {"cushion_friction", "physics.cushion.friction"},
        {"gravity_mps2", "physics.gravity_mps2"},
        {"sliding_friction", "physics.sliding_friction"},
        {"rolling_friction", "physics.rolling_friction"},
        {"spin_deceleration_radps2", "physics.spin_deceleration_radps2"},
        {"nose_height_m", "table.nose_height_m"},
    }};
    for (const auto& [engine, contract] : kNames) {
        if (detail == engine) return contract;
    }
    constexpr std::array<std::pair<const char*, const char*>, 6> kShot{{
        {"angle_rad", "shot.angle_deg"},
        {"power", "shot.power"},
        {"tip_left", "shot.offset"},
        {"tip_up", "shot.offset"},
        {"tip offset", "shot.offset"},
        {"elevation_rad", "shot.elevation_deg"},
    }};
    for (const auto& [engine, contract] : kShot) {
        if (detail == engine) return contract;
    }
    const bool is_of_table = detail.find('[') != std::string::npos;
    return is_of_table ? "table." + detail : detail;
}

const char* words_of(physics::ErrorCode code) {
    switch (code) {
        case physics::ErrorCode::NotFinite:
            return "is not finite";
        case physics::ErrorCode::OutOfRange:
            return "is out of range";
        case physics::ErrorCode::TooManyBalls:
            return "there must be 1 to 22";
        case physics::ErrorCode::DuplicateBall:
            return "is there twice";
        case physics::ErrorCode::Overlap:
            return "overlap";
        case physics::ErrorCode::OutsideTable:
            return "outside the table";
        case physics::ErrorCode::NoCueBall:
            return "there is no cue ball to strike";
        case physics::ErrorCode::Unsolvable:
            return "unsolvable";
    }
    return "";
}

}  // namespace

PhysicsSetup read_physics(const JsonNode& node) {
    PhysicsSetup setup;
    if (node["preset"].is_present() && node["preset"].one_of({"realistic", "classic"}) == 1) {
        setup.parameters = physics::classic_parameters();
    }
    physics::Parameters& p = setup.parameters;
    p.gravity_mps2 = node["gravity_mps2"].number_or(p.gravity_mps2);
    p.sliding_friction = node["sliding_friction"].number_or(p.sliding_friction);
    p.rolling_friction = node["rolling_friction"].number_or(p.rolling_friction);
    p.spin_deceleration_radps2 =
        node["spin_deceleration_radps2"].number_or(p.spin_deceleration_radps2);
    read_models(node, p);
    setup.ball.mass_kg = node["ball_mass_kg"].number_or(setup.ball.mass_kg);
    setup.ball.radius_m = node["ball_radius_m"].number_or(setup.ball.radius_m);
    return setup;
}

model::TableSpec read_table(const JsonNode& node, const model::BallSpec& ball) {
    if (!node.is_present() || node.is_text()) return named_table(node);
    model::TableSpec table;
    for (const JsonNode& cushion : node["cushions"].items()) {
        table.cushions.push_back({cushion["from"].pair(), cushion["to"].pair()});
    }
    for (const JsonNode& jaw : node["jaws"].items()) {
        table.jaws.push_back({jaw["center"].pair(), jaw["radius"].number()});
    }
    for (const JsonNode& pocket : node["pockets"].items()) {
        table.pockets.push_back({pocket["center"].pair(), pocket["radius"].number()});
    }
    table.nose_height_m =
        node["nose_height_m"].number_or(kNoseHeightOverDiameter * 2 * ball.radius_m);
    set_edge(table);
    return table;
}

std::vector<physics::BallStart> read_balls(const JsonNode& node, const BallNames& names,
                                           const model::BallSpec& usual) {
    std::vector<physics::BallStart> balls;
    for (const auto& [name, ball] : node.members()) {
        physics::BallStart& start = balls.emplace_back();
        start.ball = names.id_of(name);
        start.spec = {.radius_m = ball["radius_m"].number_or(usual.radius_m),
                      .mass_kg = ball["mass_kg"].number_or(usual.mass_kg)};
        start.position_m = ball["position_m"].triple(start.spec.radius_m);
        start.velocity_mps = ball["velocity_mps"].triple_or({});
        start.spin_radps = ball["spin_radps"].triple_or({});
    }
    return balls;
}

model::Shot read_shot(const JsonNode& node) {
    const Vec2 offset = node["offset"].pair_or({});
    return {.angle_rad = base::radians(node["angle_deg"].number()),
            .power = node["power"].number(),
            .tip_left = offset.x,
            .tip_up = offset.y,
            .elevation_rad = base::radians(node["elevation_deg"].number_or(0.0))};
}

void report(const physics::Error& error, const BallNames& names, Fault& fault) {
    fault.report(names.translated(contract_name(error.detail)), words_of(error.code));
}

}  // namespace billiards::tools
