// Takes connections on 127.0.0.1 and passes their bytes on to a server, badly: late, in single
// bytes, with pauses, or cut off. What goes wrong depends on a seed and on the bytes' places in
// their stream, not on how the system happens to deliver them.
#pragma once

#include <asio/ip/tcp.hpp>
#include <chrono>
#include <cstdint>
#include <memory>
#include <optional>
#include <string_view>

namespace billiards::support {

/// What may happen. Probabilities are for each piece of a stream, of 1 to 1,024 bytes.
struct ChaosSettings {
    std::chrono::microseconds delay{0};   ///< Before what was just read is passed on.
    std::chrono::microseconds jitter{0};  ///< Up to this much more, drawn each time.
    double split_probability = 0.0;       ///< The piece is written byte by byte.
    double stall_probability = 0.0;       ///< Its direction pauses before the piece.
    std::chrono::microseconds stall{0};   ///< For so long.
    double reset_probability = 0.0;       ///< Both sides are reset before the piece is passed on.

    friend bool operator==(const ChaosSettings&, const ChaosSettings&) = default;
};

/// "none", "mild" or "worst"; none of these gives nothing.
std::optional<ChaosSettings> chaos_preset(std::string_view name);

/// So far, over all connections and both directions.
struct ChaosCounts {
    std::uint64_t connections = 0;
    std::uint64_t bytes = 0;  ///< Passed on.
    std::uint64_t splits = 0;
    std::uint64_t stalls = 0;
    std::uint64_t resets = 0;

    friend bool operator==(const ChaosCounts&, const ChaosCounts&) = default;
};

/// Runs on a thread of its own from its making until stop(). Its functions may be called from any
/// thread.
class ChaosProxy {
  public:
    using Endpoint = asio::ip::tcp::endpoint;

    /// The n-th connection behaves by `seed` and n. Throws std::system_error where it cannot
    /// listen; port 0 takes a free one.
    ChaosProxy(const Endpoint& target, const ChaosSettings& settings, std::uint64_t seed,
               std::uint16_t listen_port = 0);
    ~ChaosProxy();
    ChaosProxy(const ChaosProxy&) = delete;
    ChaosProxy& operator=(const ChaosProxy&) = delete;

    std::uint16_t port() const;
    ChaosCounts counts() const;
    /// Resets every connection there is; new ones are welcome.
    void reset_all();
    /// Resets every connection, lets none in, and ends the thread. A second call does nothing.
    void stop();

  private:
    class Worker;
    std::unique_ptr<Worker> worker_;
};

}  // namespace billiards::support
