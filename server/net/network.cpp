// Takes addresses to listen on; gives sessions to the game, and carries out what it sends them.
#include "server/net/network.h"

#include "server/net/descriptors.h"

#include <array>
#include <utility>

namespace billiards::server {
namespace {

protocol::SharedFrame our_preamble() {
    const auto bytes = protocol::encode_preamble({});
    return std::make_shared<const std::vector<std::byte>>(bytes.begin(), bytes.end());
}

void carry_out_one(const Outgoing& outgoing, Connection& connection) {
    switch (outgoing.kind) {
        case Outgoing::Kind::Ordered:
            return connection.deliver(outgoing.frame, Delivery::Ordered);
        case Outgoing::Kind::LatestWins:
            return connection.deliver(outgoing.frame, Delivery::LatestWins);
        case Outgoing::Kind::Sheddable:
            return connection.deliver(outgoing.frame, Delivery::Sheddable);
        case Outgoing::Kind::Fresh:
            return connection.deliver(outgoing.frame, Delivery::Fresh);
        case Outgoing::Kind::Close:
            return connection.close();
        case Outgoing::Kind::Handled:
            return connection.handled();
    }
}

}  // namespace

Network::Network(asio::io_context& context, const NetLimits& limits, ConnectionEvents& events,
                 spdlog::logger& log)
    : context_(context),
      limits_(limits),
      max_connections_(
          connections_within(limits.connections, descriptors_allowed(), limits.descriptor_reserve)),
      log_(log),
      share_{limits_, events, stats_, our_preamble(), [this](SessionId gone) { ended(gone); }},
      addresses_(limits.address),
      tick_timer_(context) {}

Endpoint Network::listen(const Endpoint& endpoint) {
    listeners_.push_back(
        std::make_unique<Listener>(context_, endpoint, log_, limits_.pause_when_out_of_sockets));
    return listeners_.back()->endpoint();
}

void Network::start() {
    if (max_connections_ < limits_.connections) {
        log_.warn("at most {} connections instead of {}: the system gives too few descriptors",
                  max_connections_, limits_.connections);
    }
    for (const auto& listener : listeners_) {
        listener->start([this](Socket socket) { accepted(std::move(socket)); },
                        [this] { ++stats_.accept_failures; });
    }
    wait_for_tick();
}

void Network::accepted(Socket socket) {
    asio::error_code gone;
    const auto remote = socket.remote_endpoint(gone);
    if (gone) return;
    const auto address = AddressLimits::key_of(remote.address());
    const bool room = guests() < max_connections_;
    if (!room || !addresses_.admit(address, Connection::Clock::now())) {
        return turn_away(std::move(socket));
    }
    Connection& guest = add(std::move(socket), address, false);
    ++stats_.accepted;
    stats_.connections = guests();
    guest.start();
}

Connection& Network::add(Socket socket, AddressKey address, bool is_turned_away) {
    const SessionId session{++last_session_};
    auto connection = std::make_shared<Connection>(std::move(socket), session, address, share_);
    const Entry entry{std::move(connection), address, is_turned_away};
    return *connections_.emplace(session.value, entry).first->second.connection;
}

/// In words, but without waiting until they are sent: what does not fit into the socket's own
/// buffer is lost. What the guest has said already is read by a connection that closes, where
/// there is one left for that: unread, it would overtake the words with a reset.
void Network::turn_away(Socket socket) {
    ++stats_.turned_away;
    protocol::server::Refused refused;
    refused.code = protocol::RefusedCode::TooMany;
    refused.detail = "too many connections";
    const auto refusal = protocol::encode(protocol::ServerMessage(std::move(refused)));
    const std::array buffers{asio::buffer(*share_.preamble), asio::buffer(*refusal)};
    asio::error_code ignored;
    socket.non_blocking(true, ignored);
    socket.send(buffers, 0, ignored);
    if (turned_away_ >= limits_.turned_away_at_once) return;
    ++turned_away_;
    add(std::move(socket), {}, true).close();
}

void Network::ended(SessionId session) {
    const auto found = connections_.find(session.value);
    addresses_.release(found->second.address);
    if (found->second.is_turned_away) --turned_away_;
    connections_.erase(found);
    stats_.connections = guests();
    if (connections_.empty() && stopped_) std::exchange(stopped_, {})();
}

void Network::carry_out(const std::vector<Outgoing>& batch) {
    for (const Outgoing& outgoing : batch) {
        const auto found = connections_.find(outgoing.session.value);
        if (found == connections_.end()) continue;
        // It may end in this call, and be erased.
        const std::shared_ptr<Connection> connection = found->second.connection;
        carry_out_one(outgoing, *connection);
    }
}

void Network::wait_for_tick() {
    tick_timer_.expires_after(limits_.tick);
    tick_timer_.async_wait([this](const asio::error_code& cancelled) {
        if (cancelled) return;
        tick();
        wait_for_tick();
    });
}

void Network::tick() {
    const auto now = Connection::Clock::now();
    addresses_.forget_old(now);
    for (auto next = connections_.begin(); next != connections_.end();) {
        const std::shared_ptr<Connection> connection = (next++)->second.connection;
        connection->tick(now);  // May erase its own entry, and no other.
    }
}

void Network::stop(std::function<void()> stopped) {
    for (const auto& listener : listeners_) listener->stop();
    if (connections_.empty()) return stopped();
    stopped_ = std::move(stopped);
    for (auto next = connections_.begin(); next != connections_.end();) {
        const std::shared_ptr<Connection> connection = (next++)->second.connection;
        connection->close();
    }
}

}  // namespace billiards::server
