// Takes the command line; gives a played match and an exit code.
#include "tools/demo/demo.h"
#include "tools/demo/options.h"
#include "tools/demo/role.h"

#include <exception>
#include <filesystem>
#include <iostream>
#include <stdexcept>
#include <variant>

namespace {

struct Run {
    int operator()(const billiards::tools::DemoOptions& options) const {
        return play_demo(options, std::filesystem::read_symlink("/proc/self/exe"));
    }
    int operator()(const billiards::tools::RoleOptions& options) const {
        return play_role(options);
    }
    int operator()(billiards::tools::ExitCode code) const { return code.value; }
};

}  // namespace

int main(int argc, char** argv) {
    try {
        const int exit_code = std::visit(Run{}, billiards::tools::parse_options(argc, argv));
        if (exit_code == 0 && !std::cout.flush())
            throw std::runtime_error("the output could not be written");
        return exit_code;
    } catch (const std::exception& error) {
        std::cerr << "billiards-demo: " << error.what() << '\n';
        return 1;
    }
}
