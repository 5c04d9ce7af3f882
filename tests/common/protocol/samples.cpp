// Gives one message of each kind, each field with a value of its own.
#include "tests/common/protocol/samples.h"

#include "common/protocol/limits.h"

#include <utility>

namespace billiards::protocol {

namespace {

using model::BallId;
using model::BallSet;
using model::Motion;
using model::Place;
using model::Seat;
using model::TurnNumber;
using timeline::Segment;

ResumeToken sample_token() {
    ResumeToken token{};
    for (std::size_t i = 0; i < token.size(); ++i) token[i] = static_cast<std::uint8_t>(7 * i + 1);
    return token;
}

model::Shot sample_shot() {
    return {.angle_rad = -1.25,
            .power = 0.7,
            .tip_left = -0.125,
            .tip_up = 0.3,
            .elevation_rad = 0.0625};
}

InviteSecret sample_invite() {
    InviteSecret secret{};
    for (std::size_t i = 0; i < secret.size(); ++i) secret[i] = static_cast<std::uint8_t>(200 - i);
    return secret;
}

match::Settings settings() {
    return {.game = rules::Game::EightBall,
            .options = {.call = false},
            .table = model::TableSize::EightFoot,
            .physics = match::PhysicsPreset::Classic,
            .break_order = match::BreakOrder::Loser,
            .race_to = 5,
            .shot_clock_s = 30.5,
            .break_shot_clock_s = 0.0};
}

/// With every option of a later day, too.
match::Settings all_settings() {
    match::Settings all = settings();
    all.options = {
        .call = true, .nine_on_foot_spot = true, .ten_wins_any_time = true, .target_points = 125};
    all.extension_s = 12.5;
    all.aim_help = false;
    all.spectator_delay_s = 90.0;
    return all;
}

model::Layout layout() {
    return {{{BallId{0}, Place::InHand, {}},
             {BallId{1}, Place::OnTable, {0.1, -0.2}},
             {BallId{8}, Place::Pocketed, {1.3, 0.66}},
             {BallId{15}, Place::OffTable, {-1.7, 0.3}}}};
}

rules::RackState rack() {
    return {.phase = rules::Phase::Groups,
            .shooter = Seat::Second,
            .groups = {{{rules::Group::Stripes, rules::Group::Solids}}},
            .on_table = BallSet{BallId{1}, BallId{8}, BallId{15}},
            .in_hand = rules::Zone::BehindHeadString,
            .behind_head_string = BallSet{BallId{1}},
            .consecutive_fouls = {{1, 2}},
            .push_out_allowed = false,
            .scores = {}};
}

rules::Verdict verdict() {
    return {.fouls = {rules::Foul::Scratch, rules::Foul::WrongBallStruck},
            .turn_continues = true,
            .next_player = Seat::Second,
            .in_hand = rules::Zone::Anywhere,
            .choices = {rules::Choice::RebreakOpponent, rules::Choice::SpotEight},
            .chooser = Seat::Second,
            .groups = {{{rules::Group::Solids, rules::Group::Stripes}}},
            .spotted = {BallId{8}, BallId{15}},
            .winner = Seat::First,
            .consecutive_fouls = {{0, 3}},
            .reason = rules::Reason::ClockRanOut,
            .phase = rules::Phase::Open,
            .score_change = {},
            .rerack = rules::Rerack::None};
}

match::MatchState choosing() {
    return {.settings = settings(),
            .stage = match::Stage::Choosing,
            .turn = TurnNumber{17},
            .to_act = Seat::Second,
            .rack_number = 4,
            .breaker = Seat::Second,
            .racks_won = {{2, 1}},
            .shots_played = 41,
            .rack = rack(),
            .layout = layout(),
            .pending = match::MatchState::Pending{verdict(), rack()},
            .winner = Seat::First,
            .extended_in = {},
            .offer = {},
            .claim = {},
            .undo = {},
            .before_shot = {}};
}

/// With everything that stands between two turns.
match::MatchState disputed() {
    match::MatchState state;
    state.settings = all_settings();
    state.layout = layout();
    state.rack.phase = rules::Phase::AfterBreak;
    state.rack.push_out_allowed = true;
    state.rack.scores = {{-3, 77}};
    state.extended_in = {{TurnNumber{3}, TurnNumber{17}}};
    state.offer = {match::OfferKind::Draw, Seat::Second};
    state.claim = {{1, 2}};
    return state;
}

match::MatchState fresh() {
    match::MatchState state;
    state.settings = settings();
    state.layout = layout();
    return state;
}

server::Turn turn() {
    return {.opens_us = 123'456'789, .deadline_us = 168'456'789};
}

server::SeatView seat(const std::string& name) {
    return {.taken = true, .connected = name.empty(), .ready = !name.empty(), .name = name};
}

server::TableRow row() {
    return {.table = TableId{9},
            .name = "Zum blauen Stoß",
            .settings = settings(),
            .seats = {{seat("Ada#3f21"), seat("")}},
            .racks_won = {{3, 4}},
            .playing = true,
            .spectators = 12};
}

server::SeatView away() {
    server::SeatView view = seat("");
    view.name = "Bo#0001";
    view.claimable_us = 60'000'000;
    return view;
}

server::TableRow private_row() {
    server::TableRow made = row();
    made.is_private = true;
    made.has_passcode = true;
    made.owner = "Ada#3f21";
    return made;
}

server::HistoryRow history_row() {
    return {.match = 41,
            .ended_s = 1'767'225'600,
            .game = rules::Game::NineBall,
            .names = {{"Ada#3f21", "Bo#0001"}},
            .racks_won = {{5, 4}},
            .winner = Seat::First,
            .shots = 212,
            .ending = server::Ending::Claimed};
}

server::ShotPlayed shot_played() {
    return {.sequence = 77,
            .struck_us = -5,
            .seat = Seat::Second,
            .shot_id = 0xfedcba9876543210U,
            .shot = sample_shot(),
            .call = model::CalledBall{BallId{8}, model::PocketId{5}},
            .record = sample_record(),
            .verdict = verdict(),
            .after = choosing(),
            .turn = turn(),
            .commit_us = 4321};
}

/// Spins about the vertical, too, wherever it moves.
Segment moving(double start_s, Motion motion) {
    return {.start_s = start_s,
            .position_m = {0.5, -0.25, 0.03125},
            .velocity_mps = {1.5, -0.5, 0},
            .acceleration_mps2 = {-0.75, 0.25, 0},
            .spin_radps = {0, 0, 6},
            .spin_rate_radps2 = {0, 0, -12},
            .motion = motion};
}

std::vector<Segment> sample_segments() {
    // radius 1/32 m, so that what follows from velocities is exact.
    Segment sliding = moving(0, Motion::Sliding);
    sliding.spin_radps = {3, 4, 6};
    sliding.spin_rate_radps2 = {-2.5 * 32 * -0.25, -2.5 * 32 * -0.75, -12};
    Segment rolling = moving(0.1, Motion::Rolling);
    rolling.spin_radps = {32 * 0.5, 32 * 1.5, 6};
    rolling.spin_rate_radps2 = {32 * -0.25, 32 * -0.75, -12};
    Segment flying = moving(0.2, Motion::Airborne);
    flying.position_m.z = 0.0625;
    flying.velocity_mps.z = 1.25;
    flying.acceleration_mps2 = {0, 0, -9.75};
    flying.spin_radps = {1, 2, 0};
    flying.spin_rate_radps2 = {0, 0, 0};
    Segment free = moving(0.3, Motion::Sliding);
    free.spin_radps = {1, 2, 0.5};
    free.spin_rate_radps2 = {3, -4, 0.25};
    Segment spinning{.start_s = 0.4,
                     .position_m = {0.75, 0.5, 0.03125},
                     .spin_radps = {0, 0, 2},
                     .spin_rate_radps2 = {0, 0, -12},
                     .motion = Motion::Spinning};
    Segment resting{.start_s = 0.7, .position_m = {0.75, 0.5, 0.03125}};
    return {sliding, rolling, flying, free, spinning, resting};
}

}  // namespace

timeline::ShotRecord sample_record() {
    using model::ShotEvent;
    const BallId one{1};
    return {.events = {ShotEvent::motion(0, model::kCueBall, Motion::Sliding),
                       ShotEvent::ball_ball(0.1, model::kCueBall, one),
                       ShotEvent::cushion(0.1, one, 17, true), ShotEvent::jaw(0.15, one, 11, false),
                       ShotEvent::head_string(0.25, -1), ShotEvent::landing(0.3, model::kCueBall),
                       ShotEvent::pocketed(0.5, one, model::PocketId{5}),
                       ShotEvent::off_table(0.6, BallId{21})},
            .timeline = {{{model::kCueBall, 0.03125, sample_segments()},
                          {one, 0.028575, {{.position_m = {1, 2, 0.028575}}}},
                          {BallId{21}, 0.028, {{.motion = Motion::OffTable}}}}},
            .final_layout = layout(),
            .duration_s = 0.7000000000000001,
            .hash = 0x0123456789abcdefU};
}

std::vector<Sample<ClientMessage>> client_samples() {
    const TurnNumber turn{17};
    return {
        {"hello", {1, client::Hello{"Ada", {}}}},
        {"hello with token", {2, client::Hello{"Žofie 漢字", sample_token()}}},
        {"list tables", {3, client::ListTables{}}},
        {"create table", {4, client::CreateTable{"Ada's", settings(), Role::BothSeats}}},
        {"join", {5, client::Join{TableId{9}, Role::Spectator}}},
        {"leave", {6, client::Leave{}}},
        {"ready", {7, client::Ready{}}},
        {"place cue ball", {8, client::PlaceCueBall{turn, {-0.6, 0.1}}}},
        {"aim", {9, client::Aim{turn, sample_shot()}}},
        {"take shot", {10, client::TakeShot{turn, 99, sample_shot(), model::NoCall{}}}},
        {"take called shot",
         {11, client::TakeShot{turn, 100, sample_shot(),
                               model::CalledBall{BallId{8}, model::PocketId{3}}}}},
        {"take safety", {12, client::TakeShot{turn, 101, sample_shot(), model::Safety{}}}},
        {"take push-out", {18, client::TakeShot{turn, 102, sample_shot(), model::PushOut{}}}},
        {"create table with every option",
         {19, client::CreateTable{"Ada's", all_settings(), Role::Player}}},
        {"seen", {13, client::Seen{77}}},
        {"choose", {14, client::Choose{turn, rules::Choice::BallInHandBehindHeadString}}},
        {"concede", {15, client::Concede{}}},
        {"chat", {16, client::Chat{"good shot 🎱"}}},
        {"ping", {0xffffffffU, client::Ping{-123'456'789'012}}},
        {"hello of a follower",
         {20, client::Hello{"Ada", sample_token(), client::Followed{TableId{9}, 1ULL << 63U, 77}}}},
        {"create private table",
         {21, client::CreateTable{"Ada's", settings(), Role::Player, true, "blue chalk"}}},
        {"join by invite", {22, client::Join{TableId{9}, Role::Player, sample_invite(), ""}}},
        {"join by passcode", {23, client::Join{TableId{9}, Role::Spectator, {}, "blue chalk"}}},
        {"follow tables", {24, client::FollowTables{}}},
        {"quick match", {25, client::QuickMatch{rules::Game::NineBall}}},
        {"change table", {26, client::ChangeTable{all_settings(), true, "green chalk"}}},
        {"change table but its passcode", {27, client::ChangeTable{settings(), false, {}}}},
        {"make invite", {28, client::MakeInvite{Role::Spectator}}},
        {"revoke invites", {29, client::RevokeInvites{}}},
        {"kick", {30, client::Kick{"Bo#0001"}}},
        {"rematch", {31, client::Rematch{}}},
        {"claim match", {32, client::ClaimMatch{}}},
        {"extend", {33, client::Extend{turn}}},
        {"offer", {34, client::Offer{turn, match::OfferKind::Draw}}},
        {"answer", {35, client::Answer{turn, true}}},
        {"claim stalemate", {36, client::ClaimStalemate{turn}}},
        {"spot nearest", {37, client::SpotNearest{turn}}},
        {"place ball", {38, client::PlaceBall{BallId{9}, {0.25, -0.1}}}},
        {"undo", {39, client::Undo{}}},
        {"repeat", {40, client::Repeat{}}},
        {"rerack", {41, client::Rerack{}}},
        {"ask history", {42, client::AskHistory{"Bo#0001", 99}}},
        {"ask record", {43, client::AskRecord{"Bo#0001"}}},
        {"ask replay", {44, client::AskReplay{41, 64}}},
    };
}

std::vector<Sample<ServerMessage>> server_samples() {
    return {
        {"welcome", server::Welcome{"Ada#3f21", sample_token(), 1'000'000, {}}},
        {"welcome back", server::Welcome{"Ada#3f21", sample_token(), 1'000'001, TableId{9}}},
        {"refused", server::Refused{RefusedCode::TooMany, {}, "chat", 16}},
        {"refused by the match",
         server::Refused{RefusedCode::Match, match::RefusalCode::Unsolvable, "20001 events", 11}},
        {"table list", server::TableList{{row(), server::TableRow{}}}},
        {"table snapshot", server::TableSnapshot{.sequence = 78,
                                                 .row = row(),
                                                 .your_seats = {Seat::First, Seat::Second},
                                                 .match = choosing(),
                                                 .rolling = shot_played(),
                                                 .turn = turn(),
                                                 .server_time_us = 5}},
        {"empty table snapshot", server::TableSnapshot{}},
        {"seat changed", server::SeatChanged{79, {{seat("Bo#0001"), seat("")}}, 3}},
        {"match started", server::MatchStarted{80, fresh(), turn()}},
        {"match started in dispute", server::MatchStarted{86, disputed(), turn()}},
        {"cue ball placed", server::CueBallPlaced{81, Seat::Second, {-0.6, 0.1}}},
        {"aim shown", server::AimShown{Seat::Second, TurnNumber{17}, sample_shot()}},
        {"shot played", shot_played()},
        {"turn opened", server::TurnOpened{82, TurnNumber{18}, turn()}},
        {"match moved", server::MatchMoved{83, Seat::Second, rules::Choice::SpotEight, verdict(),
                                           fresh(), turn()}},
        {"match moved by the clock",
         server::MatchMoved{84, Seat::First, {}, {}, choosing(), server::Turn{}}},
        {"match over",
         server::MatchOver{85, Seat::Second, {{4, 5}}, 120, server::Ending::Conceded}},
        {"match drawn", server::MatchOver{87, {}, {{4, 5}}, 121, server::Ending::Played}},
        {"chat said", server::ChatSaid{"Ada#3f21", "good shot 🎱"}},
        {"notice", server::Notice{server::NoticeCode::ReplacedByNewConnection, "from elsewhere"}},
        {"pong", server::Pong{-1, 2}},
        {"player away", server::SeatChanged{88, {{seat("Ada#3f21"), away()}}, 3}},
        {"private table list", server::TableList{{private_row()}}},
        {"table snapshot with its stream", server::TableSnapshot{.sequence = 89,
                                                                 .row = private_row(),
                                                                 .your_seats = {Seat::Second},
                                                                 .match = {},
                                                                 .rolling = {},
                                                                 .turn = {},
                                                                 .server_time_us = 6,
                                                                 .stream = 1ULL << 63U}},
        {"match moved by an answer",
         server::MatchMoved{90, Seat::First, {}, {}, disputed(), turn(), server::Move::Rejection}},
        {"match claimed", server::MatchOver{91, Seat::First, {{1, 1}}, 9, server::Ending::Claimed}},
        {"kicked", server::Notice{server::NoticeCode::Kicked, "by the owner"}},
        {"not the owner", server::Refused{RefusedCode::NotOwner, {}, "", 29}},
        {"resumed", server::Resumed{TableId{9}, {Seat::First}, 123}},
        {"table changed", server::TableChanged{92, private_row()}},
        {"table list change", server::TableListChange{{row()}, {TableId{3}, TableId{4}}}},
        {"invite made", server::InviteMade{TableId{9}, true, sample_invite(), 86'400'000'000}},
        {"history page", server::HistoryPage{{history_row(), server::HistoryRow{}}, true}},
        {"player record", server::PlayerRecord{"Ada#3f21", 12, 7, 1, 1580.25, 91.5}},
        {"replay chunk",
         server::ReplayChunk{41, 64, 300, {{std::byte{1}, std::byte{255}}, {std::byte{7}}}}},
    };
}

std::vector<Sample<JournalEntry>> journal_samples() {
    const TurnNumber turn{17};
    const auto entry = [](match::Command command) {
        JournalEntry made;
        made.seat = Seat::Second;
        made.command = std::move(command);
        return made;
    };
    JournalEntry shot = entry(match::TakeShot{turn, sample_shot(), model::Safety{}});
    shot.shot_id = 99;
    shot.verdict = verdict();
    shot.final_layout = layout();
    shot.record = sample_record();
    JournalEntry timeout = entry(match::Timeout{turn});
    timeout.verdict = verdict();
    return {{"place cue ball", entry(match::PlaceCueBall{{-0.6, 0.1}})},
            {"take shot", shot},
            {"choose", entry(match::Choose{turn, rules::Choice::RebreakSelf})},
            {"timeout", timeout},
            {"concede", entry(match::Concede{})},
            {"extend", entry(match::Extend{turn})},
            {"offer", entry(match::Offer{turn, match::OfferKind::Draw})},
            {"answer", entry(match::Answer{turn, true})},
            {"claim stalemate", entry(match::ClaimStalemate{turn})},
            {"spot nearest", entry(match::SpotNearest{turn})},
            {"place ball", entry(match::PlaceBall{BallId{9}, {0.25, -0.1}})},
            {"undo", entry(match::Undo{})},
            {"repeat", entry(match::Repeat{})},
            {"rerack", entry(match::Rerack{})},
            {"forfeit", entry(match::Forfeit{})}};
}

StoredSettings sample_settings() {
    return {.settings = settings(), .seed = 0x8000000000000001U};
}

std::span<const std::byte> content_of(const SharedFrame& frame) {
    return std::span<const std::byte>(*frame).subspan(kFrameHeaderBytes);
}

}  // namespace billiards::protocol
