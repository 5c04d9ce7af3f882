// Takes messages and time; keeps the client's state, plans the next command and sends it.
#include "tools/player/headless_player.h"

#include "client/app/reduce.h"
#include "client/net/unanswered.h"
#include "common/base/check.h"
#include "common/base/hash.h"
#include "tools/player/command_message.h"

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

/// The server's trouble, and not with what was asked: it is asked again for as long as it takes.
bool may_pass(protocol::RefusedCode code) {
    return code == protocol::RefusedCode::StorageFailed || code == protocol::RefusedCode::Busy ||
           code == protocol::RefusedCode::ShuttingDown;
}

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
    const bool is_refusal = std::holds_alternative<server::Refused>(message);
    if (!is_refusal) settle(message);
    react(message, now);
    if (is_refusal) settle(message);  // What was refused had to be known until here.
    plan(now);
}

void HeadlessPlayer::link_lost() {
    state_ = client::with_link_lost(std::move(state_));
}

/// What the link says again by itself stays awaited over a lost link; the rest is decided anew.
void HeadlessPlayer::settle(const protocol::ServerMessage& message) {
    const std::vector<model::Seat> mine =
        state_.table ? state_.table->my_seats : std::vector<model::Seat>();
    const bool is_back = std::holds_alternative<server::TableSnapshot>(message) ||
                         std::holds_alternative<server::Resumed>(message);
    const auto* moved = std::get_if<server::MatchMoved>(&message);
    const bool is_mine =
        moved != nullptr && std::find(mine.begin(), mine.end(), moved->seat) != mine.end();
    for (Awaited* awaited : {&move_, &answer_, &claim_, &readiness_}) {
        if (!*awaited) continue;
        const bool is_done_with =
            client::may_be_repeated((*awaited)->body) ? false : is_back || is_mine;
        if (is_done_with || client::is_answer(message, **awaited, mine)) awaited->reset();
    }
    const bool is_turn_over =
        state_.table && state_.table->match && state_.table->match->turn != planned_turn_;
    if (is_turn_over) move_.reset();
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
    if (snapshot.match && snapshot.match->shots_played < known) {
        if (!options_.plays_again) {
            failure_ = fmt::format("the server lost shots: it knows {}, and told of {}",
                                   snapshot.match->shots_played, known);
            return;
        }
        digest_ = MatchDigest{};
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
    } else if (std::holds_alternative<server::Resumed>(message)) {
        on_resumed();
    } else if (std::holds_alternative<server::MatchStarted>(message)) {
        was_playing_ = true;
    } else if (std::holds_alternative<server::CueBallPlaced>(message) ||
               std::holds_alternative<server::MatchMoved>(message)) {
        refusals_ = 0;
    } else if (std::holds_alternative<server::TableChanged>(message)) {
        get_ready_if_needed();
    } else if (const auto* shot = std::get_if<server::ShotPlayed>(&message)) {
        on_shot(*shot, now);
    } else if (std::holds_alternative<server::MatchOver>(message)) {
        on_over();
    } else if (const auto* refused = std::get_if<server::Refused>(&message)) {
        on_refused(*refused, now);
    } else if (const auto* notice = std::get_if<server::Notice>(&message)) {
        if (notice->code == server::NoticeCode::TableClosed) failure_ = "the table was closed";
        if (notice->code == server::NoticeCode::Kicked) failure_ = "sent away from the table";
        if (notice->code == server::NoticeCode::ReplacedByNewConnection) {
            failure_ = "another connection took over";
        }
    }
}

void HeadlessPlayer::on_welcome(const server::Welcome& welcome) {
    if (welcome.table) return;  // It will be shown, or Resumed.
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
    options_.table = snapshot.row.table;  // To come back to.
    back_at_table();
    if (snapshot.match && snapshot.match->stage == match::Stage::Over) {
        if (was_playing_) on_over();
    } else if (snapshot.match) {
        was_playing_ = true;
    }
    if (snapshot.rolling) on_shot(*snapshot.rolling, now);
    get_ready_if_needed();
}

/// What was missed follows, event by event.
void HeadlessPlayer::on_resumed() {
    if (!state_.table) return;
    back_at_table();
    get_ready_if_needed();
}

void HeadlessPlayer::back_at_table() {
    decided_.reset();
    if (events_.seated) events_.seated(*state_.table);
}

