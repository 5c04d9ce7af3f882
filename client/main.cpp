// Takes the command line; opens the window.
#include "client/play/player_name.h"
#include "client/play/way_in.h"
#include "client/window_app.h"

#include <CLI/CLI.hpp>
#include <SDL.h>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <iostream>
#include <random>
#include <string>

namespace {

using namespace billiards::client;
namespace fs = std::filesystem;

struct Flags {
    std::string size = "1280x720";
    std::string name = "Player";
    std::string profile = "default";
    std::string data;
    std::string assets;
    bool is_offscreen = false;
    std::string screenshot;
    std::string scene = "menu";
    int frames = 0;
    std::string report;
    std::string server;
    std::uint32_t table = 0;
    bool watches = false;
    std::string pictures;
};

void describe(CLI::App& app, Flags& flags) {
    app.set_version_flag("--version", std::string("billiards ") + BILLIARDS_VERSION);
    app.add_option("--size", flags.size, "Of the window [1280x720]")->type_name("WxH");
    app.add_option("--name", flags.name, "Yours, as others see it")->type_name("NAME");
    app.add_option("--profile", flags.profile, "Keeps two windows on one machine apart [default]")
        ->type_name("NAME");
    app.add_option("--data", flags.data,
                   "Folder for what is played here [$XDG_DATA_HOME/gl-billiards/PROFILE]")
        ->type_name("FOLDER");
    app.add_option("--assets", flags.assets, "Folder of models and textures")->type_name("FOLDER");
    auto* server = app.add_option("--server", flags.server,
                                  "Go to this server at once, or by an invite to its table")
                       ->type_name("HOST:PORT");
    auto* table = app.add_option("--table", flags.table, "And to this table there")
                      ->type_name("NUMBER")
                      ->needs(server);
    auto* watch = app.add_flag("--watch", flags.watches, "To watch, not to play");
    app.add_option("--pictures", flags.pictures,
                   "Save pictures of the match that is watched, and end with it")
        ->type_name("FOLDER")
        ->needs(table)
        ->needs(watch);
    app.add_flag("--offscreen", flags.is_offscreen, "Draw without a display");
    app.add_option("--screenshot", flags.screenshot, "Save a picture of the scene, and end")
        ->type_name("FILE.png");
    app.add_option("--frames", flags.frames, "Draw the scene so often, say how long, and end")
        ->type_name("N")
        ->check(CLI::Range(1, 1'000'000));
    app.add_option("--scene", flags.scene,
                   fmt::format("What the picture shows: {}", fmt::join(scene_names(), ", ")))
        ->type_name("NAME");
    app.add_option("--report", flags.report,
                   "Write what is on the screen, a line of JSON whenever it changes")
        ->type_name("FILE");
}

std::string environment(const char* name) {
    const char* value = std::getenv(name);
    return value != nullptr ? value : "";
}

fs::path data_folder(const Flags& flags) {
    if (!flags.data.empty()) return flags.data;
    const fs::path data_home = environment("XDG_DATA_HOME");
    if (data_home.is_absolute()) return data_home / "gl-billiards" / flags.profile;
    const fs::path home = environment("HOME");
    if (home.is_absolute()) return home / ".local" / "share" / "gl-billiards" / flags.profile;
    throw std::runtime_error("--data: neither it nor XDG_DATA_HOME nor HOME names a folder.");
}

/// Installed beside the program, or in the tree that it was built in.
fs::path assets_folder(const Flags& flags) {
    if (!flags.assets.empty()) return flags.assets;
    char* base = SDL_GetBasePath();
    const fs::path program = base != nullptr ? base : ".";
    SDL_free(base);
    for (const char* way : {"../share/gl-billiards/assets", "../../assets", "assets"}) {
        std::error_code error;
        if (fs::exists(program / way / "models", error)) return program / way;
    }
    throw std::runtime_error("The models are not beside the program: --assets names their folder.");
}

WindowOptions window_of(const Flags& flags) {
    WindowOptions window;
    window.is_offscreen = flags.is_offscreen;
    char rest = 0;
    const int read =
        std::sscanf(flags.size.c_str(), "%dx%d%c", &window.width, &window.height, &rest);
    const auto fits = [](int length) { return length >= 320 && length <= 8192; };
    if (read != 2 || !fits(window.width) || !fits(window.height)) {
        throw std::runtime_error(
            fmt::format("--size {}: it looks like 1280x720, each from 320 to 8192.", flags.size));
    }
    return window;
}

WindowAppOptions options_of(const Flags& flags) {
    WindowAppOptions options;
    options.window = window_of(flags);
    options.assets = assets_folder(flags);
    options.data = data_folder(flags);
    if (!is_player_name(flags.name)) {
        throw std::runtime_error(fmt::format("--name {}: {}", flags.name, kPlayerNameRule));
    }
    options.name = flags.name;
    options.seed = std::random_device()();
    options.report = flags.report;
    options.pictures = flags.pictures;
    if (!flags.screenshot.empty() || flags.frames > 0) {
        options.screenshot = flags.screenshot;
        options.frames = flags.frames;
        options.scene = scene_named(flags.scene);
        if (!options.scene) {
            throw std::runtime_error(fmt::format("--scene {}: there are {}.", flags.scene,
                                                 fmt::join(scene_names(), ", ")));
        }
    }
    if (!flags.server.empty()) {
        const auto role = flags.watches ? billiards::protocol::Role::Spectator
                                        : billiards::protocol::Role::Player;
        const auto way = way_in(flags.server, role);
        if (!way) {
            throw std::runtime_error(
                fmt::format("--server {}: an address looks like example.org:4747, and an invite "
                            "begins with billiards://.",
                            flags.server));
        }
        options.server = way->address;
        options.watches = flags.watches;
        if (way->join) options.errand = GoToTable{*way->join};
        if (flags.table != 0) options.errand = GoToTable{{.table = {flags.table}, .role = role}};
    }
    return options;
}

}  // namespace

int main(int argc, char** argv) {
    CLI::App app("Pool, in a window: play at one screen or with others over the network, or watch.",
                 "billiards");
    Flags flags;
    describe(app, flags);
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        return app.exit(error) == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
    }
    try {
        WindowApp(options_of(flags)).run();
        return EXIT_SUCCESS;
    } catch (const std::exception& error) {
        std::cerr << "billiards: " << error.what() << '\n';
        return EXIT_FAILURE;
    }
}
