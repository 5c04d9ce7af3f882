// Gives everything that one window is about: the game behind it, the eye, and what is open on it.
#pragma once

#include "client/local/local_server.h"
#include "client/play/game.h"
#include "client/scene/camera.h"
#include "client/ui/controls.h"
#include "client/ui/look.h"
#include "common/base/time.h"

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>

namespace billiards::client {

enum class MenuPage : std::uint8_t { Main, Host, Join, Tables, Help };

/// What of the menu is typed and chosen; kept while the menu is closed.
struct MenuState {
    MenuPage page = MenuPage::Main;
    bool is_open = true;
    bool watches = false;  ///< The list of tables is for watching, not for playing.
    std::string name = "Player";
    std::string address = "127.0.0.1:4747";
    std::string port = "4747";
    int game = 0;  ///< Of rules::Game.
    int race_to = 3;
    int table_size = 2;  ///< Of model::TableSize.
    bool is_for_others = false;
    std::string trouble;  ///< What went wrong last, in a sentence.
};

struct Screen {
    Screen(std::uint64_t seed, std::filesystem::path data_folder)
        : game(seed), data(std::move(data_folder)) {}

    Game game;
    std::filesystem::path data;  ///< Where a server in this process keeps its matches.
    std::unique_ptr<LocalServer> server;
    Letters letters;
    float scale = 0.0F;  ///< Of the interface; set with the letters, before the first frame.
    ControlMap controls;
    MenuState menu;

    Camera camera{base::Vec2{1.42, 0.785}};
    bool follows_ball = false;
    model::BallId followed = model::kCueBall;

    bool is_panel_folded = false;
    bool shows_aim_line = true;
    std::optional<model::BallId> called_ball;  ///< Clicked, and its pocket not yet.
    bool wants_to_quit = false;
    base::Instant now{};

    /// What a window of this width leaves to the table.
    float table_width(float window_width) const {
        return is_panel_folded ? window_width : window_width - kPanelWidth * scale;
    }
};

}  // namespace billiards::client
