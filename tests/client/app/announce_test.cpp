// Holds the sentences around a match, and those of refusals, against one case a sentence.
#include "client/app/announce.h"

#include "client/app/refusal.h"
#include "tests/client/app/told.h"

#include <gtest/gtest.h>
#include <set>
#include <string>

namespace billiards::client {
namespace {

namespace server = protocol::server;
using model::Seat;

/// Ada and Grace, both here.
TableView table() {
    TableView table;
    table.row = told::snapshot(1, {}, std::nullopt).row;
    for (server::SeatView& seat : table.row.seats.values) seat.taken = seat.connected = true;
    return table;
}

std::string told_of(void (*change)(server::SeatView& first, server::SeatView& second)) {
    const TableView before = table();
    server::SeatChanged changed{.sequence = 2, .seats = before.row.seats, .spectators = 3};
    change(changed.seats[Seat::First], changed.seats[Seat::Second]);
    return tell(before, changed);
}

TEST(Announce, WhoComesAndGoes) {
    EXPECT_EQ(told_of([](auto&, auto&) {}), "");
    EXPECT_EQ(told_of([](auto&, auto& grace) { grace.connected = false; }), "Grace#3f21 is away");
    EXPECT_EQ(told_of([](auto&, auto& grace) { grace = {}; }), "Grace#3f21 has left");
    EXPECT_EQ(told_of([](auto& ada, auto& grace) { ada.ready = true, grace.connected = false; }),
              "Ada#12ab is ready; Grace#3f21 is away");
    EXPECT_EQ(told_of([](auto&, auto& grace) { grace.name = "Eve#0001"; }),
              "Grace#3f21 has left; Eve#0001 sits down");
}

TEST(Announce, WhoSitsDownAndComesBack) {
    TableView before = table();
    const server::SeatChanged changed{.sequence = 2, .seats = before.row.seats, .spectators = 0};
    before.row.seats[Seat::First].connected = false;
    before.row.seats[Seat::Second] = {};
    EXPECT_EQ(tell(before, changed), "Ada#12ab is back; Grace#3f21 sits down");
}

TEST(Announce, WhoHasBothSeatsOnce) {
    TableView before = table();
    before.row.seats[Seat::Second].name = "Ada#12ab";
    server::SeatChanged changed{.sequence = 2, .seats = before.row.seats, .spectators = 0};
    for (server::SeatView& seat : changed.seats.values) seat.connected = false;
    EXPECT_EQ(tell(before, changed), "Ada#12ab is away");
}

TEST(Announce, WhatTheOwnerChanged) {
    const TableView before = table();
    server::TableChanged changed{.sequence = 2, .row = before.row};
    EXPECT_EQ(tell(before, changed), "the table is as it was");
    changed.row.settings.game = rules::Game::NineBall;
    changed.row.settings.race_to = 5;
    changed.row.is_private = true;
    EXPECT_EQ(tell(before, changed),
              "the table is changed: 9-ball, race to 5, 45 s a shot; only for invited people");
}

TEST(Announce, SettingsInWords) {
    match::Settings settings;
    settings.game = rules::Game::StraightPool;
    settings.shot_clock_s = 0.0;
    EXPECT_EQ(words(settings), "straight pool, 100 points, no clock");
    settings.game = rules::Game::Practice;
    EXPECT_EQ(words(settings), "practice");
}

TEST(Announce, WhenAMatchMayBeClaimed) {
    TableView view = table();
    EXPECT_EQ(absence_of(view, Seat::Second, 0), "");
    view.row.seats[Seat::Second].connected = false;
    EXPECT_EQ(absence_of(view, Seat::Second, 0), "") << "between two matches nothing is claimed";
    view.row.seats[Seat::Second].claimable_us = 50'000'000;
    EXPECT_EQ(absence_of(view, Seat::Second, 7'500'000),
              "Grace is away: you may claim the match in 43 s");
    EXPECT_EQ(absence_of(view, Seat::Second, 50'000'000),
              "Grace is away: you may claim the match, or wait");
}

TEST(Announce, WhatAnInviteIsGoodFor) {
    server::InviteMade invite{
        .table = {7}, .is_for_playing = true, .secret = {}, .expires_us = 86'400'000'000};
    EXPECT_EQ(tell(invite, 0), "this invite lets one person play; it is good for 24 h");
    invite.is_for_playing = false;
    EXPECT_EQ(tell(invite, 85'800'000'000),
              "this invite lets everybody who has it watch; it is good for 10 min");
}

server::HistoryRow played(std::optional<Seat> winner, server::Ending ending) {
    server::HistoryRow row;
    row.names = {{"Ada#12ab", "Grace#3f21"}};
    row.racks_won = {{1, 3}};
    row.winner = winner;
    row.ending = ending;
    return row;
}

TEST(Announce, WhatWasPlayed) {
    EXPECT_EQ(tell(played(Seat::Second, server::Ending::Played)),
              "8-ball: Grace#3f21 beat Ada#12ab 3-1");
    EXPECT_EQ(tell(played(std::nullopt, server::Ending::Played)),
              "8-ball: Ada#12ab drew with Grace#3f21 1-3");
    EXPECT_EQ(tell(played(std::nullopt, server::Ending::Abandoned)),
              "8-ball: Ada#12ab against Grace#3f21 was abandoned at 1-3");
}

TEST(Announce, APlayersRecord) {
    server::PlayerRecord record{
        .name = "Ada#12ab", .games = 5, .wins = 3, .draws = 0, .rating = 1511.6, .deviation = 60.2};
    EXPECT_EQ(tell(record), "Ada#12ab: 3 of 5 matches won; rating 1512 (+/- 120)");
    record.draws = 1;
    EXPECT_EQ(tell(record), "Ada#12ab: 3 of 5 matches won, 1 drawn; rating 1512 (+/- 120)");
}

TEST(Announce, ChatWithWhoSaysIt) {
    EXPECT_EQ(tell(ChatLine{.name = "Ada#12ab", .text = "good luck"}), "Ada#12ab: good luck");
}

TEST(Announce, EveryNoticeInItsOwnWords) {
    std::set<std::string> sentences;
    for (const auto code :
         {server::NoticeCode::ShuttingDown, server::NoticeCode::TableClosed,
          server::NoticeCode::ReplacedByNewConnection, server::NoticeCode::Kicked}) {
        sentences.insert(tell(told::notice(code)));
    }
    EXPECT_EQ(sentences.size(), 4U);
    EXPECT_FALSE(sentences.contains(""));
}

TEST(Refusal, EveryCodeHasASentenceOfItsOwn) {
    std::set<std::string> sentences;
    constexpr auto kLast = static_cast<int>(protocol::RefusedCode::Busy);
    for (int code = 0; code <= kLast; ++code) {
        server::Refused refused = told::refused(static_cast<protocol::RefusedCode>(code), 0);
        refused.match_code = match::RefusalCode::NotYourTurn;
        sentences.insert(words(refused));
    }
    EXPECT_EQ(sentences.size(), static_cast<std::size_t>(kLast) + 1);
    EXPECT_FALSE(sentences.contains(""));
}

TEST(Refusal, EveryCodeOfAMatchHasASentence) {
    constexpr auto kLast = static_cast<int>(match::RefusalCode::NothingToUndo);
    for (int code = 0; code <= kLast; ++code) {
        server::Refused refused = told::refused(protocol::RefusedCode::Match, 0);
        refused.match_code = static_cast<match::RefusalCode>(code);
        EXPECT_NE(words(refused), "") << code;
    }
}

TEST(Refusal, SaysWhatTheServerAddsWhereItSaysMore) {
    server::Refused refused = told::refused(protocol::RefusedCode::TooMany, 0);
    refused.detail = "chat at this table";
    EXPECT_EQ(words(refused), "too much or too often: chat at this table");
    refused.code = protocol::RefusedCode::NotAllowed;
    refused.detail = "your opponent is here";
    EXPECT_EQ(words(refused), "your opponent is here");
    refused.code = protocol::RefusedCode::WrongSecret;
    EXPECT_EQ(words(refused), "this invite or passcode does not open the table, or no longer");
    refused.code = protocol::RefusedCode::Match;
    refused.match_code = match::RefusalCode::NoExtension;
    refused.detail = "this rack's extension has been used";
    EXPECT_EQ(words(refused), "there is no extension: this rack's extension has been used");
}

}  // namespace
}  // namespace billiards::client
