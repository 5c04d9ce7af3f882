// Takes who comes, goes and waits at one table; keeps the seats, the stand and the clock.
#include "server/table/table.h"

#include "common/base/check.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace billiards::server {

using model::kSeats;
using model::Seat;
using protocol::RefusedCode;
using protocol::Role;

namespace {

/// Aims are spread out; two in a row make up for a client's jitter.
constexpr int kAimBurst = 2;

bool is_finite(const model::Shot& shot) {
    return std::isfinite(shot.angle_rad) && std::isfinite(shot.power) &&
           std::isfinite(shot.tip_left) && std::isfinite(shot.tip_up) &&
           std::isfinite(shot.elevation_rad);
}

}  // namespace

Table::Table(protocol::TableId id, std::string name, const match::Settings& settings, Access access,
             Surroundings& around, base::Instant now)
    : id_(id),
      name_(std::move(name)),
      settings_(settings),
      access_(std::move(access)),
      around_(around),
      deserted_since_(now),
      aim_to_players_(around.limits.aim_per_s_to_players, std::chrono::seconds(1), kAimBurst),
      aim_to_spectators_(around.limits.aim_per_s_to_spectators, std::chrono::seconds(1), kAimBurst),
      placements_(around.limits.placements_per_10s, std::chrono::seconds(10)),
      chat_(around.limits.table_chat_per_10s, std::chrono::seconds(10)) {}

base::Result<base::Done, RefusedCode> Table::join(base::Instant now, const Visitor& visitor,
                                                  Role role) {
    if (const auto full = take_places(visitor, role)) return *full;
    if (role == Role::Spectator) {
        spectators_changed(now);
    } else {
        seats_changed(now, visitor.session);
    }
    send_snapshot(now, visitor.session);
    return base::Done{};
}

std::optional<RefusedCode> Table::take_places(const Visitor& visitor, Role role) {
    const bool or_away = may_take_seat_of_absent();
    switch (role) {
        case Role::Player: {
            const auto seat = seating_.free_seat(or_away);
            if (!seat) return RefusedCode::SeatTaken;
            seating_.sit(*seat, visitor);
            return std::nullopt;
        }
        case Role::BothSeats:
            if (!seating_.are_both_free(or_away)) return RefusedCode::SeatTaken;
            for (const Seat seat : kSeats) seating_.sit(seat, visitor);
            return std::nullopt;
        case Role::Spectator:
            if (!has_room_to_watch()) return RefusedCode::TableFull;
            seating_.watch(visitor.session);
            return std::nullopt;
    }
    CHECK(false);
    return std::nullopt;
}

/// A player who is away keeps the seat for the match; before and after it, it is for whoever comes.
bool Table::may_take_seat_of_absent() const {
    return !is_playing() && !std::holds_alternative<Start>(pending_);
}

bool Table::has_place_for(PlayerId player) const {
    return seating_.is_seated(player) || has_room_to_watch();
}

bool Table::has_room_to_watch() const {
    return seating_.spectators() <
           static_cast<std::size_t>(around_.limits.max_spectators_per_table);
}

void Table::come_back(base::Instant now, const Visitor& visitor) {
    if (seating_.is_seated(visitor.player)) {
        seating_.come_back(visitor);
        seats_changed(now, visitor.session);
    } else {
        CHECK(has_room_to_watch());
        seating_.watch(visitor.session);
        spectators_changed(now);
    }
    send_snapshot(now, visitor.session);
}

base::Result<base::Done, RefusedCode> Table::leave(base::Instant now, SessionId session) {
    const bool seated = !seating_.seats_of(session).empty();
    if (seated && !may_take_seat_of_absent()) return RefusedCode::MatchRunning;
    seating_.leave(session);
    if (seated) {
        seats_changed(now);
    } else {
        spectators_changed(now);
    }
    return base::Done{};
}

void Table::lose(base::Instant now, SessionId session) {
    const bool seated = !seating_.seats_of(session).empty();
    seating_.lose(session);
    if (seated) {
        seats_changed(now);
    } else {
        spectators_changed(now);
    }
}

void Table::seats_changed(base::Instant now, std::optional<SessionId> except) {
    const bool anyone = seating_.is_anyone_connected();
    if (anyone) deserted_since_.reset();
    if (!anyone && !deserted_since_) deserted_since_ = now;
    announce_seats(except);
    if (clock_.set_running(now, anyone)) announce_turn(except);
    open_turn_if_all_have_seen(now);
}

/// Many come at once, and each would be told of each: they are counted together.
void Table::spectators_changed(base::Instant now) {
    if (!announce_spectators_at_) {
        announce_spectators_at_ = now + around_.limits.spectator_count_every;
    }
}

