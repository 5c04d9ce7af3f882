// Holds the command line of the load generator against what people type.
#include "tools/load/options.h"

#include <gtest/gtest.h>
#include <vector>

namespace billiards::tools {
namespace {

std::variant<LoadOptions, int> parsed(std::vector<const char*> arguments) {
    arguments.insert(arguments.begin(), "billiards-load");
    return parse_load_options(static_cast<int>(arguments.size()), arguments.data());
}

TEST(LoadOptions, AreReadAndHaveDefaults) {
    const auto options = std::get<LoadOptions>(
        parsed({"--server", "[::1]:4000", "--mode", "flap", "--tables", "7", "--server-pid", "12",
                "--http", "127.0.0.1:9", "--min-think", "9"}));
    EXPECT_EQ(options.server, (client::ServerAddress{.host = "::1", .port = 4000}));
    EXPECT_EQ(options.mode, LoadMode::Flap);
    EXPECT_EQ(options.tables, 7);
    EXPECT_EQ(options.server_pid, 12);
    EXPECT_EQ(options.http->port, 9);
    EXPECT_EQ(options.spectators, LoadOptions{}.spectators);
    EXPECT_GE(options.max_think_s, options.min_think_s);
}

TEST(LoadOptions, EveryModeHasItsName) {
    for (const char* mode :
         {"play", "idle", "spectate", "slow", "garbage", "flap", "reconnect", "stall"}) {
        const auto options = std::get<LoadOptions>(parsed({"--server", "here:1", "--mode", mode}));
        EXPECT_EQ(name_of(options.mode), mode);
    }
}

TEST(LoadOptions, WhatMakesNoSenseEndsWithTwo) {
    const std::vector<std::vector<const char*>> wrong{{},
                                                      {"--server", "here:none"},
                                                      {"--server", "here:1", "--mode", "dance"},
                                                      {"--server", "here:1", "--tables", "0"},
                                                      {"--server", "here:1", "--nonsense"}};
    for (const auto& arguments : wrong) {
        testing::internal::CaptureStderr();
        EXPECT_EQ(std::get<int>(parsed(arguments)), 2);
        EXPECT_FALSE(testing::internal::GetCapturedStderr().empty());
    }
}

}  // namespace
}  // namespace billiards::tools
