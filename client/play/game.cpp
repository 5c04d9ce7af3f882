// Takes hands, messages and time; gives the state of the screen, and the next thing to say.
#include "client/play/game.h"

#include "client/app/announce.h"
#include "client/app/reduce.h"
#include "client/app/refusal.h"
#include "common/base/hash.h"

#include <chrono>
#include <utility>

namespace billiards::client {

namespace {

namespace server = protocol::server;

constexpr base::Duration kAimEvery = std::chrono::milliseconds(100);

/// What was wrong with bytes says nothing to a player.
std::string in_words(const Lost& lost) {
    if (lost.code != LostCode::Malformed) return lost.reason;
    return "the server sent what this program does not understand";
}

/// Who is ready is known anew.
bool settles_readiness(const protocol::ServerMessage& message) {
    return std::holds_alternative<server::SeatChanged>(message) ||
           std::holds_alternative<server::TableChanged>(message) ||
           std::holds_alternative<server::TableSnapshot>(message) ||
           std::holds_alternative<server::Resumed>(message) ||
           std::holds_alternative<server::MatchStarted>(message) ||
           std::holds_alternative<server::Refused>(message);
}

}  // namespace

void Game::connect(const ServerAddress& address, const std::string& name, Errand errand,
                   std::optional<protocol::ResumeToken> token) {
    disconnect();
    errand_ = std::move(errand);
    if (token) forgotten_by_ = Known{.address = address, .name = name};
    ServerLinkOptions options;
    options.address = address;
    options.name = name;
    options.token = token;
    options.seed = seed_;
    link_ = std::make_unique<ServerLink>(std::move(options));
}

void Game::disconnect() {
    link_.reset();
    lost_.clear();
    farewell_.clear();
    refusal_.clear();
    coming_back_ = false;
    std::vector<std::string> muted = std::move(state_.muted);
    state_ = {};
    state_.muted = std::move(muted);
    presentation_.leave();
    placing_.reset();
    rewatch_.reset();
    turn_.reset();
    awaited_.reset();
    shoots_once_placed_ = false;
    asked_to_start_ = false;
    leaving_.reset();
    forgotten_by_.reset();
    is_forgotten_ = false;
}

void Game::advance(base::Instant now) {
    while (take_next()) {
    }
    show(now);
}

bool Game::take_next() {
    const std::optional<LinkEvent> event = link_ ? link_->poll() : std::nullopt;
    if (event) take(*event);
    return event.has_value();
}

void Game::show(base::Instant now) {
    now_ = now;
    presentation_.advance(now);
    if (rewatch_) rewatch_->advance(now);
    start_turn_if_new();
    send_seen();
    show_aim(now);
}

void Game::take(const LinkEvent& event) {
    std::visit([this](const auto& each) { on(each); }, event);
}

void Game::on(const Arrived& arrived) {
    const std::optional<TableView> before = state_.table;
    state_ = reduce(std::move(state_), arrived.message, arrived.at);
    listen_for_farewell(arrived.message);
    if (before && !state_.table && is_connected()) {
        if (!farewell_.empty()) refusal_ = farewell_;
        go_to_lobby();
    }
    if (!state_.table) rewatch_.reset();
    if (const auto* chunk = std::get_if<server::ReplayChunk>(&arrived.message)) {
        if (rewatch_ && !rewatch_->take(*chunk)) rewatch_.reset();
        ask_for_steps();
    }
    const base::Duration offset = state_.clock_offset.value_or(base::Duration::zero());
    if (settles_readiness(arrived.message)) asked_to_start_ = false;
    if (std::holds_alternative<server::TableSnapshot>(arrived.message)) {
        awaited_.reset();
        leaving_.reset();
        turn_.reset();
        errand_ = LookAround{};
        presentation_.enter(*state_.table, offset);
    } else if (std::holds_alternative<server::Resumed>(arrived.message)) {
        awaited_.reset();
    } else if (!state_.table) {
        presentation_.leave();
    } else if (before && *before != *state_.table) {
        presentation_.received(*before, *state_.table, arrived.message, offset);
    }
    if (std::holds_alternative<server::Welcome>(arrived.message)) {
        lost_.clear();
        coming_back_ = false;
        forgotten_by_.reset();
        if (!state_.table) run_errand();
    } else if (const auto* refused = std::get_if<server::Refused>(&arrived.message)) {
        refusal_ = words(*refused);
        is_forgotten_ = refused->code == protocol::RefusedCode::UnknownToken;
        if (!is_forgotten_) errand_ = LookAround{};
        // What cannot be read is refused with no name; whatever is awaited may be that.
        const bool is_unnamed = refused->in_reply_to == 0;
        if (is_unnamed || refused->in_reply_to == awaited_) {
            awaited_.reset();
            shoots_once_placed_ = false;
        }
        if (refused->in_reply_to == leaving_) leaving_.reset();
        if (refused->in_reply_to == rewatch_asked_) rewatch_.reset();
    }
}

void Game::listen_for_farewell(const protocol::ServerMessage& message) {
    farewell_.clear();
    if (const auto* notice = std::get_if<server::Notice>(&message)) farewell_ = tell(*notice);
    if (const auto* refused = std::get_if<server::Refused>(&message)) farewell_ = words(*refused);
}

void Game::on(const LinkLost& lost) {
    if (is_forgotten_ && forgotten_by_) {
        const Known known = *forgotten_by_;
        connect(known.address, known.name, Errand(errand_));
        return;
    }
    state_ = with_link_lost(std::move(state_));
    const bool is_told_why = lost.lost.code == LostCode::Closed && !farewell_.empty();
    lost_ = is_told_why ? std::exchange(farewell_, {}) : in_words(lost.lost);
    coming_back_ = lost.retry_after.has_value();
    if (!coming_back_) link_.reset();
}

void Game::run_errand() {
    if (const auto* open = std::get_if<OpenTable>(&errand_)) {
        send(open->table);
    } else if (const auto* go = std::get_if<GoToTable>(&errand_)) {
        send(go->join);
    } else if (const auto* quick = std::get_if<PlayWhoeverWaits>(&errand_)) {
        send(protocol::client::QuickMatch{quick->game});
    } else {
        if (std::holds_alternative<GoOn>(errand_)) refusal_ = "nothing of yours is played there";
        send(protocol::client::FollowTables{});
    }
}

std::vector<ShownBall> Game::balls(base::Instant now) const {
    std::vector<ShownBall> balls = presentation().balls(now);
    if (!placing_ || is_rewatching()) return balls;
    std::erase_if(balls, [](const ShownBall& ball) { return ball.ball == model::kCueBall; });
    ShownBall held;
    held.ball = model::kCueBall;
    held.radius_m = model::BallSpec{}.radius_m;
    held.state.position_m = base::Vec3(placing_->position_m(), held.radius_m);
    balls.insert(balls.begin(), held);
    return balls;
}

std::optional<model::Seat> Game::acting() const {
    if (is_rewatching()) return std::nullopt;
    if (!is_connected() || awaited_ || presentation_.rolling() != nullptr) return std::nullopt;
    const std::optional<model::Seat> seat = my_turn(state_);
    if (!seat) return std::nullopt;
    const auto opens = local_time_of(state_, state_.table->turn.opens_us);
    return opens && *opens <= now_ ? seat : std::nullopt;
}

std::optional<base::Vec2> Game::cue_ball_m() const {
    if (placing_ && !is_rewatching()) return placing_->position_m();
    const TableView* table = presentation().table();
    if (table == nullptr || !table->match) return std::nullopt;
    const model::PlacedBall* cue_ball = table->match->layout.find(model::kCueBall);
    if (cue_ball == nullptr || cue_ball->place != model::Place::OnTable) return std::nullopt;
    return cue_ball->position_m;
}

void Game::shoot() {
    if (!acting() || state_.table->match->stage != match::Stage::Shooting) return;
    if (placing_ && !placing_->is_down()) {
        set_down();
        shoots_once_placed_ = awaited_.has_value();
        return;
    }
    send_move(protocol::client::TakeShot{
        .turn = *turn_, .shot_id = next_shot_id(), .shot = shot_.shot(), .call = shot_.call()});
}

void Game::move_cue_ball(base::Vec2 by_m) {
    if (placing_ && acting()) placing_->move(by_m);
}

void Game::hold_cue_ball_at(base::Vec2 at_m) {
    if (placing_ && acting()) placing_->hold_at(at_m);
}

void Game::set_down() {
    if (!placing_ || !acting() || placing_->is_down()) return;
    if (!placing_->is_legal()) {
        refusal_ = "the cue ball may not lie there";
        return;
    }
    send_move(protocol::client::PlaceCueBall{.turn = *turn_, .position_m = placing_->position_m()});
}

void Game::choose(rules::Choice choice) {
    if (acting()) send_move(protocol::client::Choose{.turn = *turn_, .choice = choice});
}

/// Once the balls of the last shot rest and it is this screen's turn.
void Game::start_turn_if_new() {
    if (presentation_.rolling() != nullptr) return;
    const std::optional<model::Seat> seat = my_turn(state_);
    if (!seat) {
        placing_.reset();
        turn_.reset();
        return;
    }
    const match::MatchState& match = *state_.table->match;
    const bool in_hand =
        match.rack.in_hand != rules::Zone::None && match.stage == match::Stage::Shooting;
    if (turn_ != match.turn) {
        turn_ = match.turn;
        awaited_.reset();
        shot_.start_turn();
        placing_.reset();
        if (in_hand) placing_.emplace(match);
    } else if (placing_) {
        placing_->update(match);
        if (placing_->is_down() && awaited_) {
            awaited_.reset();
            if (std::exchange(shoots_once_placed_, false)) shoot();
        }
    }
}

void Game::send_seen() {
    const std::optional<std::uint64_t> sequence = presentation_.take_seen();
    if (!sequence || !state_.table || state_.table->my_seats.empty()) return;
    send(protocol::client::Seen{.sequence = *sequence});
}

/// Lets the others see where the cue points.
void Game::show_aim(base::Instant now) {
    if (!acting() || state_.table->match->stage != match::Stage::Shooting) return;
    if (shown_aim_ == shot_.shot() || now - aim_sent_at_ < kAimEvery) return;
    shown_aim_ = shot_.shot();
    aim_sent_at_ = now;
    send(protocol::client::Aim{.turn = *turn_, .shot = shot_.shot()});
}

std::uint32_t Game::send(protocol::ClientMessageBody body) {
    return link_ ? link_->send(std::move(body)) : 0;
}

void Game::send_move(protocol::ClientMessageBody body) {
    refusal_.clear();
    awaited_ = send(std::move(body));
}

std::uint64_t Game::next_shot_id() {
    base::Hasher hasher;
    hasher.add(seed_);
    hasher.add(++shots_sent_);
    return hasher.digest();
}

}  // namespace billiards::client
