// Takes events from a link; folds them into what a client knows.
#include "tests/e2e/guest.h"

#include "client/app/reduce.h"
#include "client/net/clock.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace billiards::e2e {
namespace {

constexpr std::chrono::seconds kPatience{60};
/// A condition may come true by the clock alone.
constexpr base::Duration kLook = std::chrono::milliseconds(20);

}  // namespace

Guest::Guest(client::ServerAddress address, std::string name) {
    options_.address = std::move(address);
    options_.name = std::move(name);
    link_.emplace(options_);
    wait_until("a welcome",
               [](const client::ClientState& state) { return state.token.has_value(); });
}

void Guest::take(const client::LinkEvent& event) {
    if (const auto* arrived = std::get_if<client::Arrived>(&event)) {
        heard_.push_back(*arrived);
        state_ = client::reduce(std::move(state_), arrived->message, arrived->at);
    } else {
        state_ = client::with_link_lost(std::move(state_));
    }
}

void Guest::wait_until(const std::string& what,
                       const std::function<bool(const client::ClientState&)>& condition) {
    const base::Instant deadline = client::local_now() + kPatience;
    while (!condition(state_)) {
        const base::Duration left = deadline - client::local_now();
        if (left <= base::Duration::zero()) {
            throw std::runtime_error(options_.name + " waited in vain for " + what);
        }
        if (const auto event = link_->wait_for(std::min(left, kLook))) take(*event);
    }
}

base::Instant Guest::heard_shot_at(int number) const {
    for (const client::Arrived& arrived : heard_) {
        const auto* shot = std::get_if<protocol::server::ShotPlayed>(&arrived.message);
        if (shot != nullptr && shot->after.shots_played == number) return arrived.at;
    }
    throw std::runtime_error(options_.name + " never heard of shot " + std::to_string(number));
}

void Guest::vanish() {
    link_.reset();
    state_ = client::with_link_lost(std::move(state_));
}

void Guest::come_back() {
    options_.token = state_.token;
    link_.emplace(options_);
    wait_until("its place", [](const client::ClientState& state) {
        return state.link == client::LinkState::Ready && state.table && !state.is_table_stale;
    });
}

}  // namespace billiards::e2e
