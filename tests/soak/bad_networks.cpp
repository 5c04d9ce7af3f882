// Takes a seed; plays whole matches through a network at its worst, and fails unless each comes to
// its end without help and everybody agrees about every shot of it: players, spectator and journal.
#include "tests/soak/prove.h"

#include <chrono>

namespace billiards::soak {
namespace {

struct Options {
    HallOptions hall{.tables = 16, .bad_share = 1.0, .limit = std::chrono::hours(1)};
    std::size_t matches = 200;
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

}  // namespace
}  // namespace billiards::soak

int main(int argc, char** argv) {
    using namespace billiards::soak;
    CLI::App app("Plays whole matches through the worst of networks", "bad_networks");
    Options options;
    app.add_option("--matches", options.matches)->check(CLI::PositiveNumber)->capture_default_str();
    app.add_option("--at-once", options.hall.tables)->check(CLI::Range(1, 1000));
    return prove(app, argc, argv, options.hall, [&] { return play(options); });
}
