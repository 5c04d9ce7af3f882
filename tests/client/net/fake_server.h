// Gives tests of the client's network a server that does exactly what a script says.
#pragma once

#include "client/net/address.h"
#include "common/protocol/codec.h"
#include "common/protocol/framing.h"
#include "common/protocol/messages.h"

#include <array>
#include <asio/buffer.hpp>
#include <asio/io_context.hpp>
#include <asio/ip/tcp.hpp>
#include <asio/read.hpp>
#include <asio/write.hpp>
#include <chrono>
#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <stdexcept>
#include <string_view>
#include <thread>
#include <utility>
#include <vector>

namespace billiards::client {

/// The server's side of one connection. What does not happen within kPatience fails the script.
class Peer {
  public:
    static constexpr std::chrono::seconds kPatience{5};

    Peer(asio::io_context& io, asio::ip::tcp::socket socket)
        : io_(io), socket_(std::move(socket)) {}

    void write(std::span<const std::byte> bytes) {
        asio::write(socket_, asio::buffer(bytes.data(), bytes.size()));
    }
    void write(std::string_view text) { write(std::as_bytes(std::span(text))); }
    void write(const protocol::ServerMessage& message) { write(*protocol::encode(message)); }
    void write_preamble(std::uint16_t major = protocol::kVersionMajor) {
        write(protocol::encode_preamble({.major = major}));
    }

    /// The next message; none where the client has closed.
    std::optional<protocol::ClientMessage> read() {
        std::array<std::byte, protocol::kFrameHeaderBytes> header{};
        if (!read_exactly(header)) return std::nullopt;
        const auto length = protocol::decode_frame_header(header, protocol::kMaxClientFrameBytes);
        std::vector<std::byte> frame(*length);
        if (!read_exactly(frame)) return std::nullopt;
        return protocol::decode_client(frame).value();
    }
    /// The next message of this kind; others before it are dropped.
    template <class Message>
    Message read_a() {
        while (true) {
            const std::optional<protocol::ClientMessage> message = read();
            if (!message) throw std::runtime_error("the client closed");
            if (const auto* body = std::get_if<Message>(&message->body)) return *body;
        }
    }
    void exchange_preambles() {
        write_preamble();
        protocol::PreambleBytes theirs{};
        if (!read_exactly(theirs) || !protocol::decode_preamble(theirs)) {
            throw std::runtime_error("the client sent no preamble");
        }
    }

    /// Waits for the client to close, and takes what it still says.
    void wait_until_closed() {
        std::array<std::byte, 4096> dropped{};
        while (read_exactly(std::span(dropped).first(1))) {
        }
    }

  private:
    bool read_exactly(std::span<std::byte> bytes) {
        std::optional<asio::error_code> result;
        asio::async_read(socket_, asio::buffer(bytes.data(), bytes.size()),
                         [&result](const asio::error_code& error, std::size_t) { result = error; });
        io_.restart();
        io_.run_for(kPatience);
        if (!result) throw std::runtime_error("the client says nothing");
        return !*result;
    }

    asio::io_context& io_;
    asio::ip::tcp::socket socket_;
};

/// Runs the script on a thread of its own; the script's exceptions come out of finish().
class FakeServer {
  public:
    using Script = std::function<void(FakeServer&)>;

    explicit FakeServer(Script script)
        : thread_([this, script = std::move(script)] {
              try {
                  script(*this);
              } catch (...) {
                  failure_ = std::current_exception();
              }
          }) {}
    ~FakeServer() {
        if (thread_.joinable()) thread_.join();
    }

    ServerAddress address() const {
        return {.host = "127.0.0.1", .port = acceptor_.local_endpoint().port()};
    }
    Peer accept() {
        std::optional<asio::ip::tcp::socket> accepted;
        acceptor_.async_accept([&accepted](const asio::error_code& error, auto socket) {
            if (!error) accepted = std::move(socket);
        });
        io_.restart();
        io_.run_for(Peer::kPatience);
        if (!accepted) throw std::runtime_error("nobody connected");
        return {io_, std::move(*accepted)};
    }
    void finish() {
        thread_.join();
        if (failure_) std::rethrow_exception(failure_);
    }

  private:
    asio::io_context io_;
    asio::ip::tcp::acceptor acceptor_{io_, {asio::ip::address_v4::loopback(), 0}};
    std::exception_ptr failure_;
    std::thread thread_;  // Last: it uses all of the above.
};

}  // namespace billiards::client
