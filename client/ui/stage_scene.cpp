// Takes a screen; plays it step by step to where its picture is wanted.
#include "client/ui/stage_scene.h"

#include "client/ui/menu.h"

#include <array>

namespace billiards::client {

namespace {

constexpr double kBreakAngle_rad = 0.012;
constexpr double kBreakPower = 0.95;
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

/// In the middle of the first break.
bool break_shot(Screen& screen) {
    const Playback* rolling = screen.game.presentation().rolling();
    if (rolling == nullptr) {
        if (!rack(screen)) return false;
        screen.game.shot().set_angle(kBreakAngle_rad);
        screen.game.shot().set_power(kBreakPower);
        screen.game.shoot();
        return false;
    }
    const base::Instant end = rolling->ends_at();
    const double left_s = base::seconds(end - screen.now);
    return rolling->shot().record.duration_s - left_s > kIntoBreak_s;
}

/// The second shot is aimed.
bool aim(Screen& screen) {
    if (screen.game.presentation().rolling() != nullptr) screen.game.skip_roll();
    const auto& table = screen.game.known().table;
    const bool has_broken = table && table->match && table->match->shots_played > 0;
    if (has_broken && screen.game.acting()) return true;
    if (!has_broken) break_shot(screen);
    return false;
}

struct NamedScene {
    const char* name;
    SceneStep step;
};

const std::array<NamedScene, 8>& scenes() {
    static const std::array<NamedScene, 8> all{{{"menu", page(MenuPage::Main)},
                                                {"host", page(MenuPage::Host)},
                                                {"join", page(MenuPage::Join)},
                                                {"help", page(MenuPage::Help)},
                                                {"rack", rack},
                                                {"break", break_shot},
                                                {"aim", aim},
                                                {"above", [](Screen& screen) {
                                                     screen.camera.look_from_above();
                                                     return aim(screen);
                                                 }}}};
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
