// Takes what a person asks for besides the shot; says it to the server.
#include "client/play/game.h"

#include <algorithm>
#include <utility>

namespace billiards::client {

namespace wire = protocol::client;

void Game::join(const wire::Join& join) {
    ask(join);
}

void Game::open_table(const wire::CreateTable& table) {
    ask(table);
}

void Game::ready() {
    ask(wire::Ready{});
    asked_to_start_ = true;
}

void Game::rematch() {
    ask(wire::Rematch{});
    asked_to_start_ = true;
}

bool Game::has_asked_to_start() const {
    if (asked_to_start_) return true;
    if (!state_.table || state_.table->row.playing) return false;
    const std::vector<model::Seat>& mine = state_.table->my_seats;
    const auto is_ready = [&](model::Seat seat) { return state_.table->row.seats[seat].ready; };
    return !mine.empty() && std::ranges::all_of(mine, is_ready);
}

void Game::leave_table() {
    refusal_.clear();
    if (state_.table) leaving_ = send(wire::Leave{});
}

void Game::change_table(const wire::ChangeTable& change) {
    ask(change);
}

void Game::make_invite(protocol::Role role) {
    state_.last_invite.reset();
    ask(wire::MakeInvite{role});
}

void Game::revoke_invites() {
    state_.last_invite.reset();
    ask(wire::RevokeInvites{});
}

void Game::kick(const std::string& name) {
    ask(wire::Kick{name});
}

void Game::concede() {
    ask(wire::Concede{});
}

void Game::chat(const std::string& text) {
    ask(wire::Chat{.text = text});
}

void Game::mute(const std::string& name) {
    state_ = with_muted(std::move(state_), std::string(name));
}

void Game::unmute(const std::string& name) {
    state_ = with_unmuted(std::move(state_), std::string(name));
}

void Game::skip_roll() {
    if (is_rewatching()) {
        rewatch_->next_shot(now_);
    } else {
        presentation_.skip();
    }
}

void Game::watch_from_start() {
    if (!state_.table) return;
    refusal_.clear();
    rewatch_.emplace(state_, 0);
    ask_for_steps();
}

void Game::ask_for_steps() {
    const auto question = rewatch_ ? rewatch_->question() : std::nullopt;
    if (question) rewatch_asked_ = send(*question);
}

Offered Game::offered(base::Instant now) const {
    const TableView* shown = presentation_.table();
    if (shown == nullptr || !is_connected() || is_rewatching()) return {};
    return client::offered(state_, *shown, acting(), now);
}

void Game::extend() {
    if (acting()) ask(wire::Extend{*turn_});
}

void Game::offer(match::OfferKind kind) {
    if (state_.table && state_.table->match) ask(wire::Offer{state_.table->match->turn, kind});
}

void Game::answer_offer(bool accept) {
    if (state_.table && state_.table->match) ask(wire::Answer{state_.table->match->turn, accept});
}

void Game::claim_stalemate() {
    if (acting()) ask(wire::ClaimStalemate{*turn_});
}

void Game::spot_nearest() {
    if (acting()) ask(wire::SpotNearest{*turn_});
}

void Game::claim_match() {
    ask(wire::ClaimMatch{});
}

void Game::place_ball(model::BallId ball, base::Vec2 at_m) {
    if (acting()) ask(wire::PlaceBall{ball, at_m});
}

void Game::undo() {
    if (acting()) ask(wire::Undo{});
}

void Game::repeat() {
    if (acting()) ask(wire::Repeat{});
}

void Game::rerack() {
    if (acting()) ask(wire::Rerack{});
}

void Game::ask(protocol::ClientMessageBody body) {
    refusal_.clear();
    send(std::move(body));
}

void Game::go_to_lobby() {
    leaving_.reset();
    send(wire::FollowTables{});
}

}  // namespace billiards::client
