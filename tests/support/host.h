// Gives a test a billiards-server of its own: a process on 127.0.0.1, on a port and a folder that
// it keeps over restarts.
#pragma once

#include "tests/support/process.h"
#include "tests/support/temporary_folder.h"

#include <cstdint>
#include <filesystem>
#include <memory>

namespace billiards::support {

class Host {
  public:
    /// Throws std::runtime_error where the server does not start.
    Host() { start(); }

    void start();
    /// Starts it, and does not wait until it listens.
    void begin_to_start();
    /// As a power cut would; what was not durable is gone.
    void kill_minus_nine() { server_->kill_minus_nine(); }
    /// Asks it to stop; gives its exit code.
    int stop();

    pid_t pid() const { return server_->pid(); }
    std::uint16_t port() const { return port_; }
    std::filesystem::path data() const { return folder_.path() / "data"; }
    std::filesystem::path database() const { return data() / "billiards.db"; }

  private:
    TemporaryFolder folder_;
    std::unique_ptr<Process> server_;
    std::uint16_t port_ = 0;
};

}  // namespace billiards::support
