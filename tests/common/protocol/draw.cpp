// Draws what messages and journals are made of.
#include "tests/common/protocol/draw.h"

#include "common/match/settings.h"

#include <algorithm>
#include <cmath>

namespace billiards::protocol {

using base::Vec2;
using base::Vec3;
using model::BallId;
using model::Motion;
using model::Seat;
using model::ShotEvent;
using timeline::Segment;

Seat seat() {
    return up_to(Seat::Second);
}
BallId ball() {
    return BallId{within<std::uint8_t>(0, model::kMaxBalls)};
}
/// Ascending, each once.
std::vector<BallId> balls() {
    std::vector<BallId> balls;
    model::BallSet::from_bits(any32()).for_each([&](BallId id) { balls.push_back(id); });
    return balls;
}
model::PerSeat<int> counts() {
    return {{within(0, 1'000'001), within(0, 1'000'001)}};
}
model::PerSeat<int> scores() {
    return {{within(-1'000'000, 1'000'001), within(-1'000'000, 1'000'001)}};
}
model::PerSeat<rules::Group> groups() {
    return {{up_to(rules::Group::Stripes), up_to(rules::Group::Stripes)}};
}
ResumeToken token() {
    ResumeToken token{};
    for (std::uint8_t& byte : token) byte = within<std::uint8_t>(0, 255);
    return token;
}
model::Shot shot() {
    return {fine(10), fine(1), fine(1), fine(1), fine(1e300)};
}
model::Call call() {
    switch (within(0, 4)) {
        case 0:
            return model::NoCall{};
        case 1:
            return model::CalledBall{ball(), model::PocketId{within<std::uint8_t>(0, 6)}};
        case 2:
            return model::Safety{};
        default:
            return model::PushOut{};
    }
}
Vec2 position() {
    return {fine(3), fine(3)};
}

match::Settings settings() {
    return {.game = up_to(rules::Game::Practice),
            .options = {.call = coin(),
                        .nine_on_foot_spot = coin(),
                        .ten_wins_any_time = coin(),
                        .target_points = within(1, rules::kMaxTargetPoints + 1)},
            .table = up_to(model::TableSize::NineFoot),
            .physics = up_to(match::PhysicsPreset::Classic),
            .break_order = up_to(match::BreakOrder::Loser),
            .race_to = within(1, match::kMaxRaceTo + 1),
            .shot_clock_s = std::abs(fine(match::kMaxShotClock_s)),
            .break_shot_clock_s = std::abs(fine(match::kMaxShotClock_s)),
            .extension_s = std::abs(fine(match::kMaxShotClock_s)),
            .aim_help = coin(),
            .spectator_delay_s = std::abs(fine(match::kMaxSpectatorDelay_s))};
}

model::Layout layout() {
    model::Layout layout;
    for (const BallId id : balls()) {
        layout.balls.push_back({id, up_to(model::Place::OffTable), position()});
    }
    return layout;
}

rules::RackState rack() {
    return {.phase = up_to(rules::Phase::AfterBreak),
            .shooter = seat(),
            .groups = maybe(groups),
            .on_table = model::BallSet::from_bits(any32()),
            .in_hand = up_to(rules::Zone::BehindHeadString),
            .behind_head_string = model::BallSet::from_bits(any32()),
            .consecutive_fouls = counts(),
            .push_out_allowed = coin(),
            .scores = scores()};
}

rules::Verdict verdict() {
    return {.fouls = some(10, [] { return up_to(rules::Foul::BreakingFoul); }),
            .turn_continues = coin(),
            .next_player = seat(),
            .in_hand = up_to(rules::Zone::BehindHeadString),
            .choices = some(5, [] { return up_to(rules::Choice::PassBack); }),
            .chooser = maybe(seat),
            .groups = maybe(groups),
            .spotted = balls(),
            .winner = maybe(seat),
            .consecutive_fouls = counts(),
            .reason = up_to(rules::Reason::Practice),
            .phase = up_to(rules::Phase::AfterBreak),
            .score_change = scores(),
            .rerack = up_to(rules::Rerack::Fifteen)};
}

match::MatchState state() {
    return {.settings = settings(),
            .stage = up_to(match::Stage::Over),
            .turn = {any32()},
            .to_act = seat(),
            .rack_number = within(0, 100),
            .breaker = seat(),
            .racks_won = counts(),
            .shots_played = within(0, 1000),
            .rack = rack(),
            .layout = layout(),
            .pending = maybe([] {
                return match::MatchState::Pending{verdict(), rack()};
            }),
            .winner = maybe(seat),
            .extended_in = {{model::TurnNumber{any32()}, model::TurnNumber{any32()}}},
            .offer = maybe([] {
                return match::MatchState::StandingOffer{up_to(match::OfferKind::Draw), seat()};
            }),
            .claim = maybe(counts),
            .undo = {},
            .before_shot = {}};
}

ShotEvent event(double time_s) {
    const BallId one = ball();
    const auto index = within<std::uint16_t>(0, 0xffff);
    switch (up_to(model::EventKind::OffTable)) {
        case model::EventKind::BallBall:
            return ShotEvent::ball_ball(time_s, BallId{3}, one == BallId{3} ? BallId{4} : one);
        case model::EventKind::Cushion:
            return ShotEvent::cushion(time_s, one, index, coin());
        case model::EventKind::Jaw:
            return ShotEvent::jaw(time_s, one, index, coin());
        case model::EventKind::Pocketed:
            return ShotEvent::pocketed(time_s, one, model::PocketId{within<std::uint8_t>(0, 6)});
        case model::EventKind::Motion:
            return ShotEvent::motion(time_s, one, up_to(Motion::OffTable));
        case model::EventKind::HeadString:
            return ShotEvent::head_string(time_s, coin() ? 1 : -1);
        case model::EventKind::Landing:
            return ShotEvent::landing(time_s, one);
        case model::EventKind::OffTable:
            return ShotEvent::off_table(time_s, one);
    }
    RC_FAIL("no such event");
}

/// A part of a segment: all zero at times, or two of its numbers.
Vec3 part(double size) {
    if (coin()) return {};
    return {coarse(size), coarse(size), coin() ? coarse(size) : 0.0};
}

/// Lies at rest height unless it flies; spins as a rolling or a sliding ball does, or anyhow.
Segment segment(double start_s, double radius_m) {
    Segment segment{.start_s = start_s,
                    .position_m = {coarse(3), coarse(3), coarse(1)},
                    .velocity_mps = part(12),
                    .acceleration_mps2 = part(10),
                    .spin_radps = part(500),
                    .spin_rate_radps2 = part(200),
                    .motion = up_to(Motion::OffTable)};
    const bool flies = coin();
    if (!flies) segment.position_m.z = radius_m;
    if (!flies) segment.velocity_mps.z = segment.acceleration_mps2.z = 0;
    const Vec3 up{0, 0, 1};
    if (coin()) segment.spin_rate_radps2 = -2.5 * cross(up, segment.acceleration_mps2) / radius_m;
    if (coin()) {
        segment.spin_radps = cross(up, segment.velocity_mps) / radius_m;
        segment.spin_rate_radps2 = cross(up, segment.acceleration_mps2) / radius_m;
    }
    return segment;
}

std::vector<double> ascending_times(std::size_t max_size) {
    std::vector<double> times = some(max_size, [] { return std::abs(fine(100)); });
    std::sort(times.begin(), times.end());
    return times;
}

timeline::BallTrack track(BallId ball) {
    const double radius_m = 0.03 + 0.01 * fine(1);
    timeline::BallTrack track{ball, radius_m, {segment(0, radius_m)}};
    for (const double start_s : ascending_times(6)) {
        track.segments.push_back(segment(start_s, radius_m));
    }
    return track;
}

timeline::ShotRecord record() {
    timeline::ShotRecord record;
    for (const double time_s : ascending_times(20)) record.events.push_back(event(time_s));
    for (const BallId id : balls()) record.timeline.tracks.push_back(track(id));
    record.final_layout = layout();
    record.duration_s = std::abs(fine(100));
    record.hash = any64();
    return record;
}

}  // namespace billiards::protocol
