// Gives a match between two turns. Values only.
#pragma once

#include "common/match/command.h"
#include "common/match/settings.h"
#include "common/model/layout.h"
#include "common/model/seat.h"
#include "common/rules/verdict.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace billiards::match {

/// The order is part of the wire format; only append.
enum class Stage : std::uint8_t {
    Shooting,  ///< `to_act` may shoot, and place the cue ball while it is in hand.
    Choosing,  ///< `to_act` must choose one of pending->choices.
    Over,
};

inline constexpr int kTurnsOfClaim = 3;         ///< Of each seat, once a stalemate is claimed.
inline constexpr std::size_t kMostUndone = 16;  ///< Earlier positions that practice keeps.

struct MatchState {
    Settings settings;
    std::uint64_t seed = 0;  ///< Of racks and the first break. Never sent to clients.
    Stage stage = Stage::Shooting;
    model::TurnNumber turn{1};
    model::Seat to_act = model::Seat::First;  ///< Always First in practice.
    int rack_number = 1;
    model::Seat breaker = model::Seat::First;
    model::PerSeat<int> racks_won;
    int shots_played = 0;
    rules::RackState rack;  ///< rack.shooter is who shoots next, or would after a choice.
    model::Layout layout;
    /// While Choosing: the verdict that offers the choice, and the rack before that shot.
    struct Pending {
        rules::Verdict verdict;
        rules::RackState before;
        friend bool operator==(const Pending&, const Pending&) = default;
    };
    std::optional<Pending> pending;
    std::optional<model::Seat> winner;  ///< Of the match, once Over; none after a draw or practice.

    /// The turn in which each seat had its extension of this rack; 0: not yet.
    model::PerSeat<model::TurnNumber> extended_in;
    struct StandingOffer {
        OfferKind kind = OfferKind::Stalemate;
        model::Seat by = model::Seat::First;
        friend bool operator==(const StandingOffer&, const StandingOffer&) = default;
    };
    std::optional<StandingOffer> offer;
    /// Turns that each seat has played since a stalemate was claimed; none: it is not.
    std::optional<model::PerSeat<int>> claim;

    struct Position {
        rules::RackState rack;
        model::Layout layout;
        friend bool operator==(const Position&, const Position&) = default;
    };
    // Practice only, and never sent to clients.
    std::vector<Position> undo;           ///< The newest last; at most kMostUndone.
    std::optional<Position> before_shot;  ///< The last one's, for Repeat.

    friend bool operator==(const MatchState&, const MatchState&) = default;
};

}  // namespace billiards::match
