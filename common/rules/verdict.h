// Gives the words of a ruling: what the rules know before a shot and what they say after it.
// Enums only; sentences for people are made in the user interface.
#pragma once

#include "common/model/ball.h"
#include "common/model/seat.h"
#include "common/model/shot.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace billiards::rules {

// The order of every enum here is part of the wire format; only append.

enum class Game : std::uint8_t { EightBall, NineBall, TenBall, StraightPool, Practice };

enum class Group : std::uint8_t { Solids, Stripes };

/// Where a rack stands. Open: eight-ball without groups yet. AfterBreak: the shot that may be a
/// push-out. Groups: the ordinary phase of every game; groups are set at eight-ball only.
enum class Phase : std::uint8_t { Break, Open, Groups, AfterBreak };

/// Where the cue ball may be set down before the next shot.
enum class Zone : std::uint8_t { None, Anywhere, BehindHeadString };

enum class Foul : std::uint8_t {
    Scratch,  ///< Cue ball pocketed or off the table.
    NoBallHit,
    WrongBallFirst,
    NoCushionAfterContact,
    BallOffTable,
    IllegalBreak,
    HeadString,  ///< Played from behind the head string at a ball behind it without crossing.
    Clock,
    BadPlacement,
    WrongBallStruck,
    BreakingFoul,  ///< At straight pool: an opening break that does not meet its requirement.
};

/// Seen from the one who chooses.
enum class Choice : std::uint8_t {
    Accept,
    RebreakSelf,
    RebreakOpponent,
    SpotEight,
    BallInHandBehindHeadString,
    Play,      ///< The chooser plays on from where the balls lie.
    PassBack,  ///< The one who played does.
};

/// At straight pool: how many balls are racked again. Fourteen: without the apex.
enum class Rerack : std::uint8_t { None, Fourteen, Fifteen };

/// Why the table passes, stays or is won. Each has its sentence in docs/rules.md.
enum class Reason : std::uint8_t {
    LegalPot,          ///< A called ball went down: the shooter continues.
    BreakPot,          ///< A ball fell on a legal break: the breaker continues.
    LegalBreak,        ///< Nothing fell on a legal break: the turn passes.
    NothingPotted,     ///< No foul, no called ball down: the turn passes.
    NotCalled,         ///< Balls fell, the called one did not: the turn passes.
    Safety,            ///< A called safety: the turn passes.
    Foul,              ///< The opponent comes to the table, as the zone says.
    IllegalBreak,      ///< Too few balls to cushions: the opponent chooses.
    BreakFoul,         ///< A ball left the table on the break: the opponent chooses.
    EightOnBreak,      ///< The 8 fell on a legal break: the breaker chooses.
    EightOnFoulBreak,  ///< The 8 fell on a foul break: the opponent chooses.
    EightWon,          ///< The called 8 went down: the rack is won.
    EightWithFoul,     ///< The 8 fell on a foul: the rack is lost.
    EightEarly,        ///< The 8 fell before the group was cleared: the rack is lost.
    EightUncalled,     ///< The 8 fell uncalled, in another pocket or on a safety: the rack is lost.
    EightOffTable,     ///< The rack is lost.
    ClockRanOut,       ///< A foul; or, before the break, the other player breaks.
    ThreeFouls,     ///< The third foul in a row: the rack is lost, or 15 points at straight pool.
    PushOut,        ///< The opponent chooses who plays on.
    NineWon,        ///< The 9 went down on a legal shot: the rack is won.
    TenWon,         ///< The 10 went down as called: the rack is won.
    TenEarly,       ///< The called 10 went down too early: it is spotted, the shooter continues.
    UncalledPot,    ///< A ball fell, not the called one, at ten-ball: the opponent chooses.
    BreakingFoul,   ///< At straight pool: the opponent accepts or orders another break.
    TargetReached,  ///< At straight pool: the points to win are made.
    Practice,       ///< Nobody is judged.
};

inline constexpr int kMaxTargetPoints = 1000;

struct Options {
    bool call = true;  ///< Eight-ball: ball and pocket are called on every shot but the break.
    bool nine_on_foot_spot = false;  ///< Nine-ball: the 9 and not the 1 is racked there.
    bool ten_wins_any_time = false;  ///< Ten-ball: the called 10 wins before the last ball too.
    int target_points = 100;         ///< Straight pool: 1 to kMaxTargetPoints.

    friend bool operator==(const Options&, const Options&) = default;
};

/// What the rules know of a rack before a shot.
struct RackState {
    Phase phase = Phase::Break;
    model::Seat shooter = model::Seat::First;
    std::optional<model::PerSeat<Group>> groups;
    model::BallSet on_table;  ///< Object balls only.
    Zone in_hand = Zone::None;
    model::BallSet behind_head_string;  ///< Object balls there before the shot.
    model::PerSeat<int> consecutive_fouls;
    bool push_out_allowed = false;
    model::PerSeat<int> scores;  ///< At straight pool; may be below zero.

    friend bool operator==(const RackState&, const RackState&) = default;
};

/// What the rules say of a shot. While a choice is pending: turn_continues is false, next_player
/// is the chooser, in_hand is the zone if the choice is to play on, spotted leaves the 8 out.
struct Verdict {
    std::vector<Foul> fouls;  ///< In the order of the enum, each once.
    bool turn_continues = false;
    model::Seat next_player = model::Seat::First;
    Zone in_hand = Zone::None;
    std::vector<Choice> choices;  ///< Empty: nothing to choose.
    std::optional<model::Seat> chooser;
    std::optional<model::PerSeat<Group>> groups;
    std::vector<model::BallId> spotted;  ///< In ascending number.
    std::optional<model::Seat> winner;   ///< Of the rack.
    model::PerSeat<int> consecutive_fouls;
    Reason reason = Reason::NothingPotted;
    Phase phase = Phase::Open;  ///< Of the next shot, if the rack goes on as it lies.
    model::PerSeat<int> score_change;
    /// Where the rack of straight pool is set up again, the cue ball's zone follows from where the
    /// balls lie, which the rules do not see: `in_hand` is the least that holds.
    Rerack rerack = Rerack::None;

    friend bool operator==(const Verdict&, const Verdict&) = default;
};

/// What follows from a choice.
struct Resolution {
    bool rerack = false;  ///< The rack is broken again, by `next_player`.
    model::Seat next_player = model::Seat::First;
    Zone in_hand = Zone::None;
    std::vector<model::BallId> spotted;  ///< Those of them that are not on the table.

    friend bool operator==(const Resolution&, const Resolution&) = default;
};

}  // namespace billiards::rules
