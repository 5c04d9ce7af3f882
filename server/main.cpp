// Takes the command line; gives a server that runs until it is asked to stop, or a match that one
// has kept, or a copy of everything. Exits with 0, or with 1 and one line that says why it could
// not.
#include "server/config.h"
#include "server/server.h"

#include <asio/io_context.hpp>
#include <asio/signal_set.hpp>
#include <csignal>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <spdlog/spdlog.h>
#include <sys/resource.h>
#include <sys/stat.h>

namespace {

using namespace billiards::server;

std::optional<std::string> environment_variable(const std::string& name) {
    const char* value = std::getenv(name.c_str());
    return value ? std::optional<std::string>(value) : std::nullopt;
}

/// Each connection needs a descriptor, and the usual soft limit is meant for programs with few.
rlim_t use_all_descriptors() {
    rlimit limit{};
    ::getrlimit(RLIMIT_NOFILE, &limit);
    limit.rlim_cur = limit.rlim_max;
    ::setrlimit(RLIMIT_NOFILE, &limit);
    return limit.rlim_cur;
}

/// From its making on, the program is not ended by SIGINT and SIGTERM but asked to stop.
class StopSignal {
  public:
    /// A second signal ends the program at once, by the system's default.
    const char* wait() {
        int number = 0;
        signals_.async_wait([&number](const asio::error_code&, int came) { number = came; });
        context_.run();
        signals_.clear();
        return number == SIGTERM ? "SIGTERM" : "SIGINT";
    }

  private:
    asio::io_context context_;
    asio::signal_set signals_{context_, SIGINT, SIGTERM};
};

int run(const CommandLine& command_line, spdlog::logger& log) {
    try {
        StopSignal signal;
        const rlim_t descriptors = use_all_descriptors();
        Server server(command_line.server, log);
        log.info("at most {} open files and connections", descriptors);
        log.info("stopping on {}", signal.wait());
        server.stop();
        log.info("stopped");
        return EXIT_SUCCESS;
    } catch (const std::exception& error) {
        log.critical("{}", error.what());
        return EXIT_FAILURE;
    }
}

}  // namespace

int main(int argc, char** argv) {
    ::umask(S_IRWXG | S_IRWXO);  // What it keeps are others' names, matches and secrets.
    const auto command_line = parse_command_line(argc, argv, environment_variable);
    if (!command_line) {
        const Farewell& farewell = command_line.error();
        (farewell.exit_code == 0 ? std::cout : std::cerr) << farewell.text;
        return farewell.exit_code;
    }
    if (command_line->to_export) {
        return export_match(*command_line->to_export, std::cout, std::cerr);
    }
    if (command_line->to_back_up) {
        return back_up(*command_line->to_back_up, std::cout, std::cerr);
    }
    // Beyond a limit on the size of files a write fails, as on a full disk; it need not be fatal.
    std::signal(SIGXFSZ, SIG_IGN);
    return run(*command_line, *make_logger(command_line->log_format));
}
