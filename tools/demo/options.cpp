// Takes the command line; checks and converts every option of billiards-demo.
#include "tools/demo/options.h"

#include "common/match/match_state.h"
#include "tools/player/check_address.h"

#include <CLI/CLI.hpp>
#include <random>

namespace billiards::tools {

namespace {

struct Texts {
    std::string server;
    std::uint32_t table = 0;
};

void add_match_options(CLI::App& app, int& race_to, std::uint64_t& seed, double& unsteady_deg) {
    app.add_option("--race", race_to, "Racks to win")
        ->check(CLI::Range(1, match::kMaxRaceTo))
        ->capture_default_str();
    app.add_option("--seed", seed, "What the players do follows from it");
    app.add_option("--unsteady", unsteady_deg, "Degrees by which shots go astray at most")
        ->check(CLI::Range(0.0, 10.0))
        ->capture_default_str();
}

CLI::App* add_role(CLI::App& app, const std::string& name, const std::string& about,
                   RoleOptions& options, Texts& texts) {
    CLI::App* role = app.add_subcommand(name, about);
    role->add_option("--server", texts.server, "HOST:PORT of a server")
        ->required()
        ->check(check_address);
    role->add_option("--name", options.name, "Who it is");
    role->add_option("--token-file", options.token_file,
                     "Keeps the seat for a later start with the same file");
    role->add_flag("--json", options.json, "One JSON object a line, for programs");
    return role;
}

void add_play(CLI::App& app, RoleOptions& options, Texts& texts) {
    CLI::App* play = add_role(app, "play", "Play at a server that runs already", options, texts);
    play->add_option("--table", texts.table, "Table to join; without it, opens one");
    play->add_option("--table-name", options.table_name, "Of the table it opens");
    add_match_options(*play, options.race_to, options.seed, options.unsteady_deg);
    play->add_option("--shot-clock", options.shot_clock_s, "Seconds, 0: none; of a table it opens")
        ->check(CLI::Range(0.0, match::kMaxShotClock_s));
    play->add_option("--min-think", options.min_think_s, "Seconds")->check(CLI::Range(0.0, 3600.0));
    play->add_option("--max-think", options.max_think_s, "Seconds")->check(CLI::Range(0.0, 3600.0));
    play->add_flag("--real-time", options.watches_balls_roll,
                   "Let the balls roll to their rest before the next shot");
}

void add_watch(CLI::App& app, RoleOptions& options, Texts& texts) {
    CLI::App* watch = add_role(app, "watch", "Watch a table", options, texts);
    watch->add_option("--table", texts.table, "Which one")->required();
}

void add_demo(CLI::App& app, DemoOptions& options, std::string& connect) {
    add_match_options(app, options.race_to, options.seed, options.unsteady_deg);
    app.add_option("--server", options.server_program,
                   "The server program; without it, billiards-server beside this one");
    app.add_option("--connect", connect, "HOST:PORT of a server that runs already, instead")
        ->check(check_address);
    app.add_option("--pictures", options.pictures,
                   "Folder for pictures of each rack's break, middle and end; earlier ones go");
    app.add_option("--window", options.window_program,
                   "The program that draws them; without it, billiards beside this one");
    app.add_option("--keep", options.keep,
                   "File to leave the match in, as a replay; not with --connect");
    app.add_option("--think", options.think_s, "Seconds before each shot")
        ->check(CLI::Range(0.0, 60.0))
        ->capture_default_str();
    app.add_option("--limit", options.limit_s, "Seconds after which it gives up")
        ->check(CLI::Range(1.0, 86'400.0))
        ->capture_default_str();
}

RoleOptions finished(RoleOptions options, const Texts& texts, protocol::Role role,
                     const std::string& name) {
    options.role = role;
    options.server = *client::parse_address(texts.server);
    if (options.name.empty()) options.name = name;
    if (texts.table != 0) options.table = protocol::TableId{texts.table};
    options.max_think_s = std::max(options.min_think_s, options.max_think_s);
    return options;
}

}  // namespace

std::variant<DemoOptions, RoleOptions, ExitCode> parse_options(int argc, const char* const* argv) {
    CLI::App app(
        "Plays a demonstration match: a real server, two players and a spectator, each a process "
        "of its own, over TCP. Every ruling is told as it happens, and all must have got the same.",
        "billiards-demo");
    DemoOptions demo;
    RoleOptions role;
    Texts texts;
    std::string connect;
    role.seed = std::random_device{}();
    add_demo(app, demo, connect);
    add_play(app, role, texts);
    add_watch(app, role, texts);
    app.require_subcommand(0, 1);
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        return ExitCode{app.exit(error) == 0 ? 0 : 2};
    }
    if (app.got_subcommand("play")) return finished(role, texts, protocol::Role::Player, "Player");
    if (app.got_subcommand("watch")) {
        return finished(role, texts, protocol::Role::Spectator, "Spectator");
    }
    if (!connect.empty()) demo.connect = client::parse_address(connect);
    return demo;
}

}  // namespace billiards::tools
