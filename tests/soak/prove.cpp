// Takes the command line of a proof and what it does; gives the program's exit code.
#include "tests/soak/prove.h"

#include <exception>
#include <iostream>

namespace billiards::soak {
namespace {

void add_options(CLI::App& app, HallOptions& hall) {
    app.add_option("--seed", hall.seed)->capture_default_str();
    app.add_option_function<double>(
           "--max-think", [&hall](double think_s) { hall.max_think = base::duration_of(think_s); },
           "Seconds")
        ->check(CLI::Range(0.0, 60.0));
    app.add_option_function<double>(
        "--seconds-limit", [&hall](double limit_s) { hall.limit = base::duration_of(limit_s); },
        "Beyond it something is stuck");
}

}  // namespace

int prove(CLI::App& app, int argc, const char* const* argv, HallOptions& hall,
          const std::function<nlohmann::ordered_json()>& proof) {
    try {
        add_options(app, hall);
        CLI11_PARSE(app, argc, argv);
        std::cout << proof().dump() << std::endl;
        return 0;
    } catch (const BrokenPromise& broken) {
        std::cerr << "seed " << hall.seed << ": " << broken.what() << std::endl;
    } catch (const std::exception& error) {
        std::cerr << app.get_name() << ": " << error.what() << '\n';
    }
    return 1;
}

}  // namespace billiards::soak
