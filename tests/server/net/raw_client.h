// Gives a test a client that says any bytes it likes, and takes what comes back; no call waits
// longer than five seconds.
#pragma once

#include "common/protocol/codec.h"
#include "common/protocol/framing.h"

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace billiards::server {

class RawClient {
  public:
    using Bytes = std::vector<std::byte>;

    /// Connects to this machine; throws std::system_error where nobody listens. A small receive
    /// buffer makes a slow reader.
    explicit RawClient(std::uint16_t port, std::optional<int> receive_buffer_bytes = {});
    ~RawClient();
    RawClient(const RawClient&) = delete;
    RawClient& operator=(const RawClient&) = delete;

    /// False where the other side is gone.
    bool send(std::span<const std::byte> bytes);
    bool send(std::string_view bytes) { return send(std::as_bytes(std::span(bytes))); }
    bool send(const protocol::ClientMessage& message) { return send(*protocol::encode(message)); }
    bool send_preamble(const protocol::Preamble& preamble = {}) {
        return send(protocol::encode_preamble(preamble));
    }

    /// So many bytes; fewer where the other side closed or the time was over.
    Bytes receive(std::size_t count, std::chrono::milliseconds limit = std::chrono::seconds(5));
    /// Everything until the other side closes.
    Bytes receive_all();
    std::optional<protocol::Preamble> receive_preamble();
    /// None where no whole frame came, or it held no message.
    std::optional<protocol::ServerMessage> receive_message();
    /// The next message, where it is of this kind; messages of other kinds before it are dropped.
    template <class Message>
    std::optional<Message> receive_next() {
        while (auto message = receive_message()) {
            if (auto* wanted = std::get_if<Message>(&*message)) return std::move(*wanted);
        }
        return std::nullopt;
    }
    /// Whether the other side closes, without a further byte.
    bool is_closed_by_other_side();

  private:
    int descriptor_ = -1;
};

}  // namespace billiards::server
