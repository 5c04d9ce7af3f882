// Takes the fields of a case; gives what the engine starts from.
#include "tools/sim/read_setup.h"

#include "common/base/elementary.h"
#include "common/physics/validate.h"
#include "tools/sim/words.h"

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
    parameters.ball_ball = read_word_or(ball_ball["model"], parameters.ball_ball);
    parameters.ball_ball_restitution =
        ball_ball["restitution"].number_or(parameters.ball_ball_restitution);
    const JsonNode cushion = node["cushion"];
    parameters.cushion = read_word_or(cushion["model"], parameters.cushion);
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

/// The contract's name for a field of the engine, and the same name where it has no other.
template <std::size_t kCount>
std::string contract_name(const std::array<std::pair<const char*, const char*>, kCount>& names,
                          const std::string& detail) {
    for (const auto& [engine, contract] : names) {
        if (detail == engine) return contract;
    }
    return detail;
}

std::string physics_name(const std::string& detail) {
    constexpr std::array<std::pair<const char*, const char*>, 3> kNames{{
        {"ball_ball_restitution", "ball_ball.restitution"},
        {"cushion_restitution", "cushion.restitution"},
        {"cushion_friction", "cushion.friction"},
    }};
    return contract_name(kNames, detail);
}

std::string shot_name(const std::string& detail) {
    constexpr std::array<std::pair<const char*, const char*>, 5> kNames{{
        {"angle_rad", "angle_deg"},
        {"tip_left", "offset"},
        {"tip_up", "offset"},
        {"tip offset", "offset"},
        {"elevation_rad", "elevation_deg"},
    }};
    return contract_name(kNames, detail);
}

std::string table_name(const std::string& detail) {
    for (const char* part : {"cushions", "jaws", "pockets", "nose_height_m"}) {
        if (detail.starts_with(part)) return "table." + detail;
    }
    return detail;
}

const char* sentence_of(physics::ErrorCode code) {
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
    setup.ball = read_spec(node["ball_radius_m"], node["ball_mass_kg"], setup.ball);
    if (const auto valid = physics::validate(p); !valid) {
        node[physics_name(valid.error().detail)].report(sentence_of(valid.error().code));
    }
    return setup;
}

model::BallSpec read_spec(const JsonNode& radius, const JsonNode& mass,
                          const model::BallSpec& usual) {
    return {
        .radius_m =
            radius.number_in_or(usual.radius_m, physics::kLeastRadius_m, physics::kMostRadius_m),
        .mass_kg = mass.number_in_or(usual.mass_kg, physics::kLeastMass_kg, physics::kMostMass_kg)};
}

double read_nose_height(const JsonNode& node, double radius_m) {
    return node["nose_height_m"].number_or(kNoseHeightOverDiameter * 2 * radius_m);
}

model::TableSpec read_table(const JsonNode& node, const model::BallSpec& ball) {
    if (!node.is_present() || node.is_text()) return named_table(node);
    model::TableSpec table;
    if (node["cushions"].items().empty()) {
        node["cushions"].report("there must be some; a table without any is \"open\"");
    }
    for (const JsonNode& cushion : node["cushions"].items()) {
        table.cushions.push_back({cushion["from"].pair(), cushion["to"].pair()});
    }
    for (const JsonNode& jaw : node["jaws"].items()) {
        table.jaws.push_back({jaw["center"].pair(), jaw["radius"].number()});
    }
    for (const JsonNode& pocket : node["pockets"].items()) {
        table.pockets.push_back({pocket["center"].pair(), pocket["radius"].number()});
    }
    table.nose_height_m = read_nose_height(node, ball.radius_m);
    set_edge(table);
    return table;
}

std::vector<physics::BallStart> read_balls(const JsonNode& node, const BallNames& names,
                                           const model::BallSpec& usual) {
    std::vector<physics::BallStart> balls;
    for (const auto& [name, ball] : node.members()) {
        physics::BallStart& start = balls.emplace_back();
        start.ball = names.id_of(name);
        start.spec = read_spec(ball["radius_m"], ball["mass_kg"], usual);
        start.position_m = ball["position_m"].triple(start.spec.radius_m);
        start.velocity_mps = ball["velocity_mps"].triple_or({});
        start.spin_radps = ball["spin_radps"].triple_or({});
    }
    return balls;
}

model::Shot read_aim(const JsonNode& node) {
    const Vec2 offset = node["offset"].pair_or({});
    return {.angle_rad = base::radians(node["angle_deg"].number()),
            .tip_left = offset.x,
            .tip_up = offset.y,
            .elevation_rad = base::radians(node["elevation_deg"].number_or(0.0))};
}

model::Shot read_shot(const JsonNode& node) {
    model::Shot shot = read_aim(node);
    shot.power = node["power"].number();
    return shot;
}

void report_shot(const physics::Error& error, const JsonNode& node) {
    node[shot_name(error.detail)].report(sentence_of(error.code));
}

void report(const physics::Error& error, const BallNames& names, Fault& fault) {
    fault.report(names.translated(table_name(error.detail)), sentence_of(error.code));
}

}  // namespace billiards::tools