void Table::ready(base::Instant now, const Asker& asker) {
    if (is_playing() || is_pending()) {
        refuse(around_, asker, RefusedCode::MatchRunning, "the match has started");
        return;
    }
    if (!seating_.set_ready(asker.session)) return;
    seats_changed(now);
    if (seating_.are_all_ready()) start_match(now);
}

void Table::rematch(base::Instant now, const Asker& asker) {
    ready(now, asker);
}

void Table::claim(base::Instant /*now*/, const Asker& asker) {
    refuse(around_, asker, RefusedCode::NotAllowed, "the opponent is here");
}

void Table::aim(base::Instant now, SessionId session, const protocol::client::Aim& aim) {
    if (!is_playing() || !clock_.is_open() || aim.turn != match_->state.turn) return;
    const Seat seat = match_->state.to_act;
    if (seating_.session_of(seat) != session || !is_finite(aim.shot)) return;
    const bool to_players = aim_to_players_.allows(now);
    const bool to_spectators = aim_to_spectators_.allows(now);
    if (!to_players && !to_spectators) return;
    const auto frame = protocol::encode(
        protocol::server::AimShown{.seat = seat, .turn = aim.turn, .shot = aim.shot});
    const auto show = [&](SessionId to) {
        if (to != session) around_.outbox.deliver(to, frame, Delivery::LatestWins);
    };
    if (to_players) seating_.for_each_player(show);
    if (to_spectators) seating_.for_each_spectator(show);
}

void Table::seen(base::Instant now, SessionId session, std::uint64_t sequence) {
    if (!rolling_ || rolling_->played.sequence != sequence) return;
    for (const Seat seat : seating_.seats_of(session)) rolling_->seen[seat] = true;
    open_turn_if_all_have_seen(now);
}

void Table::open_turn_if_all_have_seen(base::Instant now) {
    if (!rolling_ || !clock_.is_waiting() || !seating_.is_anyone_connected()) return;
    const bool all = std::all_of(kSeats.begin(), kSeats.end(), [&](Seat seat) {
        return rolling_->seen[seat] || !seating_.is_connected(seat);
    });
    if (all) open_turn(now);
}

void Table::open_turn(base::Instant now) {
    rolling_.reset();
    clock_.open(now);
    announce_turn();
}

void Table::say(base::Instant now, const Asker& asker, const std::string& name,
                const std::string& text) {
    if (!chat_.allows(now)) {
        refuse(around_, asker, RefusedCode::TooMany, "chat at this table");
        return;
    }
    broadcast(protocol::server::ChatSaid{.name = name, .text = text});
}

std::optional<base::Instant> Table::next_deadline() const {
    std::optional<base::Instant> next = announce_spectators_at_;
    const auto consider = [&](base::Instant when) { next = next ? std::min(*next, when) : when; };
    if (is_pending()) return next;
    if (deserted_since_) consider(*deserted_since_ + around_.limits.empty_table_kept);
    if (clock_.is_waiting()) consider(clock_.opens());
    if (const auto out = clock_runs_out()) consider(*out);
    return next;
}

void Table::advance(base::Instant now) {
    if (announce_spectators_at_ && *announce_spectators_at_ <= now) announce_seats();
    if (is_pending()) return;
    if (clock_.is_waiting() && clock_.opens() <= now) open_turn(now);
    if (const auto out = clock_runs_out(); out && *out <= now) {
        run(now, {.asker = {}, .seats = {}, .what = {match::Timeout{match_->state.turn}}});
    }
}

std::optional<base::Instant> Table::clock_runs_out() const {
    if (!clock_.deadline()) return std::nullopt;
    return *clock_.deadline() + around_.limits.shot_grace;
}

bool Table::is_abandoned(base::Instant now) const {
    return !is_pending() && deserted_since_ &&
           *deserted_since_ + around_.limits.empty_table_kept <= now;
}

bool Table::is_idle() const {
    return !is_pending() && !is_playing() && !seating_.is_anyone_connected();
}

protocol::server::TableRow Table::row() const {
    return {.table = id_,
            .name = name_,
            .settings = settings_,
            .seats = seating_.views(),
            .racks_won = match_ ? match_->state.racks_won : model::PerSeat<int>{},
            .playing = is_playing(),
            .spectators = static_cast<std::uint32_t>(seating_.spectators()),
            .is_private = access_.is_private(),
            .has_passcode = access_.has_passcode(),
            .owner = access_.owner().name};
}

}  // namespace billiards::server
