// Gives tests of the tools a whole server in this process, on a free port, with a folder of its
// own.
#pragma once

#include "client/net/address.h"
#include "server/server.h"
#include "tests/support/temporary_folder.h"

#include <memory>
#include <optional>
#include <spdlog/logger.h>
#include <spdlog/sinks/null_sink.h>

namespace billiards::tools {

class TestServer {
  public:
    explicit TestServer(const server::NetLimits& limits = {}, const server::LobbyLimits& lobby = {})
        : limits_(limits), lobby_(lobby) {
        start();
    }

    /// Where clients connect, over restarts too.
    client::ServerAddress address() const { return {.host = "127.0.0.1", .port = port_}; }
    client::ServerAddress http_address() const {
        return {.host = "127.0.0.1", .port = server_->http_port()};
    }
    void restart() {
        server_.reset();
        start();
    }

  private:
    void start() {
        server::ServerConfig config;
        config.listen = {{asio::ip::address_v4::loopback(), port_}};
        config.http = server::Endpoint{asio::ip::address_v4::loopback(), 0};
        config.data = folder_.path() / "data";
        config.net = limits_;
        config.lobby = lobby_;
        server_.emplace(config, log_);
        port_ = server_->port();
    }

    const server::NetLimits limits_;
    const server::LobbyLimits lobby_;
    support::TemporaryFolder folder_;
    spdlog::logger log_{"test", std::make_shared<spdlog::sinks::null_sink_mt>()};
    std::optional<server::Server> server_;
    std::uint16_t port_ = 0;
};

}  // namespace billiards::tools
