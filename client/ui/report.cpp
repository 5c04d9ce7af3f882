// Takes what is shown and set; gives JSON.
#include "client/ui/report.h"

#include "client/play/information.h"
#include "client/ui/hands.h"
#include "common/base/hex.h"
#include "common/model/table_spec.h"

#include <cmath>
#include <imgui.h>
#include <nlohmann/json.hpp>
#include <numbers>

namespace billiards::client {

namespace {

using Json = nlohmann::ordered_json;

double degrees(double angle_rad) {
    return angle_rad * 180.0 / std::numbers::pi;
}

Json call_of(const model::Call& call) {
    if (const auto* called = std::get_if<model::CalledBall>(&call)) {
        return {{"ball", called->ball.number}, {"pocket", called->pocket.number}};
    }
    if (std::holds_alternative<model::Safety>(call)) return "safety";
    if (std::holds_alternative<model::PushOut>(call)) return "push-out";
    return nullptr;
}

Json shot_of(const ShotControl& control) {
    const model::Shot& shot = control.shot();
    return {{"angle_deg", degrees(shot.angle_rad)}, {"power", shot.power},
            {"tip", {shot.tip_left, shot.tip_up}},  {"elevation_deg", degrees(shot.elevation_rad)},
            {"call", call_of(control.call())},      {"pulled", control.is_pulled()}};
}

/// What may be said instead of a ball and a pocket.
Json may_say_of(const Screen& screen) {
    const Offered offered = screen.game.offered(screen.now);
    Json words = Json::array();
    if (offered.safety) words.push_back("safety");
    if (offered.push_out) words.push_back("push-out");
    return words;
}

Json camera_of(const Screen& screen) {
    const Camera& camera = screen.camera;
    const base::Vec3& target = camera.target_m();
    return {{"azimuth_deg", degrees(camera.azimuth_rad())},
            {"elevation_deg", degrees(camera.elevation_rad())},
            {"distance_m", camera.distance_m()},
            {"target_m", {target.x, target.y, target.z}},
            {"follows", screen.follows_ball},
            {"followed", screen.followed.number}};
}

Json balls_of(const model::Layout& layout) {
    Json balls = Json::object();
    for (const model::PlacedBall& placed : layout.balls) {
        if (placed.place != model::Place::OnTable) continue;
        balls[std::to_string(placed.ball.number)] = {placed.position_m.x, placed.position_m.y};
    }
    return balls;
}

/// In window units, whole; null behind the eye.
Json point_on_screen(const Screen& screen, base::Vec2 at_m) {
    const base::Vec3 point_m(at_m, model::BallSpec{}.radius_m);
    const auto place = screen.camera.place_of(point_m, aspect_of(screen));
    if (!place) return nullptr;
    const ImVec2 at = point_of(screen, *place);
    return {std::lround(at.x), std::lround(at.y)};
}

/// Where to click on a ball, or a pocket.
Json places_of(const Screen& screen, const match::MatchState& match) {
    Json balls = Json::object();
    for (const model::PlacedBall& placed : match.layout.balls) {
        if (placed.place != model::Place::OnTable) continue;
        balls[std::to_string(placed.ball.number)] = point_on_screen(screen, placed.position_m);
    }
    const auto held_m = screen.game.cue_ball_m();
    if (held_m) balls["0"] = point_on_screen(screen, *held_m);
    Json pockets = Json::array();
    for (const model::PocketCircle& pocket : model::table_of(match.settings.table).pockets) {
        pockets.push_back(point_on_screen(screen, pocket.center_m));
    }
    return {{"balls", balls}, {"pockets", pockets}};
}

Json match_of(const match::MatchState& match) {
    return {{"turn", match.turn.value},
            {"to_act", static_cast<int>(match.to_act)},
            {"stage", static_cast<int>(match.stage)},
            {"shots", match.shots_played},
            {"racks", match.racks_won.values},
            {"in_hand", match.rack.in_hand != rules::Zone::None},
            {"balls", balls_of(match.layout)}};
}

Json table_of(const Screen& screen, const TableView& table) {
    Json json{{"id", table.row.table.value},
              {"seats", Json::array()},
              {"rolling", screen.game.presentation().rolling() != nullptr},
              {"match", nullptr},
              {"on_screen", nullptr},
              {"last_hash", nullptr},
              {"deadline_us", nullptr}};
    if (table.turn.deadline_us) json["deadline_us"] = *table.turn.deadline_us;
    for (const model::Seat seat : table.my_seats) json["seats"].push_back(static_cast<int>(seat));
    if (table.match) {
        json["match"] = match_of(*table.match);
        json["on_screen"] = places_of(screen, *table.match);
    }
    if (table.last_shot) json["last_hash"] = base::to_hex(table.last_shot->record.hash);
    return json;
}

Json chat_of(const ClientState& known) {
    Json json = Json::array();
    for (const ChatLine& line : known.chat) json.push_back({line.name, line.text});
    return json;
}

/// The step that is shown, and how many there are; null where the match is live.
Json rewatching_of(const Game& game) {
    const Rewatch* rewatch = game.rewatch();
    return rewatch != nullptr ? Json{rewatch->step(), rewatch->steps()} : Json(nullptr);
}

/// As the frame saw it: a hand that drives the program knows when it has been felt.
Json mouse_of(const ImGuiIO& io) {
    Json held = Json::array();
    for (int button = 0; button < ImGuiMouseButton_COUNT; ++button) {
        if (io.MouseDown[button]) held.push_back(button);
    }
    return {{"at", {io.MousePos.x, io.MousePos.y}}, {"held", held}};
}

Json controls_of(const ControlMap& controls) {
    Json json = Json::object();
    for (const auto& [name, place] : controls.places()) {
        json[name] = {place.left, place.top, place.width, place.height};
    }
    return json;
}

}  // namespace

std::string report_of(const Screen& screen) {
    const TableView* table = screen.game.presentation().table();
    const auto cue_ball_m = screen.game.cue_ball_m();
    const auto acting = screen.game.acting();
    const ImGuiIO& io = ImGui::GetIO();
    Json json{
        {"window", {io.DisplaySize.x, io.DisplaySize.y}},
        {"table_width", screen.table_width(io.DisplaySize.x)},
        {"mouse", mouse_of(io)},
        {"typing", io.WantTextInput},
        {"menu", screen.menu.is_open},
        {"page", static_cast<int>(screen.menu.page)},
        {"trouble", screen.menu.trouble},
        {"connected", screen.game.is_connected()},
        {"acting", acting ? Json(static_cast<int>(*acting)) : Json(nullptr)},
        {"cue_ball", cue_ball_m ? Json{cue_ball_m->x, cue_ball_m->y} : Json(nullptr)},
        {"may_say", may_say_of(screen)},
        {"placing", screen.game.placing().has_value()},
        {"set_down", screen.game.placing() && screen.game.placing()->is_down()},
        {"called_ball", screen.called_ball ? Json(screen.called_ball->number) : Json(nullptr)},
        {"shot", shot_of(screen.game.shot())},
        {"camera", camera_of(screen)},
        {"folded", screen.is_panel_folded},
        {"aim_line", screen.shows_aim_line},
        {"information", information(screen.game)},
        {"notes", notes(screen.game, screen.now)},
        {"copied", screen.copied},
        {"chat", chat_of(screen.game.known())},
        {"rewatching", rewatching_of(screen.game)},
        {"table", table != nullptr ? table_of(screen, *table) : Json(nullptr)},
        {"controls", controls_of(screen.controls)}};
    return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace billiards::client
