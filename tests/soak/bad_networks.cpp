// Takes a seed; plays whole matches through a network at its worst, and fails unless each comes to
// its end without help and everybody agrees about every shot of it: players, spectator and journal.
#include "tests/soak/hall.h"

#include <CLI/CLI.hpp>
#include <exception>
#include <iostream>
#include <nlohmann/json.hpp>

namespace billiards::soak {
namespace {

struct Options {
    HallOptions hall{.seed = 1, .tables = 16, .bad_share = 1.0, .max_think = {}, .limit = {}};
    std::size_t matches = 200;
    double max_think_s = 0.05;
    double seconds_limit = 3600.0;
};

nlohmann::ordered_json play(const Options& options) {
    Hall hall(options.hall);
    std::size_t opened = 0;
    const auto is_enough = [&] {
        hall.retire();
        for (; opened < options.matches && hall.playing() < options.hall.tables; ++opened) {
            hall.open_party();
        }
        return hall.finished() == options.matches;
    };
    hall.play_until(is_enough, options.hall.limit);
    hall.host().stop();
    hall.check(true);
    const Hall::Figures figures = hall.figures();
    if (figures.shots_told != figures.shots_journalled) {
        throw BrokenPromise("a shot in the journals was told to nobody");
    }
    return {{"seed", options.hall.seed},
            {"matches", hall.finished()},
            {"at_once", options.hall.tables},
            {"shots_told", figures.shots_told},
            {"shots_journalled", figures.shots_journalled},
            {"connections", figures.network.connections},
            {"bytes", figures.network.bytes},
            {"splits", figures.network.splits},
            {"stalls", figures.network.stalls},
            {"resets", figures.network.resets},
            {"links_lost", figures.links_lost},
            {"resumed_by_ring", figures.resumed_by_ring},
            {"resumed_by_snapshot", figures.resumed_by_snapshot},
            {"seconds", figures.seconds}};
}

int run(int argc, char** argv) {
    CLI::App app("Plays whole matches through the worst of networks");
    Options options;
    app.add_option("--matches", options.matches)->check(CLI::PositiveNumber)->capture_default_str();
    app.add_option("--at-once", options.hall.tables)->check(CLI::Range(1, 1000));
    app.add_option("--seed", options.hall.seed)->capture_default_str();
    app.add_option("--max-think", options.max_think_s, "Seconds")->check(CLI::Range(0.0, 60.0));
    app.add_option("--seconds-limit", options.seconds_limit, "Beyond it something is stuck");
    CLI11_PARSE(app, argc, argv);
    options.hall.max_think = base::duration_of(options.max_think_s);
    options.hall.limit = base::duration_of(options.seconds_limit);
    try {
        std::cout << play(options).dump() << std::endl;
        return 0;
    } catch (const BrokenPromise& broken) {
        std::cerr << "seed " << options.hall.seed << ": " << broken.what() << std::endl;
        return 1;
    }
}

}  // namespace
}  // namespace billiards::soak

int main(int argc, char** argv) {
    try {
        return billiards::soak::run(argc, argv);
    } catch (const std::exception& error) {
        std::cerr << "bad_networks: " << error.what() << '\n';
        return 1;
    }
}
