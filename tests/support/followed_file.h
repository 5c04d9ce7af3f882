// Gives a test the lines that a program under test appends to a file, as they come.
#pragma once

#include <chrono>
#include <filesystem>
#include <optional>
#include <string>

namespace billiards::support {

class FollowedFile {
  public:
    /// Makes the file, empty. Throws std::system_error where that cannot be done.
    explicit FollowedFile(const std::filesystem::path& path);
    ~FollowedFile();
    FollowedFile(const FollowedFile&) = delete;
    FollowedFile& operator=(const FollowedFile&) = delete;

    /// The next whole line, without its end; none where none comes before `deadline`. The writer
    /// never waits for the reader.
    std::optional<std::string> next_line(std::chrono::steady_clock::time_point deadline);

  private:
    int file_ = -1;
    int changes_ = -1;
    std::string unread_;
};

}  // namespace billiards::support
