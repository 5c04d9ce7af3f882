// Takes who comes and goes; gives who sits where, who watches, and who is connected.
#pragma once

#include "common/model/seat.h"
#include "common/protocol/messages.h"
#include "server/store/match_store.h"
#include "server/table/outbox.h"

#include <cstddef>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace billiards::server {

/// A player as a table meets one.
struct Visitor {
    SessionId session;
    PlayerId player;
    std::string name;
};

/// Seats belong to players and outlast their connections; spectators are connections.
class Seating {
  public:
    struct Holder {
        PlayerId player;
        std::string name;
        std::optional<SessionId> session{};
        bool ready = false;
    };

    const std::optional<Holder>& operator[](model::Seat seat) const { return holders_[seat]; }
    bool is_connected(model::Seat seat) const { return holders_[seat] && holders_[seat]->session; }
    bool is_anyone_connected() const;
    bool are_all_ready() const;
    std::size_t spectators() const { return spectators_.size(); }

    std::optional<SessionId> session_of(model::Seat seat) const;
    std::vector<model::Seat> seats_of(SessionId session) const;
    bool is_seated(PlayerId player) const;
    /// The first seat that nobody holds; with `or_away`, also one whose player is away.
    std::optional<model::Seat> free_seat(bool or_away) const;
    bool are_both_free(bool or_away) const;

    void sit(model::Seat seat, const Visitor& visitor);
    /// Sits whoever held the seat before a restart, away.
    void reserve(model::Seat seat, PlayerId player, std::string name);
    /// Connects the player's seats again.
    void come_back(const Visitor& visitor);
    void watch(SessionId session) { spectators_.insert(session); }
    /// The connection is lost: seats stay held, though not ready; a stand does not.
    void lose(SessionId session);
    /// Gives up seats or stand.
    void leave(SessionId session);
    void vacate(model::Seat seat) { holders_[seat].reset(); }
    /// False where the session's seats were ready already.
    bool set_ready(SessionId session);
    void clear_ready();

    model::PerSeat<protocol::server::SeatView> views() const;

    /// Calls visit(SessionId) once for each connected seat's session.
    template <class Visit>
    void for_each_player(Visit visit) const {
        for (const model::Seat seat : model::kSeats) {
            if (is_connected(seat) && !is_second_seat_of_same(seat))
                visit(*holders_[seat]->session);
        }
    }
    template <class Visit>
    void for_each_spectator(Visit visit) const {
        for (const SessionId session : spectators_) visit(session);
    }

  private:
    bool is_free(model::Seat seat, bool or_away) const;
    bool is_second_seat_of_same(model::Seat seat) const;

    model::PerSeat<std::optional<Holder>> holders_;
    std::set<SessionId> spectators_;
};

}  // namespace billiards::server
