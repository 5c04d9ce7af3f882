// Makes nonsense of several kinds from a seed, and sends it over plain sockets.
#include "tools/load/nonsense.h"

#include "common/protocol/codec.h"
#include "common/protocol/framing.h"

#include <algorithm>
#include <array>
#include <asio/awaitable.hpp>
#include <asio/buffer.hpp>
#include <asio/co_spawn.hpp>
#include <asio/connect.hpp>
#include <asio/detached.hpp>
#include <asio/ip/tcp.hpp>
#include <asio/redirect_error.hpp>
#include <asio/steady_timer.hpp>
#include <asio/use_awaitable.hpp>
#include <asio/write.hpp>
#include <chrono>
#include <memory>
#include <string>

namespace billiards::tools {

namespace {

using asio::ip::tcp;
using Bytes = std::vector<std::byte>;

constexpr std::uint64_t kMostNoiseBytes = 4096;
constexpr std::uint64_t kMostFlippedBits = 8;
constexpr std::uint64_t kMostPatience_ms = 500;

enum class Kind : std::uint8_t {
    Silence,
    Noise,
    NoiseAfterPreamble,
    LyingLength,
    CutShort,
    FlippedBits,
    NotTheTime,
    Count
};

void append(Bytes& bytes, std::span<const std::byte> more) {
    bytes.insert(bytes.end(), more.begin(), more.end());
}

void append_noise(Bytes& bytes, base::Random& random, std::uint64_t length) {
    for (std::uint64_t i = 0; i < length; ++i) {
        bytes.push_back(static_cast<std::byte>(random.below(256)));
    }
}

Bytes preamble() {
    const protocol::PreambleBytes ours = protocol::encode_preamble({});
    return {ours.begin(), ours.end()};
}

Bytes greeting() {
    return *protocol::encode(protocol::ClientMessage{
        .request_id = 1, .body = protocol::client::Hello{.name = "Nobody", .token = {}}});
}

Bytes lying_length(base::Random& random) {
    static constexpr std::array<std::uint32_t, 6> kLengths{
        0, 1, 7, 1U << 20U, 0x7fff'fff8U, 0xffff'ffffU};
    const std::uint32_t length = kLengths.at(random.below(kLengths.size()));
    Bytes bytes;
    for (unsigned shift = 0; shift < 32; shift += 8) {
        bytes.push_back(static_cast<std::byte>(length >> shift & 0xffU));
    }
    append_noise(bytes, random, random.below(64));
    return bytes;
}

Bytes flipped(Bytes bytes, base::Random& random) {
    const std::uint64_t flips = 1 + random.below(kMostFlippedBits);
    for (std::uint64_t i = 0; i < flips; ++i) {
        bytes[random.below(bytes.size())] ^= static_cast<std::byte>(1U << random.below(8));
    }
    return bytes;
}

/// Well formed, and said before anybody greeted.
Bytes not_the_time() {
    return *protocol::encode(
        protocol::ClientMessage{.request_id = 1, .body = protocol::client::Concede{}});
}

asio::awaitable<void> send_once(tcp::endpoint endpoint, Bytes bytes,
                                std::chrono::milliseconds patience) {
    const auto executor = co_await asio::this_coro::executor;
    tcp::socket socket(executor);
    asio::error_code error;
    co_await socket.async_connect(endpoint, asio::redirect_error(asio::use_awaitable, error));
    if (!error && !bytes.empty()) {
        co_await asio::async_write(socket, asio::buffer(bytes),
                                   asio::redirect_error(asio::use_awaitable, error));
    }
    asio::steady_timer timer(executor, patience);
    co_await timer.async_wait(asio::redirect_error(asio::use_awaitable, error));
}

asio::awaitable<void> send_for_ever(client::ServerAddress address, std::uint64_t seed,
                                    Recorder& recorder) {
    base::Random random(seed);
    tcp::resolver resolver(co_await asio::this_coro::executor);
    asio::error_code error;
    const auto endpoints =
        co_await resolver.async_resolve(address.host, std::to_string(address.port),
                                        asio::redirect_error(asio::use_awaitable, error));
    if (error) co_return recorder.error("unknown host: " + address.host);
    const tcp::endpoint endpoint = endpoints.begin()->endpoint();
    while (true) {
        const std::chrono::milliseconds patience(random.below(kMostPatience_ms));
        co_await send_once(endpoint, nonsense(random), patience);
        recorder.nonsense_sent();
    }
}

}  // namespace

std::vector<std::byte> nonsense(base::Random& random) {
    const auto kind = static_cast<Kind>(random.below(static_cast<std::uint64_t>(Kind::Count)));
    Bytes bytes = kind == Kind::Silence || kind == Kind::Noise ? Bytes{} : preamble();
    switch (kind) {
        case Kind::Noise:
        case Kind::NoiseAfterPreamble:
            append_noise(bytes, random, 1 + random.below(kMostNoiseBytes));
            break;
        case Kind::LyingLength:
            append(bytes, lying_length(random));
            break;
        case Kind::CutShort: {
            const Bytes whole = greeting();
            append(bytes, std::span(whole).first(random.below(whole.size())));
            break;
        }
        case Kind::FlippedBits:
            append(bytes, flipped(greeting(), random));
            break;
        case Kind::NotTheTime:
            append(bytes, not_the_time());
            break;
        case Kind::Silence:
        case Kind::Count:
            break;
    }
    return bytes;
}

void send_nonsense_for_ever(asio::io_context& io, const client::ServerAddress& address,
                            std::uint64_t seed, Recorder& recorder) {
    asio::co_spawn(io, send_for_ever(address, seed, recorder), asio::detached);
}

}  // namespace billiards::tools