void HeadlessPlayer::on_shot(const server::ShotPlayed& shot, base::Instant now) {
    refusals_ = 0;
    if (options_.role == protocol::Role::Spectator) return;
    seen_sequence_ = shot.sequence;
    seen_at_ = now;
    if (!options_.watches_balls_roll) return;
    const auto rests_us = shot.struck_us + base::duration_of(shot.record.duration_s).count();
    seen_at_ = client::local_time_of(state_, rests_us).value_or(now);
}

void HeadlessPlayer::on_over() {
    move_.reset();
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
    const auto is_about = [&](const Awaited& asked) {
        return asked && asked->request_id == refused.in_reply_to;
    };
    if (is_about(readiness_) && refused.code == protocol::RefusedCode::NotAllowed &&
        std::holds_alternative<protocol::client::Rematch>(readiness_->body)) {
        readiness_ = ask(protocol::client::Ready{});  // Somebody else sits there now.
    }
    if (!is_about(move_) && !is_about(answer_) && !is_about(claim_)) return;
    decided_.reset();
    not_before_ = now + kPauseAfterRefusal;
    if (!may_pass(refused.code) && ++refusals_ >= kMaxRefusals) {
        cannot_go_on("refused again and again");
    }
}

protocol::ClientMessage HeadlessPlayer::ask(protocol::ClientMessageBody body) {
    protocol::ClientMessage message{.request_id = 0, .body = body};
    message.request_id = send_(std::move(body));
    return message;
}

void HeadlessPlayer::get_ready_if_needed() {
    if (!state_.table || is_finished() || state_.table->row.playing || readiness_) return;
    const client::TableView& table = *state_.table;
    if (table.my_seats.empty()) return;
    const bool all_ready =
        std::all_of(table.my_seats.begin(), table.my_seats.end(),
                    [&](model::Seat seat) { return table.row.seats[seat].ready; });
    if (all_ready) return;
    const bool is_over = table.match && table.match->stage == match::Stage::Over;
    readiness_ = is_over ? ask(protocol::client::Rematch{}) : ask(protocol::client::Ready{});
}

void HeadlessPlayer::plan(base::Instant now) {
    act_at_.reset();
    answer_at_.reset();
    claim_at_.reset();
    if (is_finished() || state_.is_table_stale || !state_.table || !state_.table->match ||
        state_.table->my_seats.empty() || state_.table->match->stage == match::Stage::Over) {
        aim_at_.reset();
        return;
    }
    plan_turn(now);
    plan_answer(now);
    plan_claim();
}

/// When to act, if it is this player's turn; the time to think is drawn once a turn.
void HeadlessPlayer::plan_turn(base::Instant now) {
    if (move_ || !client::my_turn(state_)) {
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

void HeadlessPlayer::plan_answer(base::Instant now) {
    const client::TableView& table = *state_.table;
    const auto& offer = table.match->offer;
    if (!options_.accepts_offers || !offer || answer_) return;
    const auto& mine = table.my_seats;
    if (std::find(mine.begin(), mine.end(), offer->by) != mine.end()) return;
    const base::Instant opens = client::local_time_of(state_, table.turn.opens_us).value_or(now);
    answer_at_ = std::max(opens, not_before_);
}

void HeadlessPlayer::plan_claim() {
    const client::TableView& table = *state_.table;
    if (!options_.claims_match || claim_ || table.my_seats.size() != 1) return;
    const server::SeatView& opponent = table.row.seats[model::opponent_of(table.my_seats[0])];
    if (opponent.connected || !opponent.claimable_us) return;
    const auto when = client::local_time_of(state_, *opponent.claimable_us);
    if (when) claim_at_ = std::max(*when, not_before_);
}

std::optional<base::Instant> HeadlessPlayer::next_deadline() const {
    if (state_.link != client::LinkState::Ready) return std::nullopt;
    std::optional<base::Instant> next = act_at_;
    for (const auto& other : {aim_at_, seen_at_, answer_at_, claim_at_}) {
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
    if (answer_at_ && *answer_at_ <= now) answer_offer(now);
    if (claim_at_ && *claim_at_ <= now) {
        claim_ = ask(protocol::client::ClaimMatch{});
        plan(now);
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
    move_ = ask(message_of(*decided_, turn, shot_id_of(options_.seed, turn, refusals_)));
    decided_.reset();
    plan(now);
}

void HeadlessPlayer::answer_offer(base::Instant now) {
    answer_ = ask(protocol::client::Answer{.turn = state_.table->match->turn,
                                           .accept = *options_.accepts_offers});
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
