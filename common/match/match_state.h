// Gives a match between two turns, and the commands that move it on. Values only.
#pragma once

#include "common/base/time.h"
#include "common/base/vec.h"
#include "common/model/layout.h"
#include "common/model/seat.h"
#include "common/model/shot.h"
#include "common/model/table_spec.h"
#include "common/rules/verdict.h"
#include "common/timeline/shot_record.h"

#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace billiards::match {

// The order of every enum here is part of the wire format; only append.

enum class BreakOrder : std::uint8_t { Alternate, Winner, Loser };
enum class PhysicsPreset : std::uint8_t { Realistic, Classic };

inline constexpr int kMaxRaceTo = 50;
inline constexpr double kMaxShotClock_s = 600.0;

struct Settings {
    rules::Game game = rules::Game::EightBall;
    rules::Options options;
    model::TableSize table = model::TableSize::NineFoot;
    PhysicsPreset physics = PhysicsPreset::Realistic;
    BreakOrder break_order = BreakOrder::Alternate;
    int race_to = 3;                   ///< Racks, 1 to kMaxRaceTo.
    double shot_clock_s = 45.0;        ///< 0: no clock; at most kMaxShotClock_s.
    double break_shot_clock_s = 60.0;  ///< Likewise, for the break shot.

    friend bool operator==(const Settings&, const Settings&) = default;
};

enum class Stage : std::uint8_t {
    Shooting,  ///< `to_act` may shoot, and place the cue ball while it is in hand.
    Choosing,  ///< `to_act` must choose one of pending->choices.
    Over,
};

struct MatchState {
    Settings settings;
    std::uint64_t seed = 0;  ///< Of racks and the first break. Never sent to clients.
    Stage stage = Stage::Shooting;
    model::TurnNumber turn{1};
    model::Seat to_act = model::Seat::First;
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
    std::optional<model::Seat> winner;  ///< Of the match; set exactly when Over.

    friend bool operator==(const MatchState&, const MatchState&) = default;
};

struct PlaceCueBall {
    base::Vec2 position_m{};
    friend bool operator==(const PlaceCueBall&, const PlaceCueBall&) = default;
};
/// Names the turn it was meant for, so that a shot that crossed another event is refused.
struct TakeShot {
    model::TurnNumber turn;
    model::Shot shot;
    model::Call call;
    friend bool operator==(const TakeShot&, const TakeShot&) = default;
};
struct Choose {
    model::TurnNumber turn;
    rules::Choice choice = rules::Choice::Accept;
    friend bool operator==(const Choose&, const Choose&) = default;
};
/// From the clock, on behalf of the seat that is to act.
struct Timeout {
    model::TurnNumber turn;
    friend bool operator==(const Timeout&, const Timeout&) = default;
};
struct Concede {
    friend bool operator==(const Concede&, const Concede&) = default;
};

/// Everything that can move a match on. The order is part of the journal's format; only append.
using Command = std::variant<PlaceCueBall, TakeShot, Choose, Timeout, Concede>;

}  // namespace billiards::match
