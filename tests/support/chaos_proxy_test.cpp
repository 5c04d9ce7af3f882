// Shows that the proxy loses, adds and swaps no byte, and cuts connections where its seed says.
#include "tests/support/chaos_proxy.h"

#include "common/base/random.h"

#include <array>
#include <asio/buffer.hpp>
#include <asio/io_context.hpp>
#include <asio/read.hpp>
#include <asio/write.hpp>
#include <atomic>
#include <gtest/gtest.h>
#include <set>
#include <string>
#include <thread>
#include <vector>

namespace billiards::support {
namespace {

using asio::ip::tcp;

std::string noise(std::size_t size, std::uint64_t seed) {
    base::Random random(seed);
    std::string bytes(size, '\0');
    for (char& byte : bytes) byte = static_cast<char>(random.below(256));
    return bytes;
}

enum class Answer { Echo, Silence };

/// Reads from one connection after the other, and answers.
class Server {
  public:
    explicit Server(Answer answer) : answer_(answer), thread_([this] { serve(); }) {}
    ~Server() {
        // A last connection wakes the accept.
        is_stopping_ = true;
        asio::io_context context;
        tcp::socket socket(context);
        asio::error_code ignored;
        socket.connect(endpoint(), ignored);
        socket.close(ignored);
        thread_.join();
    }
    tcp::endpoint endpoint() const { return acceptor_.local_endpoint(); }

  private:
    void serve() {
        while (!is_stopping_) {
            tcp::socket socket = acceptor_.accept();
            std::array<char, 4096> buffer;
            asio::error_code error;
            while (!error) {
                const std::size_t size = socket.read_some(asio::buffer(buffer), error);
                if (!error && answer_ == Answer::Echo) {
                    asio::write(socket, asio::buffer(buffer, size), error);
                }
            }
        }
    }

    Answer answer_;
    asio::io_context context_;
    tcp::acceptor acceptor_{context_, {asio::ip::address_v4::loopback(), 0}};
    std::atomic<bool> is_stopping_{false};
    std::thread thread_;
};

struct Echo {
    std::string received;
    asio::error_code error;
};

/// What comes back when `sent` goes through `port` and is echoed.
Echo echo_through(std::uint16_t port, const std::string& sent) {
    asio::io_context context;
    tcp::socket socket(context);
    socket.connect({asio::ip::address_v4::loopback(), port});
    std::thread writer([&] {
        asio::error_code ignored;
        asio::write(socket, asio::buffer(sent), ignored);
    });
    Echo echo;
    echo.received.resize(sent.size());
    echo.received.resize(asio::read(socket, asio::buffer(echo.received), echo.error));
    writer.join();
    return echo;
}

constexpr ChaosSettings kRoughButWhole{.delay = std::chrono::microseconds(100),
                                       .jitter = std::chrono::microseconds(300),
                                       .split_probability = 0.3,
                                       .stall_probability = 0.2,
                                       .stall = std::chrono::milliseconds(1)};

TEST(ChaosProxy, PassesEveryByteOnInOrderWhenNothingIsReset) {
    const Server server(Answer::Echo);
    for (const ChaosSettings& settings : {ChaosSettings{}, kRoughButWhole}) {
        ChaosProxy proxy(server.endpoint(), settings, 7);
        const std::string sent = noise(50'000, 11);
        const Echo echo = echo_through(proxy.port(), sent);
        EXPECT_FALSE(echo.error) << echo.error.message();
        EXPECT_EQ(echo.received, sent);
        proxy.stop();
        EXPECT_EQ(proxy.counts().bytes, 2 * sent.size());
    }
}

TEST(ChaosProxy, DoesWhatItsSettingsSay) {
    const Server server(Answer::Echo);
    ChaosProxy proxy(server.endpoint(), kRoughButWhole, 7);
    echo_through(proxy.port(), noise(50'000, 11));
    const ChaosCounts counts = proxy.counts();
    EXPECT_EQ(counts.connections, 1U);
    EXPECT_GT(counts.splits, 10U);
    EXPECT_GT(counts.stalls, 10U);
    EXPECT_EQ(counts.resets, 0U);
}

/// How many bytes of a stream get through before it is reset, connection by connection.
std::vector<std::uint64_t> lengths_until_reset(std::uint64_t seed) {
    // Its silence leaves one direction alone: two would race for the reset.
    const Server server(Answer::Silence);
    ChaosProxy proxy(server.endpoint(), {.reset_probability = 0.05}, seed);
    std::vector<std::uint64_t> lengths;
    for (int i = 0; i < 4; ++i) {
        const std::uint64_t before = proxy.counts().bytes;
        EXPECT_TRUE(echo_through(proxy.port(), noise(100'000, 3)).error);
        lengths.push_back(proxy.counts().bytes - before);
    }
    EXPECT_EQ(proxy.counts().resets, lengths.size());
    return lengths;
}

TEST(ChaosProxy, ResetsWhereItsSeedSays) {
    const std::vector<std::uint64_t> lengths = lengths_until_reset(5);
    EXPECT_EQ(lengths_until_reset(5), lengths);
    EXPECT_NE(lengths_until_reset(6), lengths);
    EXPECT_GT(std::set(lengths.begin(), lengths.end()).size(), 1U) << "connections differ";
}

TEST(ChaosProxy, ResetsAllConnectionsWhenAskedAndTakesNewOnes) {
    const Server server(Answer::Silence);
    ChaosProxy proxy(server.endpoint(), {}, 1);
    asio::io_context context;
    tcp::socket open(context);
    open.connect({asio::ip::address_v4::loopback(), proxy.port()});
    asio::write(open, asio::buffer("x", 1));
    while (proxy.counts().bytes == 0) std::this_thread::yield();
    proxy.reset_all();
    asio::error_code error;
    std::array<char, 1> byte;
    open.read_some(asio::buffer(byte), error);
    EXPECT_EQ(error, asio::error::connection_reset);
    tcp::socket next(context);
    next.connect({asio::ip::address_v4::loopback(), proxy.port()}, error);
    EXPECT_FALSE(error);
}

TEST(ChaosProxy, StopsBeingReachableAndEndsItsThread) {
    const Server server(Answer::Echo);
    ChaosProxy proxy(server.endpoint(), kRoughButWhole, 7);
    asio::io_context context;
    tcp::socket open(context);
    open.connect({asio::ip::address_v4::loopback(), proxy.port()});
    proxy.stop();
    proxy.stop();
    asio::error_code error;
    std::array<char, 1> byte;
    open.read_some(asio::buffer(byte), error);
    EXPECT_TRUE(error);
    tcp::socket late(context);
    late.connect({asio::ip::address_v4::loopback(), proxy.port()}, error);
    EXPECT_TRUE(error);
}

}  // namespace
}  // namespace billiards::support
