// Takes a match as it is watched; saves its pictures and tells of each, a line of JSON.
#include "client/net/clock.h"
#include "client/render/picture.h"
#include "client/window_app.h"

#include <iostream>
#include <nlohmann/json.hpp>
#include <stdexcept>

namespace billiards::client {

namespace {

constexpr Uint32 kLook_ms = 10;

/// To the program that started this one: a line of JSON.
void say(const nlohmann::ordered_json& event) {
    std::cout << event.dump() << std::endl;
}

/// Why the match cannot be watched any more; empty: it can.
std::string why_unseen(const Game& game, bool was_seen) {
    if (!game.lost().empty()) return game.lost();
    if (game.known().table) return "";
    if (was_seen) return "The table was closed before the match was over.";
    return game.refusal();
}

base::Instant moment_of(const DuePicture& picture, const Playback* rolling) {
    if (rolling == nullptr) return local_now();
    const double duration_s = rolling->shot().record.duration_s;
    return rolling->ends_at() - base::duration_of(duration_s - picture.at_s.value_or(duration_s));
}

}  // namespace

/// Watches a match to its end and draws no other frame than those that are kept: without a graphics
/// card each takes its time.
void WindowApp::draw_pictures() {
    std::filesystem::create_directories(options_.pictures);
    RackPictures pictures;
    int count = 0;
    while (!screen_.wants_to_quit) {
        take_events();
        const std::optional<TableView> before = screen_.game.known().table;
        if (!screen_.game.take_next()) {
            SDL_Delay(kLook_ms);
            continue;
        }
        const std::string why = why_unseen(screen_.game, before.has_value());
        if (!why.empty()) throw std::runtime_error(why);
        const std::optional<TableView>& after = screen_.game.known().table;
        if (!after) continue;
        if (!before) {
            say({{"event", "seated"}, {"table", after->row.table.value}});
            continue;
        }
        for (const DuePicture& picture : pictures.due(*before, *after)) {
            draw_picture(picture);
            ++count;
        }
        if (after->over) break;
    }
    say({{"event", "result"}, {"pictures", count}});
}

void WindowApp::draw_picture(const DuePicture& picture) {
    screen_.now = moment_of(picture, screen_.game.presentation().rolling());
    screen_.game.show(screen_.now);
    for (int frame = 1; frame < kFramesUntilSettled; ++frame) lay_out();
    draw(lay_out());
    const std::filesystem::path file = options_.pictures / (picture.name + ".png");
    save_picture(window_, file);
    say({{"event", "picture"}, {"file", file.string()}});
}

}  // namespace billiards::client
