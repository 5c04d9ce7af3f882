// Takes events; gives one line each, for people or for machines.
#include "server/ops/log.h"

#include <chrono>
#include <fmt/chrono.h>
#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <spdlog/common.h>
#include <spdlog/sinks/stdout_sinks.h>
#include <string>
#include <string_view>

namespace billiards::server {
namespace {

std::string utc(spdlog::log_clock::time_point time) {
    using namespace std::chrono;
    const auto whole = floor<std::chrono::seconds>(time);
    return fmt::format("{:%Y-%m-%dT%H:%M:%S}.{:03}Z", fmt::gmtime(whole),
                       floor<milliseconds>(time - whole).count());
}

std::string_view view_of(const spdlog::string_view_t& text) {
    return {text.data(), text.size()};
}

std::string without_control_characters(std::string_view text) {
    std::string line;
    line.reserve(text.size());
    for (const char character : text) {
        const auto code = static_cast<unsigned char>(character);
        if (code >= 0x20 && code != 0x7f) {
            line += character;
        } else {
            line += fmt::format("\\x{:02x}", code);
        }
    }
    return line;
}

std::string text_line(const spdlog::details::log_msg& event) {
    return fmt::format("{} {} {}\n", utc(event.time),
                       view_of(spdlog::level::to_string_view(event.level)),
                       without_control_characters(view_of(event.payload)));
}

std::string json_line(const spdlog::details::log_msg& event) {
    const nlohmann::ordered_json line{
        {"time", utc(event.time)},
        {"level", view_of(spdlog::level::to_string_view(event.level))},
        {"message", view_of(event.payload)}};
    return line.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
}

class LineFormatter final : public spdlog::formatter {
  public:
    explicit LineFormatter(LogFormat format) : format_(format) {}

    void format(const spdlog::details::log_msg& event, spdlog::memory_buf_t& out) override {
        const std::string line = format_ == LogFormat::Json ? json_line(event) : text_line(event);
        out.append(line.data(), line.data() + line.size());
    }
    std::unique_ptr<spdlog::formatter> clone() const override {
        return std::make_unique<LineFormatter>(format_);
    }

  private:
    LogFormat format_;
};

}  // namespace

std::unique_ptr<spdlog::formatter> make_line_formatter(LogFormat format) {
    return std::make_unique<LineFormatter>(format);
}

std::shared_ptr<spdlog::logger> make_logger(LogFormat format) {
    auto logger = std::make_shared<spdlog::logger>(
        "billiards-server", std::make_shared<spdlog::sinks::stderr_sink_mt>());
    logger->set_formatter(make_line_formatter(format));
    logger->flush_on(spdlog::level::info);
    return logger;
}

}  // namespace billiards::server
