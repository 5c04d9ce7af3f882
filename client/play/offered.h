// Takes a table as it is shown; gives what its people may ask for besides the shot.
#pragma once

#include "client/app/client_state.h"
#include "common/base/time.h"

#include <optional>

namespace billiards::client {

/// By the same rules as the server's; what is not offered here would be refused there.
struct Offered {
    bool start = false;    ///< To say that one is ready for a match.
    bool rematch = false;  ///< Likewise, for another one between the same two.
    bool extension = false;
    bool spot_nearest = false;
    bool claim_stalemate = false;
    bool offer_draw = false;
    bool offer_replay = false;               ///< Of the rack, as a stalemate.
    std::optional<match::OfferKind> answer;  ///< To this offer of the opponent's.
    bool claim_match = false;                ///< The opponent has been away for too long.
    bool concede = false;
    bool shoot = false;
    bool safety = false;
    bool push_out = false;
    bool practise = false;  ///< Place any ball, rack anew.
    bool repeat = false;    ///< The last shot of a practice.

    friend bool operator==(const Offered&, const Offered&) = default;
};

/// `known`: the clock's. `shown`: the table as it is on the screen. `acting`: the seat that may act
/// here and now.
Offered offered(const ClientState& known, const TableView& shown,
                const std::optional<model::Seat>& acting, base::Instant now);

/// One player, or one screen, has both seats.
bool has_both_seats(const TableView& table);
/// The match that is over was played by the two who sit there now.
bool is_between_the_same(const TableView& table);
/// The session of this screen opened the table, or has it from who did.
bool is_owner(const ClientState& known, const TableView& table);

}  // namespace billiards::client
