// Asks for /metrics over HTTP/1.0 and reads the answer.
#include "tools/load/scrape.h"

#include <asio/ip/tcp.hpp>
#include <chrono>
#include <cstdlib>
#include <sstream>
#include <string>

namespace billiards::tools {

namespace {

constexpr std::chrono::seconds kPatience{3};

}  // namespace

nlohmann::ordered_json scrape(const client::ServerAddress& address) {
    asio::ip::tcp::iostream stream;
    stream.expires_after(kPatience);
    stream.connect(address.host, std::to_string(address.port));
    stream << "GET /metrics HTTP/1.0\r\nHost: " << address.host << "\r\n\r\n" << std::flush;
    std::ostringstream answer;
    answer << stream.rdbuf();
    const std::string text = answer.str();
    const std::size_t body = text.find("\r\n\r\n");
    if (body == std::string::npos) return nullptr;
    return parse_metrics(text.substr(body));
}

nlohmann::ordered_json parse_metrics(const std::string& text) {
    nlohmann::ordered_json metrics = nlohmann::ordered_json::object();
    std::istringstream lines(text);
    std::string line;
    while (std::getline(lines, line)) {
        const std::size_t space = line.rfind(' ');
        if (line.empty() || line.front() == '#' || space == std::string::npos) continue;
        char* end = nullptr;
        const double value = std::strtod(line.c_str() + space, &end);
        if (end != line.c_str() + space) metrics[line.substr(0, space)] = value;
    }
    return metrics;
}

}  // namespace billiards::tools
