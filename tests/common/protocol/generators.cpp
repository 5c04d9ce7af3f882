// Gives any message, within the limits of the wire.
#include "tests/common/protocol/generators.h"

#include "common/protocol/limits.h"
#include "tests/common/protocol/draw.h"

#include <array>
#include <utility>
#include <vector>

namespace billiards::protocol {

namespace {

InviteSecret invite() {
    InviteSecret secret{};
    for (std::uint8_t& byte : secret) byte = within<std::uint8_t>(0, 255);
    return secret;
}
server::Turn turn() {
    return {any_time_us(), maybe(any_time_us)};
}
server::SeatView seat_view() {
    return {coin(), coin(), coin(), *any_text(kMaxShownNameLength), maybe(any_time_us)};
}
server::TableRow row() {
    return {.table = {any32()},
            .name = *any_text(kMaxTableNameLength),
            .settings = settings(),
            .seats = {{seat_view(), seat_view()}},
            .racks_won = counts(),
            .playing = coin(),
            .spectators = any32(),
            .is_private = coin(),
            .has_passcode = coin(),
            .owner = *any_text(kMaxShownNameLength)};
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
            .server_time_us = any_time_us(),
            .stream = any64()};
}

// One drawer a message, in the variant's order: a new message fails to compile until it has one.

using client::Hello;
void draw(Hello& hello) {
    hello = {*any_text(kMaxNameLength), maybe(token), maybe([] {
                 return client::Followed{{any32()}, any64(), any64()};
             })};
}
void draw(client::ListTables&) {}
void draw(client::CreateTable& create) {
    create = {*any_text(kMaxTableNameLength), settings(), up_to(Role::BothSeats), coin(),
              *any_text(kMaxPasscodeLength)};
    create.settings.race_to = static_cast<int>(any32());
    create.settings.shot_clock_s = fine(1e300);
}
void draw(client::Join& join) {
    join = {{any32()}, up_to(Role::BothSeats), maybe(invite), *any_text(kMaxPasscodeLength)};
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

void draw(client::FollowTables&) {}
void draw(client::QuickMatch& quick) {
    quick = {up_to(rules::Game::Practice)};
}
void draw(client::ChangeTable& change) {
    change = {settings(), coin(), maybe([] { return *any_text(kMaxPasscodeLength); })};
}
void draw(client::MakeInvite& make) {
    make = {up_to(Role::BothSeats)};
}
void draw(client::RevokeInvites&) {}
void draw(client::Kick& kick) {
    kick = {*any_text(kMaxShownNameLength)};
}
void draw(client::Rematch&) {}
void draw(client::ClaimMatch&) {}
void draw(client::Extend& extend) {
    extend = {{any32()}};
}
void draw(client::Offer& offer) {
    offer = {{any32()}, up_to(match::OfferKind::Draw)};
}
void draw(client::Answer& answer) {
    answer = {{any32()}, coin()};
}
void draw(client::ClaimStalemate& claim) {
    claim = {{any32()}};
}
void draw(client::SpotNearest& spot) {
    spot = {{any32()}};
}
void draw(client::PlaceBall& place) {
    place = {ball(), {fine(1e300), fine(3)}};
}
void draw(client::Undo&) {}
void draw(client::Repeat&) {}
void draw(client::Rerack&) {}
void draw(client::AskHistory& ask) {
    ask = {*any_text(kMaxShownNameLength), any64()};
}
void draw(client::AskRecord& ask) {
    ask = {*any_text(kMaxShownNameLength)};
}
void draw(client::AskReplay& ask) {
    ask = {any64(), any64()};
}

void draw(server::Welcome& welcome) {
    welcome = {*any_text(kMaxShownNameLength), token(), any_time_us(),
               maybe([] { return TableId{any32()}; })};
}
void draw(server::Refused& refused) {
    refused = {up_to(RefusedCode::Busy),
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
    moved = {any64(),
             seat(),
             maybe([] { return up_to(rules::Choice::PassBack); }),
             maybe(verdict),
             state(),
             turn(),
             up_to(server::Move::Reracking)};
}
void draw(server::MatchOver& over) {
    over = {any64(), maybe(seat), counts(), any32(), up_to(server::Ending::Abandoned)};
}
void draw(server::ChatSaid& said) {
    said = {*any_text(kMaxShownNameLength), *any_text(kMaxChatLength)};
}
void draw(server::Notice& notice) {
    notice = {up_to(server::NoticeCode::Kicked), *any_text(kMaxDetailLength / 4)};
}
void draw(server::Pong& pong) {
    pong = {any_time_us(), any_time_us()};
}

void draw(server::Resumed& resumed) {
    resumed = {{any32()}, some(2, seat), any_time_us()};
}
void draw(server::TableChanged& changed) {
    changed = {any64(), row()};
}
void draw(server::TableListChange& change) {
    change = {some(5, row), some(5, [] { return TableId{any32()}; })};
}
void draw(server::InviteMade& made) {
    made = {{any32()}, coin(), invite(), any_time_us()};
}
server::HistoryRow history_row() {
    return {.match = any64(),
            .ended_s = any_time_us(),
            .game = up_to(rules::Game::Practice),
            .names = {{*any_text(kMaxShownNameLength), *any_text(kMaxShownNameLength)}},
            .racks_won = counts(),
            .winner = maybe(seat),
            .shots = any32(),
            .ending = up_to(server::Ending::Abandoned)};
}
void draw(server::HistoryPage& page) {
    page = {some(5, history_row), coin()};
}
void draw(server::PlayerRecord& record) {
    record = {*any_text(kMaxShownNameLength), any32(), any32(), any32(), fine(3000), fine(400)};
}
void draw(server::ReplayChunk& chunk) {
    chunk = {any64(), any64(), any64(), some(5, [] {
                 return some(40, [] { return static_cast<std::byte>(within<int>(0, 256)); });
             })};
}

// The commands that no client says in the same words.

void draw(match::PlaceCueBall& place) {
    place = {position()};
}
void draw(match::TakeShot& take) {
    take = {{any32()}, shot(), call()};
}
void draw(match::Timeout& timeout) {
    timeout = {{any32()}};
}
void draw(match::Forfeit&) {}

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
