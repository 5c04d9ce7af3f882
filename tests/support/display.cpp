// Takes xdotool's words; runs Xvfb and xdotool.
#include "tests/support/display.h"

#include <algorithm>
#include <cctype>
#include <csignal>
#include <stdexcept>

namespace billiards::support {

namespace {

bool is_number(const std::string& line) {
    return !line.empty() && std::ranges::all_of(line, [](unsigned char letter) {
        return std::isdigit(letter) != 0;
    });
}

}  // namespace

Display::Display()
    // A key repeats itself so late that a tap on a slow machine stays one.
    : server_({"/usr/bin/env", "Xvfb", "-displayfd", "1", "-screen", "0", "1280x720x24", "-ardelay",
               "3000", "-nolisten", "tcp"}) {
    // It may warn before it says its number.
    auto line = server_.read_line();
    while (line && !is_number(*line)) line = server_.read_line();
    if (!line) throw std::runtime_error("Xvfb does not start");
    name_ = ":" + *line;
}

Display::~Display() {
    server_.signal(SIGTERM);
    server_.exit_code();
}

std::vector<std::string> Display::hand(const std::vector<std::string>& words) const {
    std::vector<std::string> command{"/usr/bin/env", "DISPLAY=" + name_, "xdotool"};
    command.insert(command.end(), words.begin(), words.end());
    Process xdotool(command);
    std::vector<std::string> said = xdotool.read_lines();
    if (xdotool.exit_code() != 0) {
        throw std::runtime_error("xdotool " + words.at(0) + ": " +
                                 (said.empty() ? "failed" : said.back()));
    }
    return said;
}

}  // namespace billiards::support
