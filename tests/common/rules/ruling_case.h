// Takes shots told with what should be ruled of them; gives whether the verdicts say exactly that.
#pragma once

#include "common/rules/ruleset.h"
#include "tests/common/rules/told_shot.h"

#include <gtest/gtest.h>
#include <initializer_list>
#include <optional>
#include <utility>
#include <vector>

namespace billiards::rules {

inline RackState with_fouls(RackState state, int of_shooter, int of_other = 0) {
    state.consecutive_fouls = {{of_shooter, of_other}};
    return state;
}

/// What a verdict should say.
struct Ruled {
    Reason reason;
    model::Seat next_player;
    std::vector<Foul> fouls = {};
    Zone in_hand = Zone::None;
    std::vector<Choice> choices = {};
    std::optional<model::Seat> winner = {};
    std::vector<model::BallId> spotted = {};
    int points = 0;  ///< Of the shooter.
    Rerack rerack = Rerack::None;

    Ruled spotting(std::initializer_list<int> numbers) const {
        Ruled with = *this;
        for (const int number : numbers) with.spotted.push_back(ToldShot::id(number));
        return with;
    }
    Ruled scoring(int scored) const {
        Ruled with = *this;
        with.points = scored;
        return with;
    }
    Ruled racking(Rerack racked) const {
        Ruled with = *this;
        with.rerack = racked;
        return with;
    }
};

inline Ruled continues(Reason reason) {
    return {reason, kShooter};
}
inline Ruled passes(Reason reason) {
    return {reason, kOther};
}
inline Ruled foul(std::vector<Foul> fouls, Zone in_hand = Zone::Anywhere) {
    return {Reason::Foul, kOther, std::move(fouls), in_hand};
}
inline Ruled offers(Reason reason, std::vector<Choice> choices) {
    return {reason, kOther, {}, Zone::None, std::move(choices)};
}
inline Ruled wins(Reason reason) {
    return {reason, kShooter, {}, Zone::None, {}, kShooter};
}
inline Ruled loses(Reason reason, std::vector<Foul> fouls) {
    return {reason, kOther, std::move(fouls), Zone::None, {}, kOther};
}

inline void expect_ruled(const Verdict& verdict, const Ruled& expected) {
    EXPECT_EQ(verdict.reason, expected.reason);
    EXPECT_EQ(verdict.next_player, expected.next_player);
    EXPECT_EQ(verdict.fouls, expected.fouls);
    EXPECT_EQ(verdict.in_hand, expected.in_hand);
    EXPECT_EQ(verdict.choices, expected.choices);
    EXPECT_EQ(verdict.winner, expected.winner);
    EXPECT_EQ(verdict.spotted, expected.spotted);
    EXPECT_EQ(verdict.score_change[kShooter], expected.points);
    EXPECT_EQ(verdict.score_change[kOther], 0);
    EXPECT_EQ(verdict.rerack, expected.rerack);
    std::optional<model::Seat> chooser;
    if (!expected.choices.empty()) chooser = expected.next_player;
    EXPECT_EQ(verdict.chooser, chooser);
    const bool stays = expected.next_player == kShooter && !chooser && !expected.winner;
    EXPECT_EQ(verdict.turn_continues, stays);
    EXPECT_EQ(verdict.groups, std::nullopt);
}

struct RulingCase {
    const char* what;
    RackState state;
    model::Call said;
    ToldShot shot;
    Ruled expected;
};

inline void expect_rulings(const Ruleset& rules, std::initializer_list<RulingCase> cases,
                           const Options& options = {}) {
    for (const RulingCase& each : cases) {
        SCOPED_TRACE(each.what);
        expect_ruled(rules.judge(each.state, options, each.said, each.shot.facts()), each.expected);
    }
}

}  // namespace billiards::rules
