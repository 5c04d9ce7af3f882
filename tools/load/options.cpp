// Takes the command line; checks and converts every option of billiards-load.
#include "tools/load/options.h"

#include "tools/player/check_address.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <map>
#include <string>

namespace billiards::tools {

namespace {

const std::map<std::string, LoadMode> kModes{
    {"play", LoadMode::Play},           {"idle", LoadMode::Idle},
    {"spectate", LoadMode::Spectate},   {"slow", LoadMode::Slow},
    {"garbage", LoadMode::Garbage},     {"flap", LoadMode::Flap},
    {"reconnect", LoadMode::Reconnect}, {"stall", LoadMode::Stall}};

struct Texts {
    std::string mode = "play";
    std::string server;
    std::string http;
    pid_t pid = 0;
};

void add_options(CLI::App& app, LoadOptions& options, Texts& texts) {
    app.add_option("--server", texts.server, "HOST:PORT")->required()->check(check_address);
    app.add_option("--mode", texts.mode, "What the clients do")
        ->option_text("play|idle|spectate|slow|garbage|flap|reconnect|stall")
        ->check(CLI::IsMember(&kModes));
    app.add_option("--tables", options.tables)->check(CLI::Range(1, 10'000))->capture_default_str();
    app.add_option("--spectators", options.spectators, "Of all tables together")
        ->check(CLI::Range(0, 100'000))
        ->capture_default_str();
    app.add_option("--stalled", options.stalled, "How many read nothing, in mode stall")
        ->check(CLI::Range(1, 10'000))
        ->capture_default_str();
    app.add_option("--seconds", options.seconds, "To measure, once everybody is in place")
        ->check(CLI::Range(0.1, 86'400.0))
        ->capture_default_str();
    app.add_option("--seed", options.seed)->capture_default_str();
    app.add_option("--min-think", options.min_think_s, "Seconds, from when the turn opens")
        ->check(CLI::Range(0.0, 600.0))
        ->capture_default_str();
    app.add_option("--max-think", options.max_think_s)
        ->check(CLI::Range(0.0, 600.0))
        ->capture_default_str();
    app.add_option("--aims-per-s", options.aims_per_s, "While a player thinks; 0: none")
        ->check(CLI::Range(0.0, 100.0))
        ->capture_default_str();
    app.add_option("--drop-after", options.drop_after_s, "Seconds; flap keeps no connection longer")
        ->check(CLI::Range(0.01, 3600.0))
        ->capture_default_str();
    app.add_option("--connections-per-s", options.connections_per_s, "How fast they come")
        ->check(CLI::Range(1, 100'000))
        ->capture_default_str();
    app.add_option("--gather", options.gather_s, "Seconds until it measures with who is there")
        ->check(CLI::Range(0.1, 3600.0))
        ->capture_default_str();
    app.add_option("--server-pid", texts.pid, "To read its memory and processor time");
    app.add_option("--http", texts.http, "HOST:PORT of the server's metrics")->check(check_address);
}

}  // namespace

std::string_view name_of(LoadMode mode) {
    const auto found = std::find_if(kModes.begin(), kModes.end(),
                                    [mode](const auto& named) { return named.second == mode; });
    return found->first;
}

std::variant<LoadOptions, int> parse_load_options(int argc, const char* const* argv) {
    CLI::App app(
        "Makes a seeded load on a server from one thread, and prints what it measured as one JSON "
        "object. SIGINT ends it early.",
        "billiards-load");
    LoadOptions options;
    Texts texts;
    add_options(app, options, texts);
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        return app.exit(error) == 0 ? 0 : 2;
    }
    options.mode = kModes.at(texts.mode);
    options.server = *client::parse_address(texts.server);
    if (!texts.http.empty()) options.http = client::parse_address(texts.http);
    if (texts.pid != 0) options.server_pid = texts.pid;
    options.max_think_s = std::max(options.min_think_s, options.max_think_s);
    return options;
}

}  // namespace billiards::tools
