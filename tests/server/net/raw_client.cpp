// Gives a test a client that says any bytes it likes, and takes what comes back; no call waits
// longer than five seconds.
#include "tests/server/net/raw_client.h"

#include <algorithm>
#include <arpa/inet.h>
#include <array>
#include <cerrno>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <poll.h>
#include <sys/socket.h>
#include <system_error>
#include <unistd.h>

namespace billiards::server {
namespace {

constexpr std::chrono::seconds kLimit{5};

void throw_on_failure(int result) {
    if (result < 0) throw std::system_error(errno, std::generic_category());
}

void set_limit(int descriptor, int option) {
    const timeval limit{kLimit.count(), 0};
    throw_on_failure(::setsockopt(descriptor, SOL_SOCKET, option, &limit, sizeof limit));
}

}  // namespace

RawClient::RawClient(std::uint16_t port, std::optional<int> receive_buffer_bytes)
    : descriptor_(::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0)) {
    throw_on_failure(descriptor_);
    if (receive_buffer_bytes) {
        throw_on_failure(::setsockopt(descriptor_, SOL_SOCKET, SO_RCVBUF, &*receive_buffer_bytes,
                                      sizeof *receive_buffer_bytes));
    }
    const int no_delay = 1;
    throw_on_failure(
        ::setsockopt(descriptor_, IPPROTO_TCP, TCP_NODELAY, &no_delay, sizeof no_delay));
    set_limit(descriptor_, SO_SNDTIMEO);
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_port = htons(port);
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    const int connected =
        ::connect(descriptor_, reinterpret_cast<const sockaddr*>(&address), sizeof address);
    if (connected < 0) {
        const int error_number = errno;
        ::close(descriptor_);
        throw std::system_error(error_number, std::generic_category());
    }
}

RawClient::~RawClient() {
    ::close(descriptor_);
}

bool RawClient::send(std::span<const std::byte> bytes) {
    while (!bytes.empty()) {
        const auto sent = ::send(descriptor_, bytes.data(), bytes.size(), MSG_NOSIGNAL);
        if (sent <= 0) return false;
        bytes = bytes.subspan(static_cast<std::size_t>(sent));
    }
    return true;
}

RawClient::Bytes RawClient::receive(std::size_t count, std::chrono::milliseconds limit) {
    using Clock = std::chrono::steady_clock;
    const auto end = Clock::now() + limit;
    Bytes bytes(count);
    std::size_t received = 0;
    while (received < count) {
        const auto left = std::chrono::ceil<std::chrono::milliseconds>(end - Clock::now());
        pollfd waiting{descriptor_, POLLIN, 0};
        if (::poll(&waiting, 1, static_cast<int>(std::max<std::int64_t>(left.count(), 0))) <= 0) {
            break;
        }
        const auto got = ::recv(descriptor_, bytes.data() + received, count - received, 0);
        if (got <= 0) break;
        received += static_cast<std::size_t>(got);
    }
    bytes.resize(received);
    return bytes;
}

RawClient::Bytes RawClient::receive_all() {
    Bytes all;
    for (;;) {
        const Bytes some = receive(64 * 1024);
        all.insert(all.end(), some.begin(), some.end());
        if (some.size() < 64 * 1024) return all;
    }
}

std::optional<protocol::Preamble> RawClient::receive_preamble() {
    const Bytes bytes = receive(protocol::kPreambleBytes);
    if (bytes.size() != protocol::kPreambleBytes) return std::nullopt;
    const auto preamble =
        protocol::decode_preamble(std::span(bytes).first<protocol::kPreambleBytes>());
    return preamble ? std::optional(*preamble) : std::nullopt;
}

std::optional<protocol::ServerMessage> RawClient::receive_message() {
    const Bytes header = receive(protocol::kFrameHeaderBytes);
    if (header.size() != protocol::kFrameHeaderBytes) return std::nullopt;
    const auto length = protocol::decode_frame_header(
        std::span(header).first<protocol::kFrameHeaderBytes>(), protocol::kMaxServerFrameBytes);
    if (!length) return std::nullopt;
    const Bytes frame = receive(*length);
    if (frame.size() != *length) return std::nullopt;
    auto message = protocol::decode_server(frame);
    return message ? std::optional(std::move(message).value()) : std::nullopt;
}

bool RawClient::is_closed_by_other_side() {
    pollfd waiting{descriptor_, POLLIN, 0};
    if (::poll(&waiting, 1, static_cast<int>(std::chrono::milliseconds(kLimit).count())) != 1) {
        return false;
    }
    std::array<std::byte, 1> byte{};
    return ::recv(descriptor_, byte.data(), byte.size(), 0) <= 0;
}

}  // namespace billiards::server
