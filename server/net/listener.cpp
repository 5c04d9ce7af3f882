// Takes an address to listen on; gives the sockets that connect to it.
#include "server/net/listener.h"

#include <asio/ip/v6_only.hpp>
#include <fmt/format.h>
#include <stdexcept>
#include <system_error>
#include <utility>

namespace billiards::server {

Listener::Listener(asio::io_context& context, const Endpoint& endpoint, spdlog::logger& log,
                   std::chrono::milliseconds pause_when_out_of_sockets)
    : acceptor_(context), pause_(context), pause_length_(pause_when_out_of_sockets), log_(log) {
    try {
        acceptor_.open(endpoint.protocol());
        acceptor_.set_option(asio::socket_base::reuse_address(true));
        if (endpoint.address().is_v6()) acceptor_.set_option(asio::ip::v6_only(true));
        acceptor_.bind(endpoint);
        acceptor_.listen();
        endpoint_ = acceptor_.local_endpoint();
    } catch (const std::system_error& error) {
        throw std::runtime_error(
            fmt::format("cannot listen on {}: {}", to_text(endpoint), error.code().message()));
    }
}

void Listener::start(Accepted accepted, Failed failed) {
    accepted_ = std::move(accepted);
    failed_ = std::move(failed);
    accept();
}

void Listener::stop() {
    asio::error_code ignored;
    acceptor_.close(ignored);
    pause_.cancel();
}

void Listener::accept() {
    acceptor_.async_accept([this](const asio::error_code& error, Socket socket) {
        if (!acceptor_.is_open()) return;
        if (error) return on_error(error);
        accepted_(std::move(socket));
        accept();
    });
}

void Listener::on_error(const asio::error_code& error) {
    if (error == asio::error::connection_aborted) return accept();  // Gone while it waited.
    failed_();
    log_.warn("cannot accept on {}: {}; trying again in {} ms", to_text(endpoint_), error.message(),
              pause_length_.count());
    pause_.expires_after(pause_length_);
    pause_.async_wait([this](const asio::error_code& cancelled) {
        if (!cancelled && acceptor_.is_open()) accept();
    });
}

}  // namespace billiards::server
