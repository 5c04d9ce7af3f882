// Takes arrivals and departures; keeps the seats and the stand of one table.
#include "server/table/seating.h"

#include <algorithm>
#include <utility>

namespace billiards::server {

using model::kSeats;
using model::Seat;

bool Seating::is_anyone_connected() const {
    return std::any_of(kSeats.begin(), kSeats.end(), [&](Seat seat) { return is_connected(seat); });
}

bool Seating::are_all_ready() const {
    return std::all_of(kSeats.begin(), kSeats.end(),
                       [&](Seat seat) { return holders_[seat] && holders_[seat]->ready; });
}

std::optional<SessionId> Seating::session_of(Seat seat) const {
    if (!holders_[seat]) return std::nullopt;
    return holders_[seat]->session;
}

std::vector<Seat> Seating::seats_of(SessionId session) const {
    std::vector<Seat> seats;
    for (const Seat seat : kSeats) {
        if (is_connected(seat) && *holders_[seat]->session == session) seats.push_back(seat);
    }
    return seats;
}

bool Seating::is_seated(PlayerId player) const {
    return std::any_of(kSeats.begin(), kSeats.end(), [&](Seat seat) {
        return holders_[seat] && holders_[seat]->player == player;
    });
}

std::optional<Seat> Seating::free_seat(bool or_away) const {
    for (const Seat seat : kSeats) {
        if (is_free(seat, false)) return seat;
    }
    for (const Seat seat : kSeats) {
        if (is_free(seat, or_away)) return seat;
    }
    return std::nullopt;
}

bool Seating::are_both_free(bool or_away) const {
    return std::all_of(kSeats.begin(), kSeats.end(),
                       [&](Seat seat) { return is_free(seat, or_away); });
}

void Seating::sit(Seat seat, const Visitor& visitor) {
    holders_[seat] = Holder{.player = visitor.player, .name = visitor.name};
    holders_[seat]->session = visitor.session;
}

void Seating::reserve(Seat seat, PlayerId player, std::string name) {
    holders_[seat] = Holder{.player = player, .name = std::move(name)};
}

void Seating::come_back(const Visitor& visitor) {
    for (const Seat seat : kSeats) {
        if (holders_[seat] && holders_[seat]->player == visitor.player) {
            holders_[seat]->session = visitor.session;
        }
    }
}

void Seating::lose(SessionId session) {
    spectators_.erase(session);
    for (const Seat seat : seats_of(session)) {
        holders_[seat]->session.reset();
        holders_[seat]->ready = false;
    }
}

void Seating::leave(SessionId session) {
    spectators_.erase(session);
    for (const Seat seat : seats_of(session)) holders_[seat].reset();
}

bool Seating::set_ready(SessionId session) {
    bool changed = false;
    for (const Seat seat : seats_of(session)) {
        changed = changed || !holders_[seat]->ready;
        holders_[seat]->ready = true;
    }
    return changed;
}

void Seating::clear_ready() {
    for (const Seat seat : kSeats) {
        if (holders_[seat]) holders_[seat]->ready = false;
    }
}

model::PerSeat<protocol::server::SeatView> Seating::views() const {
    model::PerSeat<protocol::server::SeatView> views;
    for (const Seat seat : kSeats) {
        if (!holders_[seat]) continue;
        views[seat] = {.taken = true,
                       .connected = is_connected(seat),
                       .ready = holders_[seat]->ready,
                       .name = holders_[seat]->name};
    }
    return views;
}

bool Seating::is_free(Seat seat, bool or_away) const {
    return !holders_[seat] || (or_away && !is_connected(seat));
}

bool Seating::is_second_seat_of_same(Seat seat) const {
    return seat == Seat::Second && is_connected(Seat::First) && is_connected(Seat::Second) &&
           *holders_[Seat::First]->session == *holders_[Seat::Second]->session;
}

}  // namespace billiards::server
