// Holds the lines of the log against messages that would break them.
#include "server/ops/log.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <spdlog/sinks/ostream_sink.h>
#include <sstream>
#include <string>

namespace billiards::server {
namespace {

std::string line_of(LogFormat format, const std::string& message) {
    std::ostringstream out;
    spdlog::logger log("test", std::make_shared<spdlog::sinks::ostream_sink_st>(out));
    log.set_formatter(make_line_formatter(format));
    log.warn("{}", message);
    return out.str();
}

constexpr const char* kTime = "[0-9]{4}-[0-9]{2}-[0-9]{2}T[0-9]{2}:[0-9]{2}:[0-9]{2}[.][0-9]{3}Z";

TEST(Log, WritesTimeLevelAndMessageInOneLine) {
    EXPECT_THAT(line_of(LogFormat::Text, "listening"),
                testing::MatchesRegex(std::string(kTime) + " warning listening\n"));
}

TEST(Log, EscapesWhatWouldBreakALineOfText) {
    EXPECT_THAT(line_of(LogFormat::Text, "a\nb\x1b[2Jc\x7f"),
                testing::EndsWith("warning a\\x0ab\\x1b[2Jc\\x7f\n"));
}

TEST(Log, WritesOneJsonObjectALineWhateverTheMessage) {
    const std::string line = line_of(LogFormat::Json, "\"quoted\"\n\x01\xff");
    EXPECT_EQ(line.find('\n'), line.size() - 1);
    const auto parsed = nlohmann::json::parse(line);
    EXPECT_EQ(parsed["level"], "warning");
    EXPECT_EQ(parsed["message"], "\"quoted\"\n\x01\xef\xbf\xbd");
    EXPECT_THAT(parsed["time"].get<std::string>(), testing::MatchesRegex(kTime));
}

}  // namespace
}  // namespace billiards::server
