// Takes a configuration; gives a running server, and an orderly end of it.
#pragma once

#include "server/net/address.h"
#include "server/net/net_limits.h"
#include "server/session/limits.h"

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <spdlog/logger.h>
#include <vector>

namespace billiards::server {

/// What is kept of matches that have ended; results are kept for ever.
struct KeepLimits {
    std::int64_t days = 365;         ///< Journals, and guests who never finished a match; 0: ever.
    std::uint64_t megabytes = 4096;  ///< Of the database: the oldest journals go first; 0: any.
    std::chrono::seconds sweep_every{3600};
};

struct ServerConfig {
    std::vector<Endpoint> listen;  ///< At least one; port 0 takes a free one.
    std::optional<Endpoint> http;  ///< Where /healthz, /readyz and /metrics are; none: nowhere.
    std::filesystem::path data;    ///< Created where it is missing.
    KeepLimits keep;
    NetLimits net;
    LobbyLimits lobby;
};

/// Four threads of its own: network, game, store, archive. Used by the program, by local play and
/// by tests.
class Server {
  public:
    /// Returns when clients can connect. Throws std::runtime_error with a sentence for people where
    /// an address or the data folder cannot be used. The logger must be safe for several threads
    /// and outlive the server.
    Server(const ServerConfig& config, spdlog::logger& log);
    /// Stops.
    ~Server();
    Server(const Server&) = delete;
    Server& operator=(const Server&) = delete;

    /// Of the first address.
    std::uint16_t port() const;
    /// 0 where there is none.
    std::uint16_t http_port() const;

    /// Tells everyone, makes durable what is on its way, closes; within a few seconds, if the
    /// disk answers. Again: no effect.
    void stop();

  private:
    struct Parts;
    std::unique_ptr<Parts> parts_;
};

}  // namespace billiards::server
