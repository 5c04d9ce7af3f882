// Gives any message, within the limits of the wire.
#include "tests/common/protocol/generators.h"

#include "common/protocol/codec_segment.h"
#include "common/protocol/limits.h"

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

namespace billiards::protocol {

namespace {

using base::Vec2;
using base::Vec3;
using model::BallId;
using model::Motion;
using model::Seat;
using model::ShotEvent;
using timeline::Segment;

// Everything below draws: it may only run inside rc::gen::exec.

template <class T>
T within(T low, T high) {
    return *rc::gen::inRange<T>(low, high);
}
bool coin() {
    return *rc::gen::arbitrary<bool>();
}
template <class Enum>
Enum up_to(Enum last) {
    return static_cast<Enum>(within(0, static_cast<int>(last) + 1));
}
std::uint32_t any32() {
    return *rc::gen::arbitrary<std::uint32_t>();
}
std::uint64_t any64() {
    return *rc::gen::arbitrary<std::uint64_t>();
}
std::int64_t any_time_us() {
    return *rc::gen::arbitrary<std::int64_t>();
}
/// Exact in 32 bits, as segments are.
double coarse(double size) {
    return as_sent(size * within(-1'000'000, 1'000'001) / 1e6);
}
/// As fine as a double can be.
double fine(double size) {
    return size * (static_cast<double>(within<std::int64_t>(-(1LL << 52), 1LL << 52)) * 0x1p-52);
}

template <class Draw>
auto maybe(Draw draw) {
    return coin() ? std::optional(draw()) : std::nullopt;
}
template <class Draw>
auto some(std::size_t max_size, Draw draw) {
    std::vector<decltype(draw())> values;
    const std::size_t size = within<std::size_t>(0, max_size + 1);
    for (std::size_t i = 0; i < size; ++i) values.push_back(draw());
    return values;
}

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

server::Turn turn() {
    return {any_time_us(), maybe(any_time_us)};
}
server::SeatView seat_view() {
    return {coin(), coin(), coin(), *any_text(kMaxShownNameLength)};
}
server::TableRow row() {
    return {.table = {any32()},
            .name = *any_text(kMaxTableNameLength),
            .settings = settings(),
            .seats = {{seat_view(), seat_view()}},
            .racks_won = counts(),
            .playing = coin(),
            .spectators = any32()};
}
server::ShotPlayed shot_played() {
    return {.sequence = any64(),
            .struck_us = any_time_us(),
            .seat = seat(),
            .shot_id = any64(),
            .shot = shot(),
            .call = call(),
            .record = record(),
            .verdict = verdict(),
            .after = state(),
            .turn = turn(),
            .commit_us = any32()};
}
server::TableSnapshot snapshot() {
    return {.sequence = any64(),
            .row = row(),
            .your_seats = some(2, seat),
            .match = maybe(state),
            .rolling = maybe(shot_played),
            .turn = turn(),
            .server_time_us = any_time_us()};
}

// One drawer a message, in the variant's order: a new message fails to compile until it has one.

using client::Hello;
void draw(Hello& hello) {
    hello = {*any_text(kMaxNameLength), maybe(token)};
}
void draw(client::ListTables&) {}
void draw(client::CreateTable& create) {
    create = {*any_text(kMaxTableNameLength), settings(), up_to(Role::BothSeats)};
    create.settings.race_to = static_cast<int>(any32());
    create.settings.shot_clock_s = fine(1e300);
}
void draw(client::Join& join) {
    join = {{any32()}, up_to(Role::BothSeats)};
}
void draw(client::Leave&) {}
void draw(client::Ready&) {}
void draw(client::PlaceCueBall& place) {
    place = {{any32()}, {fine(1e300), fine(3)}};
}
void draw(client::Aim& aim) {
    aim = {{any32()}, shot()};
}
void draw(client::TakeShot& take) {
    take = {{any32()}, any64(), shot(), call()};
}
void draw(client::Seen& seen) {
    seen = {any64()};
}
void draw(client::Choose& choose) {
    choose = {{any32()}, up_to(rules::Choice::PassBack)};
}
void draw(client::Concede&) {}
void draw(client::Chat& chat) {
    chat = {*any_text(kMaxChatLength)};
}
void draw(client::Ping& ping) {
    ping = {any_time_us()};
}

void draw(server::Welcome& welcome) {
    welcome = {*any_text(kMaxShownNameLength), token(), any_time_us(),
               maybe([] { return TableId{any32()}; })};
}
void draw(server::Refused& refused) {
    refused = {up_to(RefusedCode::Match),
               maybe([] { return up_to(match::RefusalCode::NothingToUndo); }),
               *any_text(kMaxDetailLength / 4), any32()};
}
void draw(server::TableList& list) {
    list = {some(5, row)};
}
void draw(server::TableSnapshot& drawn) {
    drawn = snapshot();
}
void draw(server::SeatChanged& changed) {
    changed = {any64(), {{seat_view(), seat_view()}}, any32()};
}
void draw(server::MatchStarted& started) {
    started = {any64(), state(), turn()};
}
void draw(server::CueBallPlaced& placed) {
    placed = {any64(), seat(), position()};
}
void draw(server::AimShown& aim) {
    aim = {seat(), {any32()}, shot()};
}
void draw(server::ShotPlayed& played) {
    played = shot_played();
}
void draw(server::TurnOpened& opened) {
    opened = {any64(), {any32()}, turn()};
}
void draw(server::MatchMoved& moved) {
    moved = {any64(),        seat(),  maybe([] { return up_to(rules::Choice::PassBack); }),
             maybe(verdict), state(), turn()};
}
void draw(server::MatchOver& over) {
    over = {any64(), maybe(seat), counts(), any32(), coin()};
}
void draw(server::ChatSaid& said) {
    said = {*any_text(kMaxShownNameLength), *any_text(kMaxChatLength)};
}
void draw(server::Notice& notice) {
    notice = {up_to(server::NoticeCode::ReplacedByNewConnection), *any_text(kMaxDetailLength / 4)};
}
void draw(server::Pong& pong) {
    pong = {any_time_us(), any_time_us()};
}

void draw(match::PlaceCueBall& place) {
    place = {position()};
}
void draw(match::TakeShot& take) {
    take = {{any32()}, shot(), call()};
}
void draw(match::Choose& choose) {
    choose = {{any32()}, up_to(rules::Choice::PassBack)};
}
void draw(match::Timeout& timeout) {
    timeout = {{any32()}};
}
void draw(match::Concede&) {}
void draw(match::Extend& extend) {
    extend = {{any32()}};
}
void draw(match::Offer& offer) {
    offer = {{any32()}, up_to(match::OfferKind::Draw)};
}
void draw(match::Answer& answer) {
    answer = {{any32()}, coin()};
}
void draw(match::ClaimStalemate& claim) {
    claim = {{any32()}};
}
void draw(match::SpotNearest& spot) {
    spot = {{any32()}};
}
void draw(match::PlaceBall& place) {
    place = {ball(), position()};
}
void draw(match::Undo&) {}
void draw(match::Repeat&) {}
void draw(match::Rerack&) {}

/// Any alternative of the variant.
template <class Variant, std::size_t... indices>
Variant any_of(std::index_sequence<indices...>) {
    const std::size_t chosen = within<std::size_t>(0, sizeof...(indices));
    Variant value;
    ((chosen == indices ? draw(value.template emplace<indices>()) : void()), ...);
    return value;
}
template <class Variant>
Variant any_of() {
    return any_of<Variant>(std::make_index_sequence<std::variant_size_v<Variant>>());
}

}  // namespace

rc::Gen<std::string> any_text(std::size_t max_code_points) {
    return rc::gen::exec([max_code_points] {
        static const std::array<std::string, 6> kCodePoints{"a", " ", "é", "漢", "🎱", "\u0301"};
        std::string text;
        const std::size_t length = within<std::size_t>(0, max_code_points + 1);
        for (std::size_t i = 0; i < length; ++i) {
            text += kCodePoints[within<std::size_t>(0, kCodePoints.size())];
        }
        return text;
    });
}

rc::Gen<ClientMessage> any_client_message() {
    return rc::gen::exec([] { return ClientMessage{any32(), any_of<ClientMessageBody>()}; });
}

rc::Gen<ServerMessage> any_server_message() {
    return rc::gen::exec([] { return any_of<ServerMessage>(); });
}

rc::Gen<JournalEntry> any_journal_entry() {
    return rc::gen::exec([] {
        return JournalEntry{.seat = seat(),
                            .command = any_of<match::Command>(),
                            .shot_id = any64(),
                            .verdict = maybe(verdict),
                            .final_layout = maybe(layout),
                            .record = maybe(record)};
    });
}

rc::Gen<timeline::ShotRecord> any_record() {
    return rc::gen::exec([] { return record(); });
}

}  // namespace billiards::protocol
