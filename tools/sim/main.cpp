// Takes the command line, and cases on standard input or a file; gives answers on standard output.
#include "tools/sim/bench.h"
#include "tools/sim/case_stream.h"
#include "tools/sim/collide.h"
#include "tools/sim/contact_time.h"
#include "tools/sim/judge.h"
#include "tools/sim/replay.h"
#include "tools/sim/solve.h"
#include "tools/sim/strike.h"

#include <CLI/CLI.hpp>
#include <exception>
#include <iostream>
#include <map>
#include <stdexcept>
#include <string>

namespace {

using namespace billiards::tools;

constexpr int kBadInput = 2;

/// One that reads cases; benchmarks and replays read none.
struct Subcommand {
    const char* name;
    const char* help;
    Json (*answer_case)(const JsonNode& input, Fault& fault);
};

constexpr Subcommand kSubcommands[] = {
    {"solve", "Solve the motion of balls on a table", solve},
    {"collide", "Let two balls, or a ball and a cushion, collide", collide},
    {"strike", "Strike a ball with the cue", strike},
    {"contact-time", "Find when two balls meet", contact_time},
    {"judge", "Judge a told shot by the rules of a game", judge},
};

int answer(const AnswerCase& answer_case, bool is_by_line) {
    return is_by_line ? answer_lines(std::cin, std::cout, answer_case)
                      : answer_one(std::cin, std::cout, std::cerr, answer_case);
}

void add_bench(CLI::App& app, BenchCase& bench_case, double& seconds) {
    const std::map<std::string, BenchCase> cases{
        {"break8", BenchCase::Break8}, {"break9", BenchCase::Break9}, {"mid", BenchCase::Mid}};
    CLI::App* benching = app.add_subcommand("bench", "Measure how fast shots are solved");
    benching->add_option("--case", bench_case, "break8, break9 or mid")
        ->transform(CLI::CheckedTransformer(cases));
    benching->add_option("--seconds", seconds, "How long; 1,000 shots at least")
        ->check(CLI::Range(0.0, 3600.0));
}

void add_replay(CLI::App& app, ReplayOptions& options) {
    CLI::App* replaying = app.add_subcommand("replay", "Read a match that was played");
    replaying->add_option("FILE", options.file, "A .billiards file")->required();
    replaying->add_flag("--print", options.is_printed, "The match shot by shot; the default");
    replaying->add_flag("--verify", options.is_verified, "Solve and judge every shot again");
}

int run(int argc, char** argv) {
    CLI::App app{"The physics and the rules of gl-billiards without a server"};
    app.require_subcommand(1);

    bool is_by_line = false;
    for (const Subcommand& each : kSubcommands) {
        app.add_subcommand(each.name, each.help)
            ->add_flag("--jsonl", is_by_line, "One case a line; errors stay on their line");
    }

    BenchCase bench_case = BenchCase::Break8;
    double seconds = 2.0;
    add_bench(app, bench_case, seconds);
    ReplayOptions replay;
    add_replay(app, replay);

    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        return app.exit(error) == 0 ? 0 : kBadInput;
    }
    for (const Subcommand& each : kSubcommands) {
        if (app.got_subcommand(each.name)) return answer(each.answer_case, is_by_line);
    }
    if (app.got_subcommand("replay")) return replay_file(replay, std::cout, std::cerr);
    std::cout << bench(bench_case, seconds).dump() << '\n';
    return 0;
}

}  // namespace

int main(int argc, char** argv) {
    try {
        const int exit_code = run(argc, argv);
        if (!std::cout.flush()) throw std::runtime_error("the answer could not be written");
        return exit_code;
    } catch (const std::exception& error) {
        std::cerr << "billiards-sim: " << error.what() << '\n';
        return 1;
    }
}
