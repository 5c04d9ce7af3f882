// Takes a server's address and a name; gives a test one client to speak through, over a real
// connection, and everything that it heard.
#pragma once

#include "client/app/client_state.h"
#include "client/net/server_link.h"

#include <functional>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace billiards::e2e {

class Guest {
  public:
    Guest(client::ServerAddress address, std::string name);

    void say(protocol::ClientMessageBody body) { link_->send(std::move(body)); }
    /// Listens until the condition holds. Throws std::runtime_error where it does not within a
    /// minute: `what` says what was waited for.
    void wait_until(const std::string& what,
                    const std::function<bool(const client::ClientState&)>& condition);
    /// Listens until a message of this kind has come that this function has not given before.
    template <class Message>
    Message hear(const std::string& what);
    template <class Message>
    std::size_t count() const;

    /// When it played or heard of each shot, by the shot's number; on the local clock.
    base::Instant heard_shot_at(int number) const;

    /// As one who closes the lid; and with the token of before, when it is opened again.
    void vanish();
    void come_back();

    const client::ClientState& state() const { return state_; }

  private:
    void take(const client::LinkEvent& event);

    client::ServerLinkOptions options_;
    client::ClientState state_;
    std::vector<client::Arrived> heard_;
    std::size_t given_ = 0;  ///< Of heard_: what hear() has passed.
    std::optional<client::ServerLink> link_;
};

template <class Message>
Message Guest::hear(const std::string& what) {
    std::optional<Message> found;
    wait_until(what, [&](const client::ClientState&) {
        while (given_ < heard_.size() && !found) {
            const auto* message = std::get_if<Message>(&heard_[given_++].message);
            if (message != nullptr) found = *message;
        }
        return found.has_value();
    });
    return *found;
}

template <class Message>
std::size_t Guest::count() const {
    std::size_t count = 0;
    for (const client::Arrived& arrived : heard_) {
        if (std::holds_alternative<Message>(arrived.message)) ++count;
    }
    return count;
}

}  // namespace billiards::e2e
