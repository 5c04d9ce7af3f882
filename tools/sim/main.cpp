// Takes the command line and cases on standard input; gives answers on standard output.
#include "tools/sim/bench.h"
#include "tools/sim/case_stream.h"
#include "tools/sim/judge.h"
#include "tools/sim/solve.h"

#include <CLI/CLI.hpp>
#include <exception>
#include <iostream>
#include <map>
#include <stdexcept>
#include <string>

namespace {

using namespace billiards::tools;

constexpr int kBadInput = 2;

int answer(const AnswerCase& answer_case, bool is_by_line) {
    return is_by_line ? answer_lines(std::cin, std::cout, answer_case)
                      : answer_one(std::cin, std::cout, std::cerr, answer_case);
}

int run(int argc, char** argv) {
    CLI::App app{"The physics and the rules of gl-billiards without a match: JSON in, JSON out"};
    app.require_subcommand(1);

    CLI::App* solving = app.add_subcommand("solve", "Solve the motion of balls on a table");
    CLI::App* judging = app.add_subcommand("judge", "Judge a told shot by the rules of a game");
    bool is_by_line = false;
    for (CLI::App* answering : {solving, judging}) {
        answering->add_flag("--jsonl", is_by_line, "One case a line; errors stay on their line");
    }

    CLI::App* benching = app.add_subcommand("bench", "Measure how fast shots are solved");
    BenchCase bench_case = BenchCase::Break8;
    double seconds = 2.0;
    const std::map<std::string, BenchCase> cases{
        {"break8", BenchCase::Break8}, {"break9", BenchCase::Break9}, {"mid", BenchCase::Mid}};
    benching->add_option("--case", bench_case, "break8, break9 or mid")
        ->transform(CLI::CheckedTransformer(cases));
    benching->add_option("--seconds", seconds, "How long; 1,000 shots at least")
        ->check(CLI::Range(0.0, 3600.0));

    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        return app.exit(error) == 0 ? 0 : kBadInput;
    }
    if (solving->parsed()) return answer(solve, is_by_line);
    if (judging->parsed()) return answer(judge, is_by_line);
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
