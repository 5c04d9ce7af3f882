// Takes a path; reads what is appended there, and sleeps in inotify until more is.
#include "tests/support/followed_file.h"

#include <cerrno>
#include <fcntl.h>
#include <poll.h>
#include <sys/inotify.h>
#include <system_error>
#include <unistd.h>

namespace billiards::support {

namespace {

using Clock = std::chrono::steady_clock;
constexpr std::size_t kAtOnce = 1U << 16U;

int opened(int descriptor, const char* what) {
    if (descriptor < 0) throw std::system_error(errno, std::generic_category(), what);
    return descriptor;
}

/// Until the file has changed; false where the deadline comes first.
bool wait_for_change(int changes, Clock::time_point deadline) {
    const auto left = std::chrono::ceil<std::chrono::milliseconds>(deadline - Clock::now());
    pollfd waiting{.fd = changes, .events = POLLIN, .revents = 0};
    if (left.count() <= 0 || ::poll(&waiting, 1, static_cast<int>(left.count())) <= 0) return false;
    char ignored[kAtOnce];
    return ::read(changes, ignored, sizeof ignored) > 0;
}

}  // namespace

FollowedFile::FollowedFile(const std::filesystem::path& path)
    : file_(opened(::open(path.c_str(), O_RDONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0600), "open")),
      changes_(opened(::inotify_init1(IN_CLOEXEC), "inotify")) {
    opened(::inotify_add_watch(changes_, path.c_str(), IN_MODIFY), "inotify");
}

FollowedFile::~FollowedFile() {
    ::close(changes_);
    ::close(file_);
}

std::optional<std::string> FollowedFile::next_line(Clock::time_point deadline) {
    while (true) {
        const std::size_t end = unread_.find('\n');
        if (end != std::string::npos) {
            std::string line = unread_.substr(0, end);
            unread_.erase(0, end + 1);
            return line;
        }
        char buffer[kAtOnce];
        const ssize_t count = ::read(file_, buffer, sizeof buffer);
        if (count > 0) {
            unread_.append(buffer, static_cast<std::size_t>(count));
        } else if (!wait_for_change(changes_, deadline)) {
            return std::nullopt;
        }
    }
}

}  // namespace billiards::support
