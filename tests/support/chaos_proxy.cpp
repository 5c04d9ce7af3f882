// Takes connections on 127.0.0.1 and passes their bytes on to a server, badly.
#include "tests/support/chaos_proxy.h"

#include "common/base/random.h"

#include <algorithm>
#include <array>
#include <asio/awaitable.hpp>
#include <asio/buffer.hpp>
#include <asio/co_spawn.hpp>
#include <asio/detached.hpp>
#include <asio/io_context.hpp>
#include <asio/post.hpp>
#include <asio/redirect_error.hpp>
#include <asio/steady_timer.hpp>
#include <asio/use_awaitable.hpp>
#include <asio/write.hpp>
#include <atomic>
#include <memory>
#include <set>
#include <span>
#include <thread>
#include <utility>

namespace billiards::support {

namespace {

using asio::ip::tcp;
using Nothing = asio::awaitable<void>;

constexpr std::size_t kMaxPieceBytes = 1024;
constexpr std::size_t kReadBytes = 16 * 1024;

/// As ChaosCounts, from several threads.
struct Counters {
    std::atomic<std::uint64_t> connections{0};
    std::atomic<std::uint64_t> bytes{0};
    std::atomic<std::uint64_t> splits{0};
    std::atomic<std::uint64_t> stalls{0};
    std::atomic<std::uint64_t> resets{0};
};

/// What becomes of the next so many bytes of a stream. The order of the draws never depends on
/// the settings, so that one setting can change without the others' luck.
struct Fate {
    std::size_t bytes_left = 0;
    bool is_split = false;
    bool is_stalled = false;
    bool is_reset = false;
};

Fate draw_fate(base::Random& random, const ChaosSettings& settings) {
    const auto is_drawn = [&](double probability) { return random.uniform(0, 1) < probability; };
    Fate fate;
    fate.bytes_left = 1 + random.below(kMaxPieceBytes);
    fate.is_split = is_drawn(settings.split_probability);
    fate.is_stalled = is_drawn(settings.stall_probability);
    fate.is_reset = is_drawn(settings.reset_probability);
    return fate;
}

/// Two sockets and what is going wrong between them. Lives on the worker's thread, held by the
/// coroutines that relay it.
class Pair {
  public:
    Pair(tcp::socket near, const ChaosSettings& settings, std::uint64_t seed, Counters& counters)
        : near_(std::move(near)),
          far_(near_.get_executor()),
          settings_(settings),
          counters_(counters),
          up_(near_, far_, seed),
          down_(far_, near_, ~seed) {}

    static Nothing run(std::shared_ptr<Pair> self, tcp::endpoint target) {
        asio::error_code error;
        co_await self->far_.async_connect(target, asio::redirect_error(asio::use_awaitable, error));
        if (error || self->is_over_) {
            self->reset();
            co_return;
        }
        self->far_.set_option(tcp::no_delay(true), error);
        self->near_.set_option(tcp::no_delay(true), error);
        asio::co_spawn(self->near_.get_executor(), relay(self, self->up_), asio::detached);
        co_await relay(self, self->down_);
    }

    /// Both sides at once, as a router does that has lost its table: not closed, reset.
    void reset() {
        is_over_ = true;
        up_.timer.cancel();
        down_.timer.cancel();
        for (tcp::socket* socket : {&near_, &far_}) {
            asio::error_code ignored;
            socket->set_option(asio::socket_base::linger(true, 0), ignored);
            socket->close(ignored);
        }
    }

  private:
    /// One direction.
    struct Stream {
        Stream(tcp::socket& source, tcp::socket& sink, std::uint64_t seed)
            : from(source), to(sink), random(seed), jitter(seed + 1), timer(from.get_executor()) {}

        tcp::socket& from;
        tcp::socket& to;
        base::Random random;  ///< Of fates alone: one draw of them a piece, whatever is read.
        base::Random jitter;
        asio::steady_timer timer;
        Fate fate;
        std::array<char, kReadBytes> buffer;
    };

    static Nothing relay(std::shared_ptr<Pair> self, Stream& stream) {
        asio::error_code error;
        while (!error && !self->is_over_) {
            const std::size_t size = co_await stream.from.async_read_some(
                asio::buffer(stream.buffer), asio::redirect_error(asio::use_awaitable, error));
            if (error) break;
            co_await self->pause(stream, self->settings_.delay + self->jitter(stream));
            co_await self->pass_on(stream, std::span<const char>(stream.buffer.data(), size));
        }
        self->end(stream, error);
    }

    /// The other direction goes on after an orderly end, as TCP has it.
    void end(Stream& stream, const asio::error_code& error) {
        if (is_over_) return;
        if (error != asio::error::eof) return reset();
        asio::error_code ignored;
        stream.to.shutdown(tcp::socket::shutdown_send, ignored);
    }

    Nothing pass_on(Stream& stream, std::span<const char> bytes) {
        while (!bytes.empty() && !is_over_) {
            if (stream.fate.bytes_left == 0) co_await begin_piece(stream);
            if (is_over_) co_return;
            const std::size_t size = std::min(bytes.size(), stream.fate.bytes_left);
            co_await write(stream, bytes.first(size));
            bytes = bytes.subspan(size);
            stream.fate.bytes_left -= size;
        }
    }

