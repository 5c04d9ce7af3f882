// Gives what two players agree on before a match, and whether a match may be played so.
#pragma once

#include "common/base/result.h"
#include "common/match/refusal.h"
#include "common/model/table_spec.h"
#include "common/rules/verdict.h"

#include <cstdint>

namespace billiards::match {

// The order of every enum here is part of the wire format; only append.

enum class BreakOrder : std::uint8_t { Alternate, Winner, Loser };
enum class PhysicsPreset : std::uint8_t { Realistic, Classic };

inline constexpr int kMaxRaceTo = 50;
inline constexpr double kMaxShotClock_s = 600.0;
inline constexpr double kMaxSpectatorDelay_s = 600.0;

struct Settings {
    rules::Game game = rules::Game::EightBall;
    rules::Options options;
    model::TableSize table = model::TableSize::NineFoot;
    PhysicsPreset physics = PhysicsPreset::Realistic;
    BreakOrder break_order = BreakOrder::Alternate;
    int race_to = 3;                   ///< Racks, 1 to kMaxRaceTo.
    double shot_clock_s = 45.0;        ///< 0: no clock; at most kMaxShotClock_s.
    double break_shot_clock_s = 60.0;  ///< Likewise, for the break shot.
    double extension_s = 30.0;  ///< Once a rack for each seat; 0: none; at most kMaxShotClock_s.
    bool aim_help = true;       ///< For both alike; a client that was changed cannot be forced.
    double spectator_delay_s = 0.0;  ///< How long after the players; at most kMaxSpectatorDelay_s.

    friend bool operator==(const Settings&, const Settings&) = default;
};

/// Refused as BadSettings; the detail begins with the field's name.
Result<base::Done> check(const Settings& settings);

}  // namespace billiards::match
