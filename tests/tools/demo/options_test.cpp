// Holds the command line of the demonstration against what people type.
#include "tools/demo/options.h"

#include <gtest/gtest.h>
#include <vector>

namespace billiards::tools {
namespace {

std::variant<DemoOptions, RoleOptions, ExitCode> parsed(std::vector<const char*> arguments) {
    arguments.insert(arguments.begin(), "billiards-demo");
    return parse_options(static_cast<int>(arguments.size()), arguments.data());
}

TEST(DemoOptions, WithoutArgumentsItIsARaceToTwoOnAServerOfItsOwn) {
    const auto options = std::get<DemoOptions>(parsed({}));
    EXPECT_EQ(options.race_to, 2);
    EXPECT_EQ(options.server_program, "");
    EXPECT_FALSE(options.connect);
}

TEST(DemoOptions, AServerThatRunsMayBeUsed) {
    const auto options = std::get<DemoOptions>(parsed({"--connect", "here:1", "--race", "5"}));
    EXPECT_EQ(options.connect, (client::ServerAddress{.host = "here", .port = 1}));
    EXPECT_EQ(options.race_to, 5);
}

TEST(DemoOptions, TheMatchMayBeKept) {
    EXPECT_EQ(std::get<DemoOptions>(parsed({})).keep, "");
    EXPECT_EQ(std::get<DemoOptions>(parsed({"--keep", "m.billiards"})).keep, "m.billiards");
}

TEST(DemoOptions, APlayerOpensATableOrJoinsOne) {
    const auto opens = std::get<RoleOptions>(parsed({"play", "--server", "here:1"}));
    EXPECT_EQ(opens.role, protocol::Role::Player);
    EXPECT_FALSE(opens.table);
    const auto joins = std::get<RoleOptions>(
        parsed({"play", "--server", "here:1", "--table", "3", "--name", "Ada", "--json"}));
    EXPECT_EQ(joins.table, protocol::TableId{3});
    EXPECT_EQ(joins.name, "Ada");
    EXPECT_TRUE(joins.json);
}

TEST(DemoOptions, ASpectatorNeedsATable) {
    const auto watches =
        std::get<RoleOptions>(parsed({"watch", "--server", "here:1", "--table", "3"}));
    EXPECT_EQ(watches.role, protocol::Role::Spectator);
    testing::internal::CaptureStderr();
    EXPECT_EQ(std::get<ExitCode>(parsed({"watch", "--server", "here:1"})).value, 2);
    EXPECT_NE(testing::internal::GetCapturedStderr().find("--table"), std::string::npos);
}

TEST(DemoOptions, WhatMakesNoSenseEndsWithTwo) {
    const std::vector<std::vector<const char*>> wrong{
        {"--race", "0"}, {"--connect", "here:none"}, {"play"}, {"dance"}};
    for (const auto& arguments : wrong) {
        testing::internal::CaptureStderr();
        EXPECT_EQ(std::get<ExitCode>(parsed(arguments)).value, 2);
        EXPECT_FALSE(testing::internal::GetCapturedStderr().empty());
    }
}

}  // namespace
}  // namespace billiards::tools
