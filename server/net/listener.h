// Takes an address to listen on; gives the sockets that connect to it.
#pragma once

#include "server/net/address.h"

#include <asio/basic_socket_acceptor.hpp>
#include <asio/basic_stream_socket.hpp>
#include <asio/io_context.hpp>
#include <asio/steady_timer.hpp>
#include <chrono>
#include <functional>
#include <spdlog/logger.h>

namespace billiards::server {

/// Bound to the io_context by type: an executor of any kind would cost each socket 40 bytes more.
using Socket = asio::basic_stream_socket<asio::ip::tcp, asio::io_context::executor_type>;

/// Lives on the thread that runs the io_context, from its first accept on.
class Listener {
  public:
    using Accepted = std::function<void(Socket)>;
    using Failed = std::function<void()>;

    /// Listens at once; port 0 takes a free one. An IPv6 address means IPv6 alone. Throws
    /// std::runtime_error with a sentence that names the address and the system's reason.
    Listener(asio::io_context& context, const Endpoint& endpoint, spdlog::logger& log,
             std::chrono::milliseconds pause_when_out_of_sockets);

    /// With the port that was taken.
    Endpoint endpoint() const { return endpoint_; }
    /// Hands over every socket from now on. Where the system has no more of them, it is told,
    /// logged and tried again after the pause, while the waiting clients keep waiting.
    void start(
        Accepted accepted, Failed failed = [] {});
    void stop();

  private:
    void accept();
    void on_error(const asio::error_code& error);

    asio::basic_socket_acceptor<asio::ip::tcp, asio::io_context::executor_type> acceptor_;
    asio::steady_timer pause_;
    const std::chrono::milliseconds pause_length_;
    spdlog::logger& log_;
    Endpoint endpoint_;
    Accepted accepted_;
    Failed failed_;
};

}  // namespace billiards::server
