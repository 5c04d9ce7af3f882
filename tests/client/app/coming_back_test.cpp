// Holds what a client knows against lost links, changes of lists, and people it does not want to
// hear.
#include "client/app/reduce.h"
#include "tests/client/app/told.h"

#include <gtest/gtest.h>
#include <initializer_list>
#include <string>

namespace billiards::client {
namespace {

namespace server = protocol::server;
using model::Seat;
using told::kNow;
using told::match_at;
using told::shot;
using told::snapshot;
using told::welcome;

ClientState after(std::initializer_list<protocol::ServerMessage> messages, ClientState state = {}) {
    for (const protocol::ServerMessage& message : messages) {
        state = reduce(std::move(state), message, kNow);
    }
    return state;
}

server::Resumed resumed(std::vector<Seat> mine, std::uint32_t table = 7) {
    return {.table = {table}, .your_seats = std::move(mine), .server_time_us = 0};
}

/// At table 7, to act in turn 3.
ClientState playing() {
    return after({welcome(), snapshot(4, {Seat::First}, match_at(3, Seat::First, 2))});
}

TEST(ComingBack, ToATableThatIsAsItWasKeepsEverythingThatIsKnown) {
    const ClientState before = playing();
    const ClientState lost = with_link_lost(before);
    EXPECT_EQ(lost.link, LinkState::Lost);
    EXPECT_TRUE(lost.is_table_stale);
    EXPECT_FALSE(my_turn(lost));
    const ClientState greeted = after({welcome(protocol::TableId{7})}, lost);
    EXPECT_TRUE(greeted.is_table_stale) << "whether anything was missed is not known yet";
    EXPECT_FALSE(my_turn(greeted));
    const ClientState back = after({resumed({Seat::First})}, greeted);
    EXPECT_EQ(back.link, LinkState::Ready);
    EXPECT_FALSE(back.is_table_stale);
    EXPECT_EQ(back.table, before.table);
    EXPECT_EQ(my_turn(back), Seat::First);
}

TEST(ComingBack, WhatWasMissedFollowsAsIfItHadNeverBeenAway) {
    const auto missed = shot(5, match_at(4, Seat::Second, 3));
    const ClientState stayed = after({missed}, playing());
    const ClientState back = after({welcome(protocol::TableId{7}), resumed({Seat::First}), missed},
                                   with_link_lost(playing()));
    EXPECT_EQ(back.table, stayed.table);
}

TEST(ComingBack, ToASnapshotOfAnotherStreamBeginsAnew) {
    server::TableSnapshot restarted = snapshot(1, {Seat::First}, match_at(3, Seat::First, 2));
    restarted.stream = 99;
    const ClientState back =
        after({welcome(protocol::TableId{7}), restarted}, with_link_lost(playing()));
    EXPECT_FALSE(back.is_table_stale);
    EXPECT_EQ(back.table->stream, 99U);
    EXPECT_EQ(back.table->sequence, 1U);
    EXPECT_EQ(after({shot(2, match_at(4, Seat::Second, 3))}, back).table->match->turn.value, 4U);
}

TEST(ComingBack, ResumedSaysWhichSeatsAreOnesOwn) {
    EXPECT_EQ(after({resumed({Seat::Second})}, playing()).table->my_seats,
              std::vector{Seat::Second});
}

TEST(ComingBack, WhoeverWasAwayIsNotReadyAnyMore) {
    server::TableSnapshot ready = snapshot(1, {Seat::First}, std::nullopt);
    for (const Seat seat : model::kSeats) ready.row.seats[seat].ready = true;
    const ClientState back = after({resumed({Seat::First})},
                                   with_link_lost(after({welcome(protocol::TableId{7}), ready})));
    EXPECT_FALSE(back.table->row.seats[Seat::First].ready);
    EXPECT_TRUE(back.table->row.seats[Seat::Second].ready);
}

TEST(ComingBack, ResumedAtAnotherTableThanTheKnownOneChangesNothingOfIt) {
    const ClientState lost = with_link_lost(playing());
    EXPECT_TRUE(after({resumed({Seat::Second}, 8)}, lost).is_table_stale);
    EXPECT_FALSE(after({resumed({Seat::Second})}).table);
}

TEST(ComingBack, WithoutATableNothingIsStale) {
    EXPECT_FALSE(with_link_lost(after({welcome()})).is_table_stale);
    EXPECT_FALSE(after({welcome()}, with_link_lost(playing())).is_table_stale);
}

TEST(ComingBack, ASnapshotOfAMatchThatIsOverSaysHowItEnded) {
    match::MatchState ended = match_at(9, Seat::First, 8);
    ended.stage = match::Stage::Over;
    ended.winner = Seat::Second;
    ended.racks_won = {{1, 2}};
    const ClientState told = after({snapshot(1, {}, ended)});
    ASSERT_TRUE(told.table->over);
    EXPECT_EQ(told.table->over->winner, Seat::Second);
    EXPECT_EQ(told.table->over->racks_won, ended.racks_won);
    EXPECT_EQ(told.table->over->shots, 8U);
}

TEST(ComingBack, ASnapshotOfAMatchWhoseEndIsKnownKeepsIt) {
    server::MatchOver claimed = told::over(5, Seat::First);
    claimed.ending = server::Ending::Claimed;
    const ClientState over = after({claimed}, playing());
    EXPECT_EQ(after({snapshot(5, {}, *over.table->match)}, over).table->over, claimed);
}

TEST(ComingBack, WhoeverIsShownTheLobbyHasLeftTheTable) {
    EXPECT_FALSE(after({server::TableList{}}, playing()).table);
    EXPECT_FALSE(after({told::notice(server::NoticeCode::Kicked)}, playing()).table);
}

TEST(ComingBack, AChangedTableIsShownAsItIsNow) {
    server::TableChanged changed{.sequence = 5, .row = playing().table->row};
    changed.row.settings.race_to = 9;
    EXPECT_EQ(after({changed}, playing()).table->row, changed.row);
    changed.sequence = 3;
    EXPECT_EQ(after({changed}, playing()), playing()) << "it is old";
}

server::TableRow row(std::uint32_t table, const char* name) {
    server::TableRow row;
    row.table = {table};
    row.name = name;
    return row;
}

std::vector<std::string> names(const ClientState& state) {
    std::vector<std::string> names;
    for (const server::TableRow& each : state.tables) names.push_back(each.name);
    return names;
}

TEST(TableList, FollowsItsChanges) {
    const ClientState listed =
        after({server::TableList{{row(3, "three"), row(2, "two"), row(1, "one")}}});
    const server::TableListChange change{.changed = {row(2, "two again"), row(4, "four")},
                                         .gone = {{3}, {77}}};
    EXPECT_EQ(names(after({change}, listed)),
              (std::vector<std::string>{"four", "two again", "one"}));
}

TEST(TableList, KeepsOnlySoManyRows) {
    ClientState state;
    for (std::uint32_t table = 1; table <= kTablesKept + 5; ++table) {
        state = after({server::TableListChange{.changed = {row(table, "")}, .gone = {}}}, state);
    }
    EXPECT_EQ(state.tables.size(), kTablesKept);
}

TEST(Answers, AreKeptUntilTheNext) {
    const server::InviteMade invite{
        .table = {7}, .is_for_playing = true, .secret = {}, .expires_us = 4};
    server::HistoryPage history;
    history.rows.emplace_back().match = 3;
    server::PlayerRecord record;
    record.name = "Ada#12ab";
    const ClientState state = after({invite, history, record});
    EXPECT_EQ(state.last_invite, invite);
    EXPECT_EQ(state.last_history, history);
    EXPECT_EQ(state.last_record, record);
}

server::ChatSaid line_of(const char* name) {
    return {.name = name, .text = "hello"};
}

TEST(Muted, PeopleAreNotHeard) {
    ClientState state = after({line_of("Eve#0001"), line_of("Ada#12ab")});
    state = with_muted(state, "Eve#0001");
    EXPECT_TRUE(is_muted(state, "Eve#0001"));
    state = after({line_of("Eve#0001"), welcome(), line_of("Eve#0002")}, state);
    EXPECT_EQ(state.chat, (std::vector<ChatLine>{{"Ada#12ab", "hello"}, {"Eve#0002", "hello"}}));
    state = after({line_of("Eve#0001")}, with_unmuted(state, "Eve#0001"));
    EXPECT_EQ(state.chat.back(), (ChatLine{"Eve#0001", "hello"}));
    EXPECT_FALSE(is_muted(state, "Eve#0001"));
}

TEST(Muted, AreOnlySoMany) {
    ClientState state;
    for (std::size_t i = 0; i < kMutedKept + 1; ++i) state = with_muted(state, std::to_string(i));
    EXPECT_EQ(state.muted.size(), kMutedKept);
    EXPECT_FALSE(is_muted(state, "0"));
    state = with_muted(state, "1");
    EXPECT_EQ(state.muted.size(), kMutedKept) << "once each";
    EXPECT_EQ(state.muted.back(), "1");
    EXPECT_EQ(with_muted(state, ""), state);
}

}  // namespace
}  // namespace billiards::client
