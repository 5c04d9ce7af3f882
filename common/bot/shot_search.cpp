// Takes a match; gives a shot: the pot that leaves the best position, else the safest contact,
// else the best of shots all around.
#include "common/bot/shot_search.h"

#include "common/base/elementary.h"
#include "common/bot/candidates.h"
#include "common/bot/evaluate.h"
#include "common/match/match.h"
#include "common/model/table_spec.h"
#include "common/rules/facts.h"
#include "common/rules/ruleset.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace billiards::bot {

namespace {

using base::Vec2;
using match::MatchState;

constexpr double kRadius_m = model::BallSpec{}.radius_m;
constexpr std::size_t kPotsTried = 8;
/// Times the speed that just brings the ball to the pocket. Friction between the balls throws a cut
/// off its line, by less the harder and the more spinning the hit: some way of playing it goes in.
constexpr double kPotPaces[] = {1.3, 2.0, 3.0};
constexpr double kPotTips_up[] = {0.0, 0.3, -0.3};
constexpr double kSafetyPowers[] = {0.12, 0.25};
/// Where on the object ball a safety hits it, in radii from the full hit.
constexpr double kSafetyFullness[] = {0.0, 1.4, -1.4};
constexpr int kAroundShots = 36;
constexpr double kAroundPower = 0.35;
constexpr double kBreakPower_low = 0.9;
constexpr double kBreakSpread_rad = base::radians(0.25);

double angle_of(Vec2 direction) {
    return base::arc_tangent(direction.y, direction.x);
}

/// Keeps the best of what was tried, and counts.
class Search {
  public:
    explicit Search(const MatchState& state) : state_(state) {}

    /// The trial, or null where it was refused or nothing may be tried any more. Valid until the
    /// next call.
    const Trial* attempt(const model::Shot& shot, const model::Call& call) {
        if (trials_ == kMaxTrials) return nullptr;
        ++trials_;
        last_ = try_shot(state_, shot, call);
        if (!last_) return nullptr;
        if (!best_ || last_->worth > best_worth_) {
            best_ = last_->command;
            best_worth_ = last_->worth;
        }
        return &*last_;
    }

    const std::optional<match::TakeShot>& best() const { return best_; }
    /// Whether the best is worth at least this much.
    bool has(double worth) const { return best_ && best_worth_ >= worth; }

