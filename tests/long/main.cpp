// Takes what to prove and how often; gives one line of figures, and fails at the first fault.
#include "tests/long/breaks.h"
#include "tests/long/matches.h"

#include <CLI/CLI.hpp>
#include <exception>
#include <iostream>

int main(int argc, char** argv) {
    try {
        CLI::App app{"Proofs that take longer than a test may"};
        app.require_subcommand(1);
        billiards::BreaksOrder order;
        CLI::App* breaks = app.add_subcommand("breaks", "Invariants over random and frozen shots");
        breaks->add_option("--shots", order.shots, "How many")->check(CLI::PositiveNumber);
        breaks->add_option("--first", order.first, "The number of the first; each is a seed");
        billiards::MatchesOrder plays;
        CLI::App* matches = app.add_subcommand("matches", "Whole matches at random, of every game");
        matches->add_option("--count", plays.count, "How many a game")->check(CLI::PositiveNumber);
        matches->add_option("--first", plays.first, "The number of the first; each is a seed");
        CLI11_PARSE(app, argc, argv);
        const bool held = breaks->parsed() ? billiards::prove_breaks(order, std::cout)
                                           : billiards::prove_matches(plays, std::cout);
        return held ? 0 : 1;
    } catch (const std::exception& error) {
        std::cerr << "billiards-long-test: " << error.what() << '\n';
        return 1;
    }
}
