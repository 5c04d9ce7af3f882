// Takes the facts of a shot at eight-ball; gives the ruling. Each kind of shot is one table of
// rulings in order of rank: the first that applies is the verdict.
#include "common/base/check.h"
#include "common/model/rack.h"
#include "common/rules/games.h"
#include "common/rules/racking.h"
#include "common/rules/ruling.h"
#include "common/rules/standard_fouls.h"

#include <algorithm>
#include <array>
#include <utility>

namespace billiards::rules {

namespace {

using model::BallId;
using model::BallSet;
using model::kEightBall;
using model::Seat;

constexpr int kBallsToCushionsOnBreak = 4;

BallSet balls_of(Group group) {
    return BallSet::from_bits(group == Group::Solids ? 0x00FEU : 0xFE00U);
}

Group group_of(BallId ball) {
    return ball < kEightBall ? Group::Solids : Group::Stripes;
}

/// The shooter may play the 8 as soon as a group that is or could be the shooter's is wholly gone.
BallSet playable_balls(const RackState& state) {
    const BallSet eight{kEightBall};
    if (state.groups) {
        const BallSet own = balls_of((*state.groups)[state.shooter]) & state.on_table;
        return own.empty() ? eight & state.on_table : own;
    }
    const bool group_gone = (balls_of(Group::Solids) & state.on_table).empty() ||
                            (balls_of(Group::Stripes) & state.on_table).empty();
    return group_gone ? state.on_table : state.on_table - eight;
}

bool is_playable(const RackState& state, BallId ball) {
    return ball.number < model::kMaxBalls && playable_balls(state).contains(ball);
}

/// The ball that keeps the shooter at the table, if it is not a foul: the called one in its
/// pocket, or without calls the first that was the shooter's to play.
std::optional<BallId> scoring_ball(const RackState& state, const Options& options,
                                   const model::Call& call, const Facts& facts) {
    const auto* called = std::get_if<model::CalledBall>(&call);
    for (const auto& [ball, pocket] : facts.pocketed) {
        const bool as_called = called && called->ball == ball && called->pocket == pocket;
        if ((as_called || !options.call) && is_playable(state, ball)) return ball;
    }
    return std::nullopt;
}

model::PerSeat<Group> groups_with(Seat seat, Group group) {
    model::PerSeat<Group> groups;
    groups[seat] = group;
    groups[opponent_of(seat)] = group == Group::Solids ? Group::Stripes : Group::Solids;
    return groups;
}

std::vector<Ruling> break_rulings(const RackState& state, const Facts& facts, bool illegal,
                                  bool foul) {
    const bool scratch = facts.cue_ball_lost;
    const bool eight = fallen_balls(facts).contains(kEightBall);
    const Seat breaker = state.shooter;
    const Seat other = opponent_of(breaker);
    const Zone behind = Zone::BehindHeadString;
    const Zone where_it_lies = Zone::None;
    const std::vector<Choice> rebreak{Choice::Accept, Choice::RebreakSelf, Choice::RebreakOpponent};
    const std::vector<Choice> eight_back{Choice::SpotEight, Choice::RebreakSelf};
    const std::vector<Choice> accept{Choice::Accept, Choice::BallInHandBehindHeadString};
    return {
        {illegal, Reason::IllegalBreak, other, scratch ? behind : where_it_lies, rebreak},
        {eight && foul, Reason::EightOnFoulBreak, other, behind, eight_back},
        {eight, Reason::EightOnBreak, breaker, where_it_lies, eight_back},
        {scratch, Reason::Foul, other, behind},
        {foul, Reason::BreakFoul, other, where_it_lies, accept},
        {!facts.pocketed.empty(), Reason::BreakPot, breaker},
        {true, Reason::LegalBreak, other},
    };
}

Verdict judge_break(const RackState& state, const Facts& facts) {
    const bool illegal =
        facts.pocketed.empty() && facts.driven_to_cushion.size() < kBallsToCushionsOnBreak;
    std::vector<Foul> fouls = standard_fouls(state, state.on_table, facts);
    if (illegal) fouls.push_back(Foul::IllegalBreak);
    std::ranges::sort(fouls);
    const bool foul = !fouls.empty();
    Verdict verdict =
        verdict_of(state, std::move(fouls), break_rulings(state, facts, illegal, foul));
    verdict.phase = Phase::Open;
    // Where there is a choice, the 8 comes back with it.
    const bool eight_off = facts.off_table.contains(kEightBall);
    if (eight_off && verdict.choices.empty()) verdict.spotted.push_back(kEightBall);
    return verdict;
}

/// How a rack ends: the rulings on an 8 that fell or left the table after the break.
std::vector<Ruling> eight_rulings(const RackState& state, const Facts& facts, bool foul,
                                  bool called) {
    const bool eight = fallen_balls(facts).contains(kEightBall);
    const Seat other = opponent_of(state.shooter);
    return {
        win_for(other, facts.off_table.contains(kEightBall), Reason::EightOffTable),
        win_for(other, eight && foul, Reason::EightWithFoul),
        win_for(other, eight && !is_playable(state, kEightBall), Reason::EightEarly),
        win_for(other, eight && !called, Reason::EightUncalled),
        win_for(state.shooter, eight, Reason::EightWon),
    };
}

std::vector<Ruling> turn_rulings(const RackState& state, const Facts& facts, bool foul, bool safety,
                                 bool scored) {
    const Seat other = opponent_of(state.shooter);
    return {
        {foul, Reason::Foul, other, Zone::Anywhere},
        {safety, Reason::Safety, other},
        {scored, Reason::LegalPot, state.shooter},
        {facts.pocketed.empty(), Reason::NothingPotted, other},
        {true, Reason::NotCalled, other},
    };
}

Verdict judge_after_break(const RackState& state, const Options& options, const model::Call& call,
                          const Facts& facts) {
    std::vector<Foul> fouls = standard_fouls(state, playable_balls(state), facts);
    const bool foul = !fouls.empty();
    const bool safety = std::holds_alternative<model::Safety>(call);
    const std::optional<BallId> scoring = scoring_ball(state, options, call, facts);
    const bool eight_called = options.call ? scoring == kEightBall : !safety;

    const auto rulings = in_order(eight_rulings(state, facts, foul, eight_called),
                                  turn_rulings(state, facts, foul, safety, scoring.has_value()));
    Verdict verdict = verdict_of(state, std::move(fouls), rulings);
    // Where the groups were set before, the ball was the shooter's and this changes nothing.
    if (verdict.reason == Reason::LegalPot) {
        verdict.groups = groups_with(state.shooter, group_of(*scoring));
        verdict.phase = Phase::Groups;
    }
    return verdict;
}

class EightBall final : public Ruleset {
  public:
    model::Layout rack(const Options& options, const model::TableSpec& table, double radius_m,
                       base::Random& random) const override;
    model::BallSet legal_first_balls(const RackState& state) const override;
    bool is_call_allowed(const RackState& state, const Options& options,
                         const model::Call& call) const override;
    Verdict judge(const RackState& state, const Options& options, const model::Call& call,
                  const Facts& facts) const override;
    Verdict judge_timeout(const RackState& state) const override;
    Resolution resolve(const RackState& before, const Verdict& verdict,
                       Choice choice) const override;
};

/// The 8 in the middle, one ball of each group at the rear corners, the rest at random.
model::Layout EightBall::rack(const Options&, const model::TableSpec& table, double radius_m,
                              base::Random& random) const {
    constexpr std::array<std::size_t, 2> kRearCorners{10, 14};
    std::vector<BallId> balls = shuffled_balls(15, random);
    put_at(balls, model::kMiddlePlace, kEightBall);
    // The 8 cannot be at a corner any more. Of the balls that are at none, every one that would
    // mend a corner is as likely as the others, for their order is random.
    const Group first = group_of(balls[kRearCorners[0]]);
    if (group_of(balls[kRearCorners[1]]) == first) {
        const auto mends = [&](BallId ball) {
            return ball != kEightBall && group_of(ball) != first;
        };
        std::swap(balls[kRearCorners[1]], *std::ranges::find_if(balls, mends));
    }
    return racked_layout(balls, model::triangle_positions(table, radius_m));
}

BallSet EightBall::legal_first_balls(const RackState& state) const {
    return state.phase == Phase::Break ? state.on_table : playable_balls(state);
}

bool EightBall::is_call_allowed(const RackState& state, const Options& options,
                                const model::Call& call) const {
    if (std::holds_alternative<model::NoCall>(call)) return true;
    if (state.phase == Phase::Break) return false;
    if (std::holds_alternative<model::Safety>(call)) return true;
    const auto* called = std::get_if<model::CalledBall>(&call);
    return called != nullptr && options.call && called->pocket.number < model::kPockets &&
           is_playable(state, called->ball);
}

Verdict EightBall::judge(const RackState& state, const Options& options, const model::Call& call,
                         const Facts& facts) const {
    return state.phase == Phase::Break ? judge_break(state, facts)
                                       : judge_after_break(state, options, call, facts);
}

Verdict EightBall::judge_timeout(const RackState& state) const {
    const bool before_break = state.phase == Phase::Break;
    const Zone zone = before_break ? Zone::BehindHeadString : Zone::Anywhere;
    const Ruling ruling[] = {{true, Reason::ClockRanOut, opponent_of(state.shooter), zone}};
    return verdict_of(state, {Foul::Clock}, ruling);
}

Resolution EightBall::resolve(const RackState&, const Verdict& verdict, Choice choice) const {
    CHECK(verdict.chooser.has_value());
    const Seat self = *verdict.chooser;
    const bool as_ruled = choice == Choice::Accept || choice == Choice::SpotEight;
    Resolution resolution;
    resolution.rerack = choice == Choice::RebreakSelf || choice == Choice::RebreakOpponent;
    resolution.next_player = choice == Choice::RebreakOpponent ? opponent_of(self) : self;
    resolution.in_hand = as_ruled ? verdict.in_hand : Zone::BehindHeadString;
    // However it was lost on the break: play goes on with it.
    if (!resolution.rerack) resolution.spotted.push_back(kEightBall);
    return resolution;
}

}  // namespace

const Ruleset& eight_ball() {
    static const EightBall rules;
    return rules;
}

}  // namespace billiards::rules
