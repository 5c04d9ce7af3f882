// Takes a command; gives a process whose lines are read as they come, and that never outlives this
// object.
#pragma once

#include <asio/io_context.hpp>
#include <asio/posix/stream_descriptor.hpp>
#include <asio/streambuf.hpp>
#include <functional>
#include <memory>
#include <string>
#include <sys/types.h>
#include <vector>

namespace billiards::tools {

class ChildProcess {
  public:
    struct Callbacks {
        std::function<void(const std::string& line)> line;  ///< Without its end.
        std::function<void()> closed;  ///< It writes no more: most likely it has ended.
    };

    /// Standard output and standard error are read together, standard input is empty. Throws where
    /// the system cannot start a process; a program that is not there ends at once and says so.
    ChildProcess(asio::io_context& io, const std::vector<std::string>& command,
                 Callbacks callbacks);
    /// Asks it to end, waits for kPatience, then kills it. No callback comes after it.
    ~ChildProcess();
    ChildProcess(const ChildProcess&) = delete;
    ChildProcess& operator=(const ChildProcess&) = delete;

  private:
    struct Reader;

    pid_t pid_ = -1;
    std::shared_ptr<Reader> reader_;
};

}  // namespace billiards::tools
