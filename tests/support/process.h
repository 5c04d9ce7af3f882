// Gives a test a program to run: its lines as they come, its exit code, and any signal it needs to
// be sent. No process outlives its object.
#pragma once

#include <chrono>
#include <optional>
#include <string>
#include <sys/types.h>
#include <vector>

namespace billiards::support {

class Process {
  public:
    static constexpr std::chrono::seconds kPatience{60};

    /// Standard output and standard error are read together, standard input is empty. Throws
    /// std::system_error where the program cannot be started.
    explicit Process(const std::vector<std::string>& command);
    /// Kills it, if it still runs.
    ~Process();
    Process(Process&& other) noexcept;
    Process& operator=(Process&&) = delete;
    Process(const Process&) = delete;
    Process& operator=(const Process&) = delete;

    /// The next line, without its end; none where it writes no more, or `limit` has passed.
    std::optional<std::string> read_line(std::chrono::milliseconds limit = kPatience);
    /// Everything that it writes until it ends.
    std::vector<std::string> read_lines(std::chrono::milliseconds limit = kPatience);
    /// The next line that holds `part`; those before it are dropped.
    std::optional<std::string> read_line_with(const std::string& part);

    pid_t pid() const { return pid_; }
    void signal(int number);
    /// Kills it as a power cut would, and waits until it is gone.
    void kill_minus_nine();
    /// Its exit code, or 128 + the signal that ended it; waits for it.
    int exit_code();

  private:
    pid_t pid_ = -1;
    int output_ = -1;
    std::string unread_;
    std::optional<int> exit_code_;
};

}  // namespace billiards::support