    Nothing begin_piece(Stream& stream) {
        stream.fate = draw_fate(stream.random, settings_);
        if (stream.fate.is_split) ++counters_.splits;
        if (stream.fate.is_stalled) {
            ++counters_.stalls;
            co_await pause(stream, settings_.stall);
        }
        if (stream.fate.is_reset && !is_over_) {
            ++counters_.resets;
            reset();
        }
    }

    Nothing write(Stream& stream, std::span<const char> bytes) {
        const std::size_t step = stream.fate.is_split ? 1 : bytes.size();
        for (std::size_t at = 0; at < bytes.size() && !is_over_; at += step) {
            asio::error_code error;
            counters_.bytes +=
                co_await asio::async_write(stream.to, asio::buffer(bytes.data() + at, step),
                                           asio::redirect_error(asio::use_awaitable, error));
            if (error) reset();
        }
    }

    std::chrono::microseconds jitter(Stream& stream) {
        const auto longest = static_cast<std::uint64_t>(settings_.jitter.count());
        return std::chrono::microseconds(stream.jitter.below(longest + 1));
    }

    Nothing pause(Stream& stream, std::chrono::microseconds length) {
        if (length.count() == 0 || is_over_) co_return;
        asio::error_code ignored;
        stream.timer.expires_after(length);
        co_await stream.timer.async_wait(asio::redirect_error(asio::use_awaitable, ignored));
    }

    tcp::socket near_;
    tcp::socket far_;
    ChaosSettings settings_;
    Counters& counters_;
    Stream up_;
    Stream down_;
    bool is_over_ = false;
};

}  // namespace

std::optional<ChaosSettings> chaos_preset(std::string_view name) {
    using std::chrono::milliseconds;
    if (name == "none") return ChaosSettings{};
    if (name == "mild") {
        return ChaosSettings{.delay = milliseconds(20),
                             .jitter = milliseconds(10),
                             .split_probability = 0.05,
                             .stall_probability = 0.01,
                             .stall = milliseconds(200)};
    }
    if (name == "worst") {
        return ChaosSettings{.delay = milliseconds(40),
                             .jitter = milliseconds(80),
                             .split_probability = 0.3,
                             .stall_probability = 0.03,
                             .stall = milliseconds(500),
                             .reset_probability = 0.01};
    }
    return std::nullopt;
}

/// All but port() and counts() is on its thread.
class ChaosProxy::Worker {
  public:
    Worker(const Endpoint& target, const ChaosSettings& settings, std::uint64_t seed,
           std::uint16_t listen_port)
        : target_(target),
          settings_(settings),
          seeds_(seed),
          acceptor_(context_, {asio::ip::address_v4::loopback(), listen_port}),
          port_(acceptor_.local_endpoint().port()) {
        asio::co_spawn(context_, accept(), asio::detached);
        thread_ = std::thread([this] { context_.run(); });
    }

    ~Worker() { stop(); }

    std::uint16_t port() const { return port_; }
    ChaosCounts counts() const {
        return {.connections = counters_.connections,
                .bytes = counters_.bytes,
                .splits = counters_.splits,
                .stalls = counters_.stalls,
                .resets = counters_.resets};
    }

    void post_reset() {
        asio::post(context_, [this] { reset(); });
    }

    void stop() {
        if (!thread_.joinable()) return;
        asio::post(context_, [this] {
            asio::error_code ignored;
            acceptor_.close(ignored);
            reset();
        });
        thread_.join();
    }

  private:
    Nothing accept() {
        while (acceptor_.is_open()) {
            asio::error_code error;
            tcp::socket near =
                co_await acceptor_.async_accept(asio::redirect_error(asio::use_awaitable, error));
            if (error || !acceptor_.is_open()) continue;  // Closed while this one was on its way.
            ++counters_.connections;
            const auto pair =
                std::make_shared<Pair>(std::move(near), settings_, seeds_.next(), counters_);
            std::erase_if(pairs_, [](const auto& old) { return old.expired(); });
            pairs_.insert(pair);
            asio::co_spawn(context_, Pair::run(pair, target_), asio::detached);
        }
    }

    void reset() {
        for (const auto& pair : pairs_) {
            if (const auto alive = pair.lock()) alive->reset();
        }
        pairs_.clear();
    }

    using Pairs = std::set<std::weak_ptr<Pair>, std::owner_less<std::weak_ptr<Pair>>>;

    Endpoint target_;
    ChaosSettings settings_;
    base::Random seeds_;
    Counters counters_;
    asio::io_context context_{1};
    tcp::acceptor acceptor_;
    std::uint16_t port_;
    Pairs pairs_;
    std::thread thread_;
};

ChaosProxy::ChaosProxy(const Endpoint& target, const ChaosSettings& settings, std::uint64_t seed,
                       std::uint16_t listen_port)
    : worker_(std::make_unique<Worker>(target, settings, seed, listen_port)) {}

ChaosProxy::~ChaosProxy() = default;

std::uint16_t ChaosProxy::port() const {
    return worker_->port();
}

ChaosCounts ChaosProxy::counts() const {
    return worker_->counts();
}

void ChaosProxy::reset_all() {
    worker_->post_reset();
}

void ChaosProxy::stop() {
    worker_->stop();
}

}  // namespace billiards::support
