// Takes messages and time; gives the table, the balls and the sentences of the moment.
#include "client/play/presentation.h"

#include "client/app/narrate.h"

#include <utility>
#include <variant>

namespace billiards::client {

namespace {

namespace server = protocol::server;

/// What a message says to people; empty where it speaks for itself.
std::string sentence_of(const TableView& before, const protocol::ServerMessage& message) {
    if (const auto* shot = std::get_if<server::ShotPlayed>(&message)) return narrate(before, *shot);
    if (const auto* moved = std::get_if<server::MatchMoved>(&message)) {
        return narrate(before, *moved);
    }
    if (const auto* over = std::get_if<server::MatchOver>(&message)) return narrate(before, *over);
    return "";
}

std::vector<ShownBall> resting(const model::Layout& layout) {
    std::vector<ShownBall> balls;
    for (const model::PlacedBall& placed : layout.balls) {
        if (placed.place != model::Place::OnTable) continue;
        ShownBall& ball = balls.emplace_back();
        ball.ball = placed.ball;
        ball.radius_m = model::BallSpec{}.radius_m;
        ball.state.position_m = {placed.position_m.x, placed.position_m.y, ball.radius_m};
    }
    return balls;
}

}  // namespace

void Presentation::enter(const TableView& table, base::Duration clock_offset) {
    leave();
    table_ = table;
    if (table.last_shot) rolling_.emplace(*table.last_shot, clock_offset);
}

void Presentation::leave() {
    table_.reset();
    rolling_.reset();
    rests_ = false;
    due_.clear();
    lines_.clear();
    seen_.reset();
}

void Presentation::received(const TableView& before, const TableView& after,
                            const protocol::ServerMessage& message, base::Duration clock_offset) {
    Due due{.table = after, .line = sentence_of(before, message)};
    if (const auto* shot = std::get_if<server::ShotPlayed>(&message)) {
        settle();
        rolling_.emplace(*shot, clock_offset);
        due_.push_back(std::move(due));
    } else if (!rolling_) {
        show(std::move(due));
    } else if (due.line.empty() && !due_.empty()) {
        due_.back().table = std::move(due.table);
    } else {
        due_.push_back(std::move(due));
    }
}

void Presentation::advance(base::Instant now) {
    if (!rolling_ || !rolling_->finished(now)) return;
    for (Due& due : due_) say(due.line);
    rests_ = now < rolling_->ends_at() + rest();
    if (!rests_) settle();
}

void Presentation::skip() {
    settle();
}

std::vector<ShownBall> Presentation::balls(base::Instant now) const {
    if (!rolling_)
        return table_ && table_->match ? resting(table_->match->layout) : decltype(balls(now)){};
    std::vector<ShownBall> balls = rolling_->balls(now);
    std::erase_if(balls,
                  [](const ShownBall& ball) { return !model::is_on_table(ball.state.motion); });
    return balls;
}

std::optional<std::uint64_t> Presentation::take_seen() {
    return std::exchange(seen_, std::nullopt);
}

/// Of the balls, before what is due is shown.
base::Duration Presentation::rest() const {
    const bool is_new_rack = !due_.empty() && table_->match && due_.back().table.match &&
                             table_->match->rack_number != due_.back().table.match->rack_number;
    return is_new_rack ? kRackRests : base::Duration::zero();
}

/// Once: the line is empty then.
void Presentation::say(std::string& line) {
    if (line.empty()) return;
    if (lines_.size() >= kLinesKept) lines_.pop_front();
    lines_.push_back(std::exchange(line, {}));
}

void Presentation::show(Due due) {
    table_ = std::move(due.table);
    say(due.line);
}

void Presentation::settle() {
    if (rolling_) seen_ = rolling_->shot().sequence;
    rolling_.reset();
    rests_ = false;
    for (Due& due : std::exchange(due_, {})) show(std::move(due));
}

}  // namespace billiards::client
