// Takes a command; forks, reads its lines, and sees to its end.
#include "tools/demo/child_process.h"

#include <array>
#include <asio/read_until.hpp>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <fcntl.h>
#include <istream>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <system_error>
#include <thread>
#include <unistd.h>
#include <utility>

namespace billiards::tools {

namespace {

constexpr std::size_t kMaxLineBytes = 1024 * 1024;
constexpr std::chrono::seconds kPatience{3};
constexpr std::chrono::milliseconds kLook{10};
constexpr int kCannotRun = 127;  ///< As shells have it.

std::system_error failure(const char* what) {
    return {errno, std::generic_category(), what};
}

/// After fork only calls that are safe there; never returns.
[[noreturn]] void become(std::vector<char*>& arguments, int output, pid_t parent) {
    ::prctl(PR_SET_PDEATHSIG, SIGKILL);
    if (::getppid() != parent) ::_exit(kCannotRun);  // It died before the line above.
    ::setpgid(0, 0);  // Ctrl-C is for the parent, which then ends us.
    const int input = ::open("/dev/null", O_RDONLY | O_CLOEXEC);
    ::dup2(input, STDIN_FILENO);
    ::dup2(output, STDOUT_FILENO);
    ::dup2(output, STDERR_FILENO);
    ::execv(arguments.front(), arguments.data());
    const char* const reason = ::strerror(errno);
    const std::array<const char*, 4> parts{"cannot run ", arguments.front(), ": ", reason};
    for (const char* const part : parts) {
        if (::write(STDERR_FILENO, part, std::strlen(part)) < 0) break;
    }
    ::_exit(kCannotRun);
}

pid_t spawn(const std::vector<std::string>& command, int output) {
    std::vector<std::string> copies = command;
    std::vector<char*> arguments;
    for (std::string& copy : copies) arguments.push_back(copy.data());
    arguments.push_back(nullptr);
    const pid_t parent = ::getpid();
    const pid_t pid = ::fork();
    if (pid < 0) throw failure("fork");
    if (pid == 0) become(arguments, output, parent);
    return pid;
}

bool has_ended(pid_t pid) {
    return ::waitpid(pid, nullptr, WNOHANG) != 0;
}

}  // namespace

struct ChildProcess::Reader : std::enable_shared_from_this<Reader> {
    Reader(asio::io_context& io, int descriptor, Callbacks told)
        : pipe(io, descriptor), callbacks(std::move(told)) {}

    void read() {
        asio::async_read_until(
            pipe, buffer, '\n',
            [self = shared_from_this()](const asio::error_code& error, std::size_t) {
                if (!self->pipe.is_open()) return;  // Closed by the owner.
                std::string line;
                std::istream stream(&self->buffer);
                if (std::getline(stream, line)) self->callbacks.line(line);
                if (!self->pipe.is_open()) return;
                if (error) return self->callbacks.closed();
                self->read();
            });
    }

    asio::posix::stream_descriptor pipe;
    Callbacks callbacks;
    asio::streambuf buffer{kMaxLineBytes};
};

ChildProcess::ChildProcess(asio::io_context& io, const std::vector<std::string>& command,
                           Callbacks callbacks) {
    std::array<int, 2> ends{};
    if (::pipe2(ends.data(), O_CLOEXEC) != 0) throw failure("pipe");
    reader_ = std::make_shared<Reader>(io, ends[0], std::move(callbacks));
    try {
        pid_ = spawn(command, ends[1]);
    } catch (...) {
        ::close(ends[1]);
        throw;
    }
    ::close(ends[1]);
    reader_->read();
}

ChildProcess::~ChildProcess() {
    asio::error_code ignored;
    reader_->pipe.close(ignored);
    ::kill(pid_, SIGTERM);
    const auto until = std::chrono::steady_clock::now() + kPatience;
    while (!has_ended(pid_)) {
        if (std::chrono::steady_clock::now() >= until) {
            ::kill(pid_, SIGKILL);
            ::waitpid(pid_, nullptr, 0);
            return;
        }
        std::this_thread::sleep_for(kLook);
    }
}

}  // namespace billiards::tools
