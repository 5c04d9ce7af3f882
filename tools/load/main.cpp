// Takes the command line; gives one JSON object on standard output.
#include "tools/load/load.h"
#include "tools/load/options.h"

#include <exception>
#include <iostream>
#include <variant>

int main(int argc, char** argv) {
    try {
        auto parsed = billiards::tools::parse_load_options(argc, argv);
        if (const int* exit_code = std::get_if<int>(&parsed)) return *exit_code;
        auto& options = std::get<billiards::tools::LoadOptions>(parsed);
        options.in_place = [] { std::cerr << "billiards-load: in place" << std::endl; };
        const auto report = billiards::tools::make_load(options);
        std::cout << report.dump() << std::endl;
        return 0;
    } catch (const std::exception& error) {
        std::cerr << "billiards-load: " << error.what() << '\n';
        return 1;
    }
}
