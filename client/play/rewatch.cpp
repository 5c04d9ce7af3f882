// Takes steps and time; plays each step once the one before has come to rest.
#include "client/play/rewatch.h"

#include <variant>

namespace billiards::client {

namespace {

/// A shot that was struck then is struck now: the offset that makes it so.
base::Duration offset_for(const protocol::ServerMessage& message, base::Instant now) {
    const auto* shot = std::get_if<protocol::server::ShotPlayed>(&message);
    const base::Duration struck(shot != nullptr ? shot->struck_us : 0);
    return struck - now.time_since_epoch();
}

}  // namespace

bool Rewatch::take(const protocol::server::ReplayChunk& chunk) {
    if (!rewind_.take(chunk).ok()) return false;
    if (!is_shown_ && rewind_.steps() > 0) stand_at(0);
    return true;
}

void Rewatch::advance(base::Instant now) {
    if (!is_shown_) return;
    presentation_.advance(now);
    if (presentation_.rolling() != nullptr || is_paused_ || step_ + 1 >= rewind_.steps()) {
        rested_at_.reset();
        return;
    }
    if (!rested_at_) rested_at_ = now;
    if (now - *rested_at_ >= kBetweenSteps) play(step_ + 1, now);
}

void Rewatch::next_shot(base::Instant now) {
    if (!is_shown_) return;
    presentation_.skip();
    const std::size_t next = rewind_.next_shot(step_);
    if (next <= step_) return;
    stand_at(next - 1);
    play(next, now);
}

void Rewatch::previous_shot(base::Instant now) {
    if (!is_shown_) return;
    const std::size_t previous = rewind_.previous_shot(step_);
    stand_at(previous > 0 ? previous - 1 : 0);
    if (previous > 0) play(previous, now);
}

void Rewatch::stand_at(std::size_t step) {
    step_ = step;
    rested_at_.reset();
    const ClientState state = rewind_.at(step);
    if (!state.table) return;
    is_shown_ = true;
    TableView table = *state.table;
    table.last_shot.reset();  // It rests.
    presentation_.enter(table, base::Duration::zero());
}

void Rewatch::play(std::size_t step, base::Instant now) {
    const std::optional<TableView> before = rewind_.at(step - 1).table;
    const std::optional<TableView> after = rewind_.at(step).table;
    step_ = step;
    rested_at_.reset();
    if (!before || !after) return;
    const protocol::ServerMessage message = rewind_.message(step);
    presentation_.received(*before, *after, message, offset_for(message, now));
}

}  // namespace billiards::client
