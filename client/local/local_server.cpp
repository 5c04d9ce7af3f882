// Takes a folder and a port; runs the server library in this process.
#include "client/local/local_server.h"

#include "server/ops/log.h"
#include "server/server.h"

#include <spdlog/logger.h>

namespace billiards::client {

namespace {

server::ServerConfig config_of(const LocalServerOptions& options) {
    using asio::ip::address_v4;
    using asio::ip::address_v6;
    server::ServerConfig config;
    config.data = options.data;
    if (options.is_for_others) {
        config.listen = {{address_v4::any(), options.port}};
        // A second port for IPv6 would not be the one that the host tells others.
        if (options.port != 0) config.listen.push_back({address_v6::any(), options.port});
    } else {
        config.listen = {{address_v4::loopback(), options.port}};
    }
    return config;
}

/// A player's terminal is no server's journal.
std::shared_ptr<spdlog::logger> quiet_logger() {
    auto log = server::make_logger(server::LogFormat::Text);
    log->set_level(spdlog::level::warn);
    return log;
}

}  // namespace

struct LocalServer::Running {
    explicit Running(const LocalServerOptions& options) : server(config_of(options), *log) {}

    std::shared_ptr<spdlog::logger> log = quiet_logger();
    server::Server server;
};

LocalServer::LocalServer(const LocalServerOptions& options)
    : running_(std::make_unique<Running>(options)) {}

LocalServer::~LocalServer() = default;

ServerAddress LocalServer::address() const {
    return {.host = "127.0.0.1", .port = running_->server.port()};
}

}  // namespace billiards::client
