// Takes what the network and the store have to say; runs the lobby with it on the game's thread,
// and wakes it when its time has come.
#include "server/game_loop.h"

#include <asio/post.hpp>
#include <utility>

namespace billiards::server {

void GameLoop::attach(Lobby& lobby, BatchedOutbox& outbox) {
    lobby_ = &lobby;
    outbox_ = &outbox;
}

base::Instant GameLoop::now() const {
    return base::Instant(std::chrono::floor<base::Duration>(Clock::now() - start_));
}

void GameLoop::run(std::function<void(Lobby&, base::Instant)> call) {
    asio::post(context_, [this, call = std::move(call)] {
        call(*lobby_, now());
        settle();
    });
}

void GameLoop::connected(SessionId session, AddressKey from) {
    run([session, from](Lobby& lobby, base::Instant time) {
        lobby.connected(time, session, from);
    });
}

void GameLoop::received(SessionId session, protocol::ClientMessage message) {
    run([this, session, said = std::move(message)](Lobby& lobby, base::Instant time) {
        lobby.received(time, session, said);
        outbox_->handled(session);
    });
}

void GameLoop::malformed(SessionId session, std::string detail) {
    run([this, session, why = std::move(detail)](Lobby& lobby, base::Instant time) {
        lobby.malformed(time, session, why);
        outbox_->handled(session);
    });
}

void GameLoop::fell_behind(SessionId session) {
    run([session](Lobby& lobby, base::Instant time) { lobby.fell_behind(time, session); });
}

void GameLoop::disconnected(SessionId session) {
    run([session](Lobby& lobby, base::Instant time) { lobby.disconnected(time, session); });
}

/// After everything that may have moved the lobby.
void GameLoop::settle() {
    outbox_->flush();
    const auto next = lobby_->next_deadline();
    if (next == wakes_at_) return;
    wakes_at_ = next;
    if (next) {
        wake_at(*next);
    } else {
        timer_.cancel();
    }
}

void GameLoop::wake_at(base::Instant when) {
    timer_.expires_at(start_ + when.time_since_epoch());
    timer_.async_wait([this](const asio::error_code& cancelled) {
        if (cancelled) return;
        wakes_at_.reset();
        lobby_->advance_time(now());
        settle();
    });
}

}  // namespace billiards::server
