// Takes the server's program; runs it, and reads its port from its log.
#include "tests/support/host.h"

#include <csignal>
#include <stdexcept>
#include <string>
#include <vector>

namespace billiards::support {

void Host::begin_to_start() {
    server_ = std::make_unique<Process>(
        std::vector<std::string>{BILLIARDS_SERVER_PROGRAM, "--listen",
                                 "127.0.0.1:" + std::to_string(port_), "--data", data().string()});
}

void Host::start() {
    begin_to_start();
    const auto line = server_->read_line_with("listening on 127.0.0.1:");
    if (!line) throw std::runtime_error("the server did not start");
    port_ = static_cast<std::uint16_t>(std::stoi(line->substr(line->rfind(':') + 1)));
}

int Host::stop() {
    server_->signal(SIGTERM);
    return server_->exit_code();
}

}  // namespace billiards::support
