// Takes who comes to one table, goes, is away and is ready; keeps the seats and the stand.
#include "server/table/table.h"

#include "common/base/check.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <span>
#include <utility>

namespace billiards::server {

using model::kSeats;
using model::Seat;
using protocol::RefusedCode;
using protocol::Role;

namespace {

/// Aims are spread out; two in a row make up for a client's jitter.
constexpr int kAimBurst = 2;

std::uint64_t new_stream(const RandomBytes& random) {
    std::array<std::uint8_t, sizeof(std::uint64_t)> bytes{};
    random(bytes);
    std::uint64_t stream = 0;
    std::memcpy(&stream, bytes.data(), sizeof stream);
    return stream;
}

}  // namespace

Table::Table(protocol::TableId id, std::string name, const match::Settings& settings, Access access,
             Surroundings& around, base::Instant now)
    : id_(id),
      name_(std::move(name)),
      settings_(settings),
      access_(std::move(access)),
      around_(around),
      absence_(around.limits.absence_grace),
      stream_(new_stream(around.random)),
      log_({.events = around.limits.kept_events, .bytes = around.limits.kept_event_bytes}),
      gallery_(around.limits),
      deserted_since_(now),
      aim_to_players_(around.limits.aim_per_s_to_players, std::chrono::seconds(1), kAimBurst),
      aim_to_spectators_(around.limits.aim_per_s_to_spectators, std::chrono::seconds(1), kAimBurst),
      placements_(around.limits.placements_per_10s, std::chrono::seconds(10)),
      practice_shots_(around.limits.practice_shots_per_s, std::chrono::seconds(1)),
      players_chat_(around.limits.table_chat_per_10s, std::chrono::seconds(10)),
      stand_chat_(around.limits.table_chat_per_10s, std::chrono::seconds(10)) {
    delay_gallery(now, picture());
}

base::Result<base::Done, RefusedCode> Table::join(base::Instant now, const Visitor& visitor,
                                                  Role role, const Admission& admission) {
    if (seating_.is_seated(visitor.player)) {
        come_back(now, visitor, std::nullopt);
        return base::Done{};
    }
    if (const auto full = take_places(visitor, role)) return *full;
    access_.use_up(admission);
    save();
    if (role == Role::Spectator) {
        spectators_changed(now);
    } else {
        seats_changed(now, visitor.session);
    }
    send_snapshot(now, visitor.session);
    return base::Done{};
}

std::optional<RefusedCode> Table::take_places(const Visitor& visitor, Role role) {
    const bool or_away = is_between_matches();  // A match keeps the seat of who is away.
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

bool Table::is_between_matches() const {
    return !is_playing() && !std::holds_alternative<Start>(pending_);
}

bool Table::has_place_for(PlayerId player) const {
    return seating_.is_seated(player) || has_room_to_watch();
}

bool Table::has_room_to_watch() const {
    return seating_.spectators() <
           static_cast<std::size_t>(around_.limits.max_spectators_per_table);
}

void Table::come_back(base::Instant now, const Visitor& visitor,
                      const std::optional<protocol::client::Followed>& followed) {
    if (seating_.is_seated(visitor.player)) {
        seating_.come_back(visitor);
        seats_changed(now, visitor.session);
    } else {
        CHECK(has_room_to_watch());
        seating_.watch(visitor.session);
        spectators_changed(now);
    }
    catch_up(now, visitor.session, followed);
}

void Table::refresh(base::Instant now, SessionId session) {
    send_snapshot(now, session);
}

base::Result<base::Done, RefusedCode> Table::leave(base::Instant now, SessionId session) {
    const bool seated = !seating_.seats_of(session).empty();
    if (seated && !is_between_matches()) return RefusedCode::MatchRunning;
    seating_.leave(session);
    if (seated) {
        seats_changed(now);
    } else {
        spectators_changed(now);
    }
    return base::Done{};
}

base::Result<base::Done, RefusedCode> Table::vacate(base::Instant now, PlayerId player) {
    if (!is_between_matches()) return RefusedCode::MatchRunning;
    for (const Seat seat : kSeats) {
        if (seating_[seat] && seating_[seat]->player == player) seating_.vacate(seat);
    }
    seats_changed(now);
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
    count_absence(now);
    save();
    announce_seats(now, except);
    if (clock_.set_running(now, anyone)) announce_turn(now, except);
    open_turn_if_all_have_seen(now, except);
}

/// In a match it counts against a player that the opponent waits; what is spent stays spent until
/// the match is over. Otherwise each absence has the whole grace.
void Table::count_absence(base::Instant now) {
    for (const Seat seat : kSeats) {
        const bool is_away = seating_[seat] && !seating_.is_connected(seat);
        if (is_between_matches()) {
            if (!is_away) absence_.give_back(now, seat);
            absence_.count(now, seat, is_away);
        } else {
            absence_.count(now, seat, is_away && seating_.is_connected(opponent_of(seat)));
        }
    }
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
    if (!match_) {
        refuse(around_, asker, RefusedCode::NotAllowed, "no match has been played here yet");
    } else if (!is_playing() && !are_players_of_last_match()) {
        refuse(around_, asker, RefusedCode::NotAllowed, "the opponent of that match has left");
    } else {
        ready(now, asker);
    }
}

bool Table::are_players_of_last_match() const {
    return match_ && std::all_of(kSeats.begin(), kSeats.end(), [&](Seat seat) {
               return seating_[seat] && seating_[seat]->player == match_->players[seat];
           });
}

base::Result<base::Done, RefusedCode> Table::change_settings(base::Instant now,
                                                             const match::Settings& settings) {
    if (!is_between_matches()) return RefusedCode::MatchRunning;
    settings_ = settings;
    seating_.clear_ready();
    save();
    announce_change(now);
    delay_gallery(now, picture());
    return base::Done{};
}

void Table::owner_changed(base::Instant now) {
    save();
    announce_change(now);
}

bool Table::is_abandoned(base::Instant now) const {
    return !is_pending() && deserted_since_ &&
           *deserted_since_ + around_.limits.empty_table_kept <= now;
}

bool Table::is_idle() const {
    const bool is_shown = !gallery_.is_drained() && seating_.spectators() > 0;
    return !is_pending() && !is_playing() && !seating_.is_anyone_connected() && !is_shown;
}

/// Nobody gets more of their delay than the time: who may come in is so at once.
protocol::server::TableRow Table::row() const {
    protocol::server::TableRow row = gallery_.is_delayed() ? gallery_.row() : row_now();
    row.is_private = access_.is_private();
    row.has_passcode = access_.has_passcode();
    row.owner = access_.owner().name;
    return row;
}

protocol::server::TableRow Table::row_now() const {
    return {.table = id_,
            .name = name_,
            .settings = settings_,
            .seats = seat_views(),
            .racks_won = match_ ? match_->state.racks_won : model::PerSeat<int>{},
            .playing = is_playing(),
            .spectators = static_cast<std::uint32_t>(seating_.spectators()),
            .is_private = access_.is_private(),
            .has_passcode = access_.has_passcode(),
            .owner = access_.owner().name};
}

/// Of the next match: the settings are stored with the seed that it does not have yet.
StoredTable Table::stored() const {
    StoredTable table{.table = id_,
                      .name = name_,
                      .settings = protocol::encode_settings(settings_, 0),
                      .owner = {}};
    access_.store_into(table);
    for (const Seat seat : kSeats) {
        if (seating_[seat]) table.seats[seat] = seating_[seat]->player;
    }
    return table;
}

std::optional<Table::ShownMatch> Table::match_shown_to(SessionId session) const {
    const Picture shown = is_shown_late(session) ? gallery_.shown() : picture();
    if (!shown.match_id) return std::nullopt;
    const bool is_a_strangers =
        shown.match_was_private && !access_.is_private() && seating_.seats_of(session).empty();
    if (is_a_strangers) return ShownMatch{*shown.match_id, std::nullopt};
    return ShownMatch{*shown.match_id, shown.steps};
}

/// Where spectators were shown nothing late so far, what they get now has another stream.
void Table::delay_gallery(base::Instant now, const Picture& shown) {
    const bool was_delayed = gallery_.is_delayed();
    gallery_.set_delay(base::duration_of(settings_.spectator_delay_s), shown,
                       new_stream(around_.random));
    if (gallery_.is_delayed() == was_delayed) return;
    seating_.for_each_spectator([&](SessionId to) { send_snapshot(now, to); });
}

}  // namespace billiards::server
