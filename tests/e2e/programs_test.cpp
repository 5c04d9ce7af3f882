// Runs the programs as a newcomer would, rightly and wrongly: each says what is the matter in one
// line that names the cause.
#include "tests/e2e/match_runner.h"
#include "tests/support/process.h"
#include "tests/support/temporary_folder.h"

#include <csignal>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace billiards::e2e {
namespace {

using support::Process;

struct Ran {
    int exit_code = 0;
    std::vector<std::string> lines;
    std::string last() const { return lines.empty() ? "" : lines.back(); }
};

Ran run(const std::vector<std::string>& command) {
    Process process(command);
    Ran ran;
    ran.lines = process.read_lines();
    ran.exit_code = process.exit_code();
    return ran;
}

std::string address(std::uint16_t port) {
    return "127.0.0.1:" + std::to_string(port);
}

TEST(Programs, EachHasHelp) {
    for (const char* program : {BILLIARDS_SERVER_PROGRAM, BILLIARDS_DEMO_PROGRAM,
                                BILLIARDS_LOAD_PROGRAM, BILLIARDS_SIM_PROGRAM}) {
        const Ran ran = run({program, "--help"});
        EXPECT_EQ(ran.exit_code, 0) << program;
        EXPECT_GT(ran.lines.size(), 3U) << program;
    }
}

TEST(Programs, TheDemonstrationEndsWithItsResult) {
    const Ran ran = run({BILLIARDS_DEMO_PROGRAM, "--race", "1", "--think", "0", "--seed", "3"});
    EXPECT_EQ(ran.exit_code, 0) << ran.last();
    EXPECT_TRUE(ran.last().starts_with("demo: 8-ball, race to 1, ")) << ran.last();
    EXPECT_TRUE(ran.last().ends_with(" shots, 0 pictures")) << ran.last();
}

TEST(Programs, TheDemonstrationGoesOnWithoutTheProgramThatDraws) {
    support::TemporaryFolder folder;
    const Ran ran = run({BILLIARDS_DEMO_PROGRAM, "--race", "1", "--think", "0", "--pictures",
                         folder.path().string(), "--window", "/nonexistent/billiards"});
    EXPECT_EQ(ran.exit_code, 0) << ran.last();
    EXPECT_EQ(ran.lines.at(0),
              "no pictures: cannot run /nonexistent/billiards: No such file or directory");
    EXPECT_TRUE(ran.last().ends_with(" shots, 0 pictures")) << ran.last();
}

#ifdef BILLIARDS_WINDOW_PROGRAM
TEST(Programs, TheDemonstrationLeavesPicturesOfItsRack) {
    support::TemporaryFolder folder;
    std::ofstream(folder.path() / "rack9-end.png") << "of an earlier demonstration";
    const Ran ran = run({BILLIARDS_DEMO_PROGRAM, "--race", "1", "--think", "0", "--seed", "3",
                         "--pictures", folder.path().string()});
    EXPECT_EQ(ran.exit_code, 0) << ran.last();
    EXPECT_TRUE(ran.last().ends_with(" shots, 3 pictures")) << ran.last();
    for (const char* name : {"rack1-break.png", "rack1-middle.png", "rack1-end.png"}) {
        // A picture of one colour takes a hundredth of this.
        ASSERT_TRUE(std::filesystem::exists(folder.path() / name)) << name;
        EXPECT_GT(std::filesystem::file_size(folder.path() / name), 50'000U) << name;
    }
    EXPECT_FALSE(std::filesystem::exists(folder.path() / "rack9-end.png"));
}

TEST(Programs, AWatchedTableThatIsNotThereIsToldAndEndsTheProgram) {
    Host host;
    support::TemporaryFolder folder;
    // Graphics drivers keep what they have until the end, and call it no leak.
    const Ran ran = run({"/usr/bin/env", "ASAN_OPTIONS=detect_leaks=0", BILLIARDS_WINDOW_PROGRAM,
                         "--offscreen", "--server", address(host.port()), "--table", "77",
                         "--watch", "--pictures", folder.path().string()});
    EXPECT_EQ(ran.exit_code, 1);
    EXPECT_NE(ran.last().find("table"), std::string::npos) << ran.last();
}
#endif

TEST(Programs, TheDemonstrationLeavesAMatchThatVerifies) {
    support::TemporaryFolder folder;
    const std::string file = (folder.path() / "match.billiards").string();
    const Ran demo =
        run({BILLIARDS_DEMO_PROGRAM, "--race", "1", "--think", "0", "--seed", "4", "--keep", file});
    EXPECT_EQ(demo.exit_code, 0) << demo.last();
    EXPECT_TRUE(demo.last().starts_with("demo: 8-ball")) << demo.last();
    const Ran verified = run({BILLIARDS_SIM_PROGRAM, "replay", file, "--print", "--verify"});
    EXPECT_EQ(verified.exit_code, 0) << verified.last();
    EXPECT_TRUE(verified.last().starts_with("verified: ")) << verified.last();
    ASSERT_FALSE(verified.lines.empty());
    EXPECT_NE(verified.lines.front().find(" - "), std::string::npos) << verified.lines.front();
}

TEST(Programs, AServerSaysThatItsPortIsInUse) {
    Host host;
    support::TemporaryFolder folder;
    const Ran ran = run({BILLIARDS_SERVER_PROGRAM, "--listen", address(host.port()), "--data",
                         folder.path().string()});
    EXPECT_EQ(ran.exit_code, 1);
    EXPECT_NE(ran.last().find(address(host.port())), std::string::npos) << ran.last();
    EXPECT_NE(ran.last().find("in use"), std::string::npos) << ran.last();
}

TEST(Programs, AServerSaysThatItsDataFolderCannotBeWritten) {
    support::TemporaryFolder folder;
    const auto file = folder.path() / "file";
    std::ofstream(file) << "no folder";
    const Ran ran = run(
        {BILLIARDS_SERVER_PROGRAM, "--listen", "127.0.0.1:0", "--data", (file / "data").string()});
    EXPECT_EQ(ran.exit_code, 1);
    EXPECT_NE(ran.last().find((file / "data").string()), std::string::npos) << ran.last();
}

TEST(Programs, AServerKeepsItsFilesForItsOwnerAlone) {
    Host host;
    for (const auto& file : std::filesystem::directory_iterator(host.data())) {
        const auto others = std::filesystem::perms::group_all | std::filesystem::perms::others_all;
        EXPECT_EQ(file.status().permissions() & others, std::filesystem::perms::none)
            << file.path();
    }
}

TEST(Programs, TwoServersDoNotShareADataFolder) {
    Host host;
    const Ran ran =
        run({BILLIARDS_SERVER_PROGRAM, "--listen", "127.0.0.1:0", "--data", host.data().string()});
    EXPECT_EQ(ran.exit_code, 1);
    EXPECT_NE(ran.last().find(host.data().string()), std::string::npos) << ran.last();
}

TEST(Programs, AServerDoesNotListenToTheWorldUnencryptedUnasked) {
    support::TemporaryFolder folder;
    const Ran ran =
        run({BILLIARDS_SERVER_PROGRAM, "--listen", "0.0.0.0:0", "--data", folder.path().string()});
    EXPECT_EQ(ran.exit_code, 1);
    EXPECT_NE(ran.last().find("--plain"), std::string::npos) << ran.last();
}

TEST(Programs, APlayerSaysWhyItCannotConnect) {
    std::uint16_t port = 0;
    {
        const Host host;
        port = host.port();
    }
    const Ran refused = run({BILLIARDS_DEMO_PROGRAM, "play", "--server", address(port)});
    EXPECT_EQ(refused.exit_code, 1);
    EXPECT_NE(refused.lines.at(0).find(address(port)), std::string::npos) << refused.lines.at(0);

    const Ran unknown =
        run({BILLIARDS_DEMO_PROGRAM, "play", "--server", "no-such-host.invalid:4747"});
    EXPECT_EQ(unknown.exit_code, 1);
    EXPECT_NE(unknown.lines.at(0).find("no-such-host.invalid"), std::string::npos)
        << unknown.lines.at(0);
}

TEST(Programs, AServerStopsCleanlyOnSigtermAndOnCtrlC) {
    for (const int number : {SIGTERM, SIGINT}) {
        support::TemporaryFolder folder;
        Process server({BILLIARDS_SERVER_PROGRAM, "--listen", "127.0.0.1:0", "--data",
                        folder.path().string()});
        ASSERT_TRUE(server.read_line_with("listening on"));
        server.signal(number);
        EXPECT_EQ(server.exit_code(), 0);
    }
}

TEST(Programs, TheLoadGeneratorGivesOneJsonObjectInEveryMode) {
    Host host;
    for (const char* mode : {"play", "idle", "spectate", "slow", "garbage", "flap"}) {
        const Ran ran =
            run({BILLIARDS_LOAD_PROGRAM, "--server", address(host.port()), "--mode", mode,
                 "--tables", "2", "--spectators", "2", "--seconds", "2", "--seed", "1"});
        EXPECT_EQ(ran.exit_code, 0) << mode << ": " << ran.last();
        const auto json = nlohmann::json::parse(ran.last(), nullptr, false);
        ASSERT_FALSE(json.is_discarded()) << mode << ": " << ran.last();
        for (const char* key :
             {"shots", "errors", "shot_to_broadcast_ms", "fsync_ms", "bytes_per_shot",
              "connections", "reconnects", "server_rss_mb", "server_cpu_s"}) {
            EXPECT_TRUE(json.contains(key)) << mode << ": " << key;
        }
    }
    EXPECT_EQ(host.stop(), 0);
}

}  // namespace
}  // namespace billiards::e2e
