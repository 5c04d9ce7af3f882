// Takes a screen; plays it step by step to where its picture is wanted.
#include "client/ui/stage_scene.h"

#include "client/ui/ways.h"

#include <array>

namespace billiards::client {

namespace {

constexpr double kBreakAngle_rad = 0.012;
constexpr double kBreakPower = 0.95;
constexpr double kWeakPower = 0.04;  ///< Not enough for a legal break.
constexpr double kCloseUp = 18;      ///< Steps of the wheel.
constexpr double kIntoBreak_s = 1.1;

SceneStep page(MenuPage page) {
    return [page](Screen& screen) {
        screen.menu.page = page;
        return true;
    };
}

/// Two players at a table, the first about to break.
bool rack(Screen& screen) {
    const bool has_begun = screen.server != nullptr;
    if (!has_begun) play_two_here(screen);
    if (screen.game.acting()) return true;
    const auto& table = screen.game.known().table;
    if (table && !table->row.playing && !screen.game.has_asked_to_start()) screen.game.ready();
    return false;
}

/// Shoots the first break, once it can be.
void shoot_break(Screen& screen, double power) {
    if (!rack(screen)) return;
    screen.game.shot().set_angle(kBreakAngle_rad);
    screen.game.shot().set_power(power);
    screen.game.shoot();
}

/// In the middle of the first break.
bool break_shot(Screen& screen) {
    const Playback* rolling = screen.game.presentation().rolling();
    if (rolling == nullptr) {
        shoot_break(screen, kBreakPower);
        return false;
    }
    const base::Instant end = rolling->ends_at();
    const double left_s = base::seconds(end - screen.now);
    return rolling->shot().record.duration_s - left_s > kIntoBreak_s;
}

/// After a break of this power, somebody is to act.
bool broken(Screen& screen, double power) {
    if (screen.game.presentation().rolling() != nullptr) screen.game.skip_roll();
    const auto& table = screen.game.known().table;
    const bool has_broken = table && table->match && table->match->shots_played > 0;
    if (!has_broken) shoot_break(screen, power);
    return has_broken && screen.game.acting();
}

/// The second shot is aimed.
bool aim(Screen& screen) {
    return broken(screen, kBreakPower);
}

/// The same from straight above.
bool above(Screen& screen) {
    screen.camera.look_from_above();
    return aim(screen);
}

bool folded(Screen& screen) {
    screen.is_panel_folded = true;
    return aim(screen);
}

/// The eye turns about the cue ball, near by.
bool close_up(Screen& screen) {
    if (!screen.follows_ball) {
        screen.follows_ball = true;
        screen.camera.orbit(0.0, -0.3);
        screen.camera.zoom(kCloseUp);
    }
    return aim(screen);
}

/// After a break that was too weak, the other player chooses.
bool choice(Screen& screen) {
    return broken(screen, kWeakPower);
}

/// The cue ball is held where it must not lie.
bool in_hand(Screen& screen) {
    if (!rack(screen)) return false;
    screen.game.hold_cue_ball_at({0.2, 0.25});
    return true;
}

/// A match has ended: the one who was to break gave it up.
bool over(Screen& screen) {
    const auto& table = screen.game.known().table;
    if (table && table->over) return true;
    if (rack(screen)) screen.game.concede();
    return false;
}

bool practice(Screen& screen) {
    if (screen.server == nullptr) practise_here(screen);
    const auto& table = screen.game.known().table;
    if (table && !table->row.playing && !screen.game.has_asked_to_start()) screen.game.ready();
    return screen.game.acting().has_value();
}

/// A private table whose owner waits for somebody, with an invite made.
bool hosting(Screen& screen) {
    screen.menu.port.assign(1, '0');
    screen.menu.table.is_private = true;
    if (screen.server == nullptr) host_table(screen);
    if (!screen.game.known().table || screen.copies_invite) return false;
    if (!screen.copied.empty()) return true;
    screen.game.make_invite(protocol::Role::Player);
    screen.copies_invite = true;
    return false;
}

/// And what else the owner decides.
bool owner(Screen& screen) {
    if (!hosting(screen)) return false;
    screen.menu.is_open = true;
    screen.menu.page = MenuPage::Table;
    return true;
}

/// The menu in the middle of a match.
bool at_table_menu(Screen& screen) {
    if (!aim(screen)) return false;
    screen.menu.is_open = true;
    return true;
}

/// What somebody sees who looks around at a server with a table.
bool tables(Screen& screen) {
    if (screen.menu.page == MenuPage::Tables) return !screen.game.known().tables.empty();
    if (rack(screen)) {
        screen.game.connect(screen.server->address(), screen.menu.name, LookAround{});
        screen.menu.page = MenuPage::Tables;
        screen.menu.is_open = true;
    }
    return false;
}

struct NamedScene {
    const char* name;
    SceneStep step;
};

const std::array<NamedScene, 19>& scenes() {
    static const std::array<NamedScene, 19> all{{{"menu", page(MenuPage::Main)},
                                                 {"host", page(MenuPage::Host)},
                                                 {"join", page(MenuPage::Join)},
                                                 {"help", page(MenuPage::Help)},
                                                 {"tables", tables},
                                                 {"rack", rack},
                                                 {"hand", in_hand},
                                                 {"break", break_shot},
                                                 {"choice", choice},
                                                 {"aim", aim},
                                                 {"above", above},
                                                 {"folded", folded},
                                                 {"close", close_up},
                                                 {"over", over},
                                                 {"quick", page(MenuPage::Quick)},
                                                 {"practice", practice},
                                                 {"hosting", hosting},
                                                 {"owner", owner},
                                                 {"pause", at_table_menu}}};
    return all;
}

}  // namespace

std::optional<SceneStep> scene_named(const std::string& name) {
    for (const NamedScene& scene : scenes()) {
        if (name == scene.name) return scene.step;
    }
    return std::nullopt;
}

std::vector<std::string> scene_names() {
    std::vector<std::string> names;
    for (const NamedScene& scene : scenes()) names.emplace_back(scene.name);
    return names;
}

}  // namespace billiards::client