  private:
    const MatchState& state_;
    std::optional<Trial> last_;
    std::optional<match::TakeShot> best_;
    double best_worth_ = 0.0;
    int trials_ = 0;
};

model::Call call_for(const MatchState& state, const model::Call& wish) {
    const rules::Ruleset& rules = rules::ruleset_of(state.settings.game);
    const bool allowed = rules.is_call_allowed(state.rack, state.settings.options, wish);
    return allowed ? wish : model::NoCall{};
}

/// The power that brings the object ball to the pocket with nothing to spare: both balls roll at
/// 5/7 of the speed they start with, and slow down by rolling friction.
double just_enough_power(const physics::Parameters& parameters, const Pot& pot) {
    constexpr double kStartOverRoll = 7.0 / 5.0;
    const double slowing_mps2 = parameters.rolling_friction * parameters.gravity_mps2;
    const double ball_mps = kStartOverRoll * std::sqrt(2 * slowing_mps2 * pot.ball_path_m);
    const double contact_mps = ball_mps / pot.cut_cosine;
    const double cue_ball_mps =
        kStartOverRoll * std::sqrt(contact_mps * contact_mps + 2 * slowing_mps2 * pot.cue_path_m);
    const double full_power_mps =
        parameters.cue_spring_npm * parameters.cue_contact_time_s / model::BallSpec{}.mass_kg;
    return cue_ball_mps / full_power_mps;
}

void try_pots(Search& search, const MatchState& state, Vec2 cue_ball_m,
              const std::vector<Pot>& pots) {
    const physics::Parameters& parameters = match::parameters_of(state.settings.physics);
    // Every pot is seen with a plain hit before any is tried with spin: the trials may run out.
    for (const double tip_up : kPotTips_up) {
        for (const double pace : kPotPaces) {
            for (std::size_t i = 0; i < std::min(pots.size(), kPotsTried); ++i) {
                const double power = pace * just_enough_power(parameters, pots[i]);
                if (power > 1.0) continue;
                const double angle_rad = aim_rad(cue_ball_m, pots[i]);
                search.attempt({.angle_rad = angle_rad, .power = power, .tip_up = tip_up},
                               call_for(state, model::CalledBall{pots[i].ball, pots[i].pocket}));
            }
        }
    }
}

/// As a safety; and where a ball fell, once more with that ball called.
void try_contact(Search& search, const MatchState& state, const model::Shot& shot) {
    const Trial* trial = search.attempt(shot, call_for(state, model::Safety{}));
    if (trial == nullptr) return;
    const rules::Facts facts = rules::facts_of(trial->step.outcome.record->events);
    for (const auto& [ball, pocket] : facts.pocketed) {
        search.attempt(shot, call_for(state, model::CalledBall{ball, pocket}));
    }
}

void try_safeties(Search& search, const MatchState& state, Vec2 cue_ball_m,
                  model::BallSet targets) {
    for (const model::PlacedBall& placed : state.layout.balls) {
        if (!state.layout.on_table(placed.ball) || !targets.contains(placed.ball)) continue;
        const Vec2 path_m = placed.position_m - cue_ball_m;
        const Vec2 aside = Vec2{-path_m.y, path_m.x} / glm::length(path_m);
        for (const double fullness : kSafetyFullness) {
            const Vec2 aim_m = placed.position_m + fullness * kRadius_m * aside;
            if (!is_path_clear(state.layout, cue_ball_m, aim_m, placed.ball)) continue;
            for (const double power : kSafetyPowers) {
                const double angle_rad = angle_of(aim_m - cue_ball_m);
                try_contact(search, state, {.angle_rad = angle_rad, .power = power});
            }
        }
    }
}

/// By way of the cushions, if nothing legal can be seen.
void try_all_around(Search& search, const MatchState& state) {
    for (int i = 0; i < kAroundShots; ++i) {
        const double angle_rad = 2 * base::kPi * i / kAroundShots - base::kPi;
        try_contact(search, state, {.angle_rad = angle_rad, .power = kAroundPower});
    }
}

}  // namespace

match::TakeShot best_shot(const MatchState& state) {
    constexpr double kTurnKept = 100.0;
    constexpr double kNoFoul = -100.0;
    const Vec2 cue_ball_m = state.layout.find(model::kCueBall)->position_m;
    const rules::Ruleset& rules = rules::ruleset_of(state.settings.game);
    const model::BallSet targets = rules.legal_first_balls(state.rack);
    Search search(state);
    const model::TableSpec& table = model::table_of(state.settings.table);
    try_pots(search, state, cue_ball_m, pots_from(table, state.layout, targets, cue_ball_m));
    if (!search.has(kTurnKept)) try_safeties(search, state, cue_ball_m, targets);
    if (!search.has(kNoFoul)) try_all_around(search, state);
    // Where the engine gave up on everything: a shot that at least is none of those.
    return search.best().value_or(match::TakeShot{state.turn, {.power = 0.05}, model::NoCall{}});
}

match::TakeShot break_shot(const MatchState& state, base::Random& random) {
    const Vec2 cue_ball_m = state.layout.find(model::kCueBall)->position_m;
    const auto distance_m = [&](const model::PlacedBall& placed) {
        const bool counts = placed.ball != model::kCueBall && placed.place == model::Place::OnTable;
        return counts ? glm::distance(placed.position_m, cue_ball_m) : HUGE_VAL;
    };
    const auto apex = std::ranges::min_element(state.layout.balls, {}, distance_m);
    model::Shot shot;
    shot.angle_rad = angle_of(apex->position_m - cue_ball_m) +
                     random.uniform(-kBreakSpread_rad, kBreakSpread_rad);
    shot.power = random.uniform(kBreakPower_low, 1.0);
    return {state.turn, shot, model::NoCall{}};
}

}  // namespace billiards::bot
