// Gives everything that one window is about: the game behind it, the eye, and what is open on it.
#pragma once

#include "client/local/local_server.h"
#include "client/local/profile.h"
#include "client/play/game.h"
#include "client/scene/camera.h"
#include "client/ui/controls.h"
#include "client/ui/look.h"
#include "common/base/time.h"

#include <SDL_scancode.h>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace billiards::client {

enum class MenuPage : std::uint8_t { Main, Host, Join, Tables, Help, Quick, Private, Table, Open };

/// How a table that is to be opened, or changed, is wanted.
struct TableWishes {
    int game = 0;  ///< Of rules::Game.
    int race_to = 3;
    int table_size = 2;  ///< Of model::TableSize.
    int delay_s = 0;     ///< Of spectators.
    bool is_private = false;
    bool has_passcode = false;  ///< The table that is to be changed has one already.
    std::string passcode;
};

/// What of the menu is typed and chosen; kept while the menu is closed.
struct MenuState {
    MenuPage page = MenuPage::Main;
    bool is_open = true;
    bool watches = false;  ///< The list of tables is for watching, not for playing.
    std::string name = "Player";
    std::string address = "127.0.0.1:4747";  ///< Or an invite.
    std::string port = "4747";
    TableWishes table;
    bool is_for_others = false;
    std::string table_number;  ///< Of a private table.
    std::string passcode;      ///< To come in.
    std::string kicked;        ///< The name of whoever is to be sent away.
    std::string trouble;       ///< What went wrong last, in a sentence.
};

/// Between two frames, of what is said at a table.
struct TalkState {
    bool is_open = false;
    bool takes_focus = false;
    std::string text;
};

struct Screen {
    Screen(std::uint64_t seed, const std::filesystem::path& data_folder)
        : game(seed), profile(data_folder), kept(profile.kept()) {}

    Game game;
    Profile profile;                  ///< Where a server in this process keeps its matches, too.
    std::optional<KeptSession> kept;  ///< As the profile has it.
    KeptSession session;              ///< The one that is, once there is one.
    bool is_session_kept = false;     ///< It goes on with the one that is kept.
    std::unique_ptr<LocalServer> server;
    Letters letters;
    float scale = 0.0F;  ///< Of the interface; set with the letters, before the first frame.
    ControlMap controls;
    MenuState menu;
    TalkState talk;
    bool has_left_own_table = false;  ///< Of a server in this process, which ends then.
    bool copies_invite = false;       ///< The next one that is made is for the clipboard.
    std::string copied;               ///< The invite that was copied last.

    Camera camera{base::Vec2{1.42, 0.785}};
    bool follows_ball = false;
    model::BallId followed = model::kCueBall;

    float score_ends_at = 0.0F;  ///< In window units from the top.
    bool is_panel_folded = false;
    bool shows_aim_line = true;
    /// In practice: it goes where the mouse lets it go.
    struct DraggedBall {
        model::BallId ball;
        base::Vec2 at_m{};
    };
    std::optional<DraggedBall> dragged;
    std::optional<model::BallId> called_ball;  ///< Clicked, and its pocket not yet.
    /// Held for so long that the system says it again, since the last frame.
    std::vector<SDL_Scancode> repeated;
    bool wants_to_quit = false;
    base::Instant now{};

    /// What a window of this width leaves to the table.
    float table_width(float window_width) const {
        return is_panel_folded ? window_width : window_width - kPanelWidth * scale;
    }
};

}  // namespace billiards::client
