// Holds the children of a demonstration against what processes do.
#include "tools/demo/child_process.h"

#include "tools/demo/temp_folder.h"
#include "tools/demo/token_file.h"

#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <memory>
#include <signal.h>
#include <string>
#include <sys/stat.h>
#include <vector>

namespace billiards::tools {
namespace {

using Lines = std::vector<std::string>;

/// Runs a shell script until it writes no more, or `until` many lines came.
struct Shell {
    asio::io_context io;
    Lines lines;
    bool closed = false;
    std::unique_ptr<ChildProcess> child;

    explicit Shell(const std::string& script, std::size_t until = 1000) {
        child = std::make_unique<ChildProcess>(
            io, Lines{"/bin/sh", "-c", script},
            ChildProcess::Callbacks{.line =
                                        [this, until](const std::string& line) {
                                            lines.push_back(line);
                                            if (lines.size() == until) io.stop();
                                        },
                                    .closed = [this] { closed = true; }});
        io.run_for(std::chrono::seconds(5));
    }
};

bool is_running(pid_t pid) {
    return ::kill(pid, 0) == 0;
}

TEST(ChildProcess, GivesLinesOfBothOutputsAndTheirEnd) {
    const Shell shell("echo one; echo two >&2; printf 'no end of line'");
    EXPECT_EQ(shell.lines, (Lines{"one", "two", "no end of line"}));
    EXPECT_TRUE(shell.closed);
}

TEST(ChildProcess, HasNothingToRead) {
    EXPECT_EQ(Shell("read line || echo nothing").lines, Lines{"nothing"});
}

TEST(ChildProcess, AProgramThatIsNotThereSaysSo) {
    asio::io_context io;
    Lines lines;
    const ChildProcess child(
        io, {"/nonexistent/program"},
        {.line = [&](const std::string& line) { lines.push_back(line); }, .closed = [] {}});
    io.run_for(std::chrono::seconds(5));
    EXPECT_EQ(lines, Lines{"cannot run /nonexistent/program: No such file or directory"});
}

TEST(ChildProcess, EndsWithItsOwner) {
    Shell shell("echo $$; sleep 60", 1);
    const pid_t pid = std::stoi(shell.lines.at(0));
    EXPECT_TRUE(is_running(pid));
    shell.child.reset();
    EXPECT_FALSE(is_running(pid));
}

TEST(ChildProcess, MayTidyUpWhenAsked) {
    const TempFolder folder;
    const std::string file = (folder.path() / "tidied").string();
    Shell shell("trap 'touch " + file + "; exit' TERM; echo ready; while :; do sleep 0.01; done",
                1);
    shell.child.reset();
    EXPECT_TRUE(std::filesystem::exists(file));
}

TEST(TempFolder, IsGoneWithAllInIt) {
    std::filesystem::path path;
    {
        const TempFolder folder;
        path = folder.path();
        std::filesystem::create_directories(path / "deep" / "er");
        std::ofstream(path / "deep" / "file") << "text";
        EXPECT_TRUE(std::filesystem::exists(path / "deep" / "file"));
    }
    EXPECT_FALSE(std::filesystem::exists(path));
}

TEST(TokenFile, KeepsTheNewestTokenForItsOwnerOnly) {
    const TempFolder folder;
    const std::string path = (folder.path() / "token").string();
    EXPECT_FALSE(read_token(path));
    write_token(path, {1, 2, 3});
    write_token(path, {4, 5, 6});
    EXPECT_EQ(read_token(path), (protocol::ResumeToken{4, 5, 6}));
    struct stat status {};
    ASSERT_EQ(::stat(path.c_str(), &status), 0);
    EXPECT_EQ(status.st_mode & 0777U, 0600U);
}

TEST(TokenFile, WhatIsNoTokenIsAnError) {
    const TempFolder folder;
    const std::string path = (folder.path() / "token").string();
    std::ofstream(path) << "short";
    EXPECT_THROW(read_token(path), std::runtime_error);
    EXPECT_THROW(write_token((folder.path() / "nowhere" / "token").string(), {}),
                 std::system_error);
}

}  // namespace
}  // namespace billiards::tools
