// Gives a server in this process: for two players at one screen, and for a host who plays along.
#pragma once

#include "client/net/address.h"

#include <cstdint>
#include <filesystem>
#include <memory>

namespace billiards::client {

struct LocalServerOptions {
    std::filesystem::path data;  ///< Created where it is missing; one server at a time.
    std::uint16_t port = 0;      ///< 0: any that is free.
    /// Others can reach it, and what is said to it is not encrypted. Otherwise this machine alone.
    bool is_for_others = false;
};

/// The same server that billiards-server runs, on threads of its own.
class LocalServer {
  public:
    /// Throws std::runtime_error with a sentence where the port or the folder cannot be used.
    explicit LocalServer(const LocalServerOptions& options);
    /// Stops it in order.
    ~LocalServer();

    /// Where a client in this process connects.
    ServerAddress address() const;

  private:
    struct Running;
    std::unique_ptr<Running> running_;
};

}  // namespace billiards::client
