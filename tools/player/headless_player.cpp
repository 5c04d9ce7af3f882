// Takes messages and time; keeps the client's state, plans the next command and sends it.
#include "tools/player/headless_player.h"

#include "client/app/reduce.h"
#include "common/base/check.h"
#include "common/base/elementary.h"
#include "common/base/hash.h"

#include <algorithm>
#include <fmt/format.h>
#include <utility>
#include <variant>

namespace billiards::tools {

namespace {

namespace server = protocol::server;

/// A server that refuses so often in a row will not take the next one either.
constexpr int kMaxRefusals = 20;
constexpr base::Duration kPauseAfterRefusal = std::chrono::milliseconds(100);
constexpr double kAimWobble_rad = 0.02;

/// Never the same twice in a match, and the same again for a program that starts over with the
/// same seed: so that a shot of before is answered, not played twice.
std::uint64_t shot_id_of(std::uint64_t seed, model::TurnNumber turn, int refusals) {
    base::Hasher hasher;
    hasher.add(seed);
    hasher.add(std::uint64_t{turn.value});
    hasher.add(static_cast<std::uint64_t>(refusals));
    return hasher.digest();
}

/// A command as it is said to a server.
struct ToMessage {
    using Body = protocol::ClientMessageBody;
    model::TurnNumber turn;
    std::uint64_t shot_id;

    Body operator()(const match::PlaceCueBall& place) const {
        return protocol::client::PlaceCueBall{.turn = turn, .position_m = place.position_m};
    }
    Body operator()(const match::TakeShot& take) const {
        return protocol::client::TakeShot{
            .turn = take.turn, .shot_id = shot_id, .shot = take.shot, .call = take.call};
    }
    Body operator()(const match::Choose& choose) const {
        return protocol::client::Choose{.turn = choose.turn, .choice = choose.choice};
    }
    Body operator()(const match::Concede&) const { return protocol::client::Concede{}; }
    template <class Command>
    Body operator()(const Command&) const {
        CHECK(false);  // The clock's, or not yet a client's to say.
        return protocol::client::Concede{};
    }
};

}  // namespace

HeadlessPlayer::HeadlessPlayer(PlayerOptions options, PlayerEvents events, Send send)
    : options_(std::move(options)),
      events_(std::move(events)),
      send_(std::move(send)),
      random_(options_.seed) {
    CHECK(options_.choose != nullptr || options_.role == protocol::Role::Spectator);
}

void HeadlessPlayer::received(const protocol::ServerMessage& message, base::Instant now) {
    tell(message);
    state_ = client::reduce(std::move(state_), message, now);
    react(message, now);
    plan(now);
}

void HeadlessPlayer::link_lost() {
    state_.link = client::LinkState::Lost;
    is_table_stale_ = true;
}

/// Before the message is folded in, so that a teller sees the table as it was.
void HeadlessPlayer::tell(const protocol::ServerMessage& message) {
    if (std::holds_alternative<server::MatchStarted>(message)) digest_ = MatchDigest{};
    if (const auto* refused = std::get_if<server::Refused>(&message)) {
        if (events_.refused) events_.refused(*refused);
    } else if (const auto* welcome = std::get_if<server::Welcome>(&message)) {
        if (events_.welcome) events_.welcome(*welcome);
    } else if (const auto* snapshot = std::get_if<server::TableSnapshot>(&message)) {
        tell_missed(*snapshot);
    }
    if (!state_.table) return;
    const client::TableView& before = *state_.table;
    if (const auto* shot = std::get_if<server::ShotPlayed>(&message)) {
        tell_shot(before, *shot);
    } else if (const auto* moved = std::get_if<server::MatchMoved>(&message)) {
        if (moved->sequence > before.sequence && events_.moved) events_.moved(before, *moved);
    } else if (const auto* over = std::get_if<server::MatchOver>(&message)) {
        if (over->sequence > before.sequence) tell_over(before, *over);
    }
}

void HeadlessPlayer::tell_shot(const client::TableView& before, const server::ShotPlayed& shot) {
    if (digest_.add(shot) && events_.shot) events_.shot(before, shot);
}

void HeadlessPlayer::tell_over(const client::TableView& before, const server::MatchOver& over) {
    digest_.add(over);
    if (events_.over) events_.over(before, over);
}

/// What happened while there was no link, as far as a snapshot tells.
void HeadlessPlayer::tell_missed(const server::TableSnapshot& snapshot) {
    client::TableView before;
    if (state_.table) {
        before = *state_.table;
    } else {
        before.row = snapshot.row;
        before.match = snapshot.match;
    }
    const int known = digest_.shots() + digest_.missed();
    // Another match may have begun meanwhile, but not where only one is played.
    if (snapshot.match && snapshot.match->shots_played < known && !options_.plays_again) {
        failure_ = fmt::format("the server lost shots: it knows {}, and told of {}",
                               snapshot.match->shots_played, known);
        return;
    }
    if (snapshot.rolling) tell_shot(before, *snapshot.rolling);
    const bool is_over = snapshot.match && snapshot.match->stage == match::Stage::Over;
    if (!was_playing_ || before.over || !is_over) return;
    tell_over(before, {.sequence = snapshot.sequence,
                       .winner = snapshot.match->winner,
                       .racks_won = snapshot.match->racks_won,
                       .shots = static_cast<std::uint32_t>(snapshot.match->shots_played)});
}

void HeadlessPlayer::react(const protocol::ServerMessage& message, base::Instant now) {
    if (const auto* welcome = std::get_if<server::Welcome>(&message)) {
        on_welcome(*welcome);
    } else if (const auto* snapshot = std::get_if<server::TableSnapshot>(&message)) {
        on_snapshot(*snapshot, now);
    } else if (std::holds_alternative<server::MatchStarted>(message)) {
        was_playing_ = true;
        awaited_.reset();
    } else if (std::holds_alternative<server::CueBallPlaced>(message) ||
               std::holds_alternative<server::MatchMoved>(message)) {
        awaited_.reset();
        refusals_ = 0;
    } else if (const auto* shot = std::get_if<server::ShotPlayed>(&message)) {
        on_shot(*shot, now);
    } else if (std::holds_alternative<server::MatchOver>(message)) {
        on_over();
    } else if (const auto* refused = std::get_if<server::Refused>(&message)) {
        on_refused(*refused, now);
    } else if (const auto* notice = std::get_if<server::Notice>(&message)) {
        if (notice->code == server::NoticeCode::TableClosed) failure_ = "the table was closed";
        if (notice->code == server::NoticeCode::ReplacedByNewConnection) {
            failure_ = "another connection took over";
        }
    }
}

void HeadlessPlayer::on_welcome(const server::Welcome& welcome) {
    if (welcome.table) return;  // Its snapshot follows.
    if (was_seated_ && options_.role != protocol::Role::Spectator) {
        failure_ = "the table is gone";
    } else if (options_.table) {
        entering_ = send_(protocol::client::Join{.table = *options_.table, .role = options_.role});
    } else {
        entering_ = send_(protocol::client::CreateTable{
            .name = options_.table_name, .settings = options_.settings, .role = options_.role});
    }
}

void HeadlessPlayer::on_snapshot(const server::TableSnapshot& snapshot, base::Instant now) {
    entering_.reset();
    was_seated_ = true;
    is_table_stale_ = false;
    options_.table = snapshot.row.table;  // To come back to.
    const bool is_shot_on_its_way =
        awaited_ && awaited_->is_shot && snapshot.match && snapshot.match->turn == awaited_->turn;
    if (!is_shot_on_its_way) awaited_.reset();
    decided_.reset();
    if (events_.seated) events_.seated(*state_.table);
    if (snapshot.match && snapshot.match->stage == match::Stage::Over) {
        if (was_playing_) on_over();
    } else if (snapshot.match) {
        was_playing_ = true;
    }
    if (snapshot.rolling) on_shot(*snapshot.rolling, now);
    get_ready_if_needed();
}

void HeadlessPlayer::on_shot(const server::ShotPlayed& shot, base::Instant now) {
    if (awaited_ && shot.after.turn > awaited_->turn) awaited_.reset();
    refusals_ = 0;
    if (options_.role == protocol::Role::Spectator) return;
    seen_sequence_ = shot.sequence;
    seen_at_ = now;
    if (!options_.watches_balls_roll) return;
    const auto rests_us = shot.struck_us + base::duration_of(shot.record.duration_s).count();
    seen_at_ = client::local_time_of(state_, rests_us).value_or(now);
}

void HeadlessPlayer::on_over() {
    awaited_.reset();
    is_over_ = !options_.plays_again;
    get_ready_if_needed();
}

void HeadlessPlayer::on_refused(const server::Refused& refused, base::Instant now) {
    const auto cannot_go_on = [&](std::string_view what) {
        failure_ = fmt::format("{}: {}", what, refused.detail);
    };
    if (refused.code == protocol::RefusedCode::UnknownToken) cannot_go_on("the token is unknown");
    if (state_.name.empty()) cannot_go_on("the server refuses");
    if (entering_ && refused.in_reply_to == *entering_) cannot_go_on("no place at the table");
    if (!awaited_ || refused.in_reply_to != awaited_->request_id) return;
    awaited_.reset();
    decided_.reset();
    not_before_ = now + kPauseAfterRefusal;
    if (++refusals_ >= kMaxRefusals) cannot_go_on("refused again and again");
}

void HeadlessPlayer::get_ready_if_needed() {
    if (!state_.table || is_finished() || state_.table->row.playing) return;
    const client::TableView& table = *state_.table;
    if (table.my_seats.empty()) return;
    const bool all_ready =
        std::all_of(table.my_seats.begin(), table.my_seats.end(),
                    [&](model::Seat seat) { return table.row.seats[seat].ready; });
    if (!all_ready || table.over) send_(protocol::client::Ready{});
}

/// When to act, if it is this player's turn; the time to think is drawn once a turn.
void HeadlessPlayer::plan(base::Instant now) {
    act_at_.reset();
    if (is_finished() || is_table_stale_ || awaited_ || !client::my_turn(state_)) {
        aim_at_.reset();
        return;
    }
    const client::TableView& table = *state_.table;
    if (planned_turn_ != table.match->turn) {
        planned_turn_ = table.match->turn;
        think_ = base::duration_of(
            random_.uniform(base::seconds(options_.min_think), base::seconds(options_.max_think)));
        decided_.reset();
        aim_at_.reset();
    }
    const base::Instant opens = client::local_time_of(state_, table.turn.opens_us).value_or(now);
    const bool is_in_hand = !table.match->layout.on_table(model::kCueBall);
    act_at_ = std::max(is_in_hand ? opens : opens + think_, not_before_);
    if (options_.aim_every && !aim_at_) aim_at_ = std::max(opens, now);
}

std::optional<base::Instant> HeadlessPlayer::next_deadline() const {
    if (state_.link != client::LinkState::Ready) return std::nullopt;
    std::optional<base::Instant> next = act_at_;
    for (const std::optional<base::Instant>& other : {aim_at_, seen_at_}) {
        if (other) next = next ? std::min(*next, *other) : other;
    }
    return next;
}

void HeadlessPlayer::advance_time(base::Instant now) {
    if (state_.link != client::LinkState::Ready) return;
    if (seen_at_ && *seen_at_ <= now) {
        send_(protocol::client::Seen{.sequence = seen_sequence_});
        seen_at_.reset();
    }
    if (act_at_ && *act_at_ <= now) {
        act(now);
    } else if (aim_at_ && *aim_at_ <= now) {
        show_aim(now);
    }
}

void HeadlessPlayer::decide() {
    if (!decided_) decided_ = options_.choose(*state_.table->match, random_);
}

void HeadlessPlayer::act(base::Instant now) {
    decide();
    const model::TurnNumber turn = state_.table->match->turn;
    const ToMessage to_message{.turn = turn, .shot_id = shot_id_of(options_.seed, turn, refusals_)};
    awaited_ = Awaited{.request_id = send_(std::visit(to_message, *decided_)),
                       .turn = turn,
                       .is_shot = std::holds_alternative<match::TakeShot>(*decided_)};
    decided_.reset();
    plan(now);
}

void HeadlessPlayer::show_aim(base::Instant now) {
    decide();
    aim_at_ = now + *options_.aim_every;
    const auto* take = std::get_if<match::TakeShot>(&*decided_);
    if (take == nullptr) return;
    model::Shot shot = take->shot;
    shot.angle_rad += random_.uniform(-kAimWobble_rad, kAimWobble_rad);
    send_(protocol::client::Aim{.turn = take->turn, .shot = shot});
}

}  // namespace billiards::tools
