// Holds the policy of coming back against losses, tokens and answers.
#include "client/net/reconnect.h"

#include "tests/client/app/told.h"

#include <gtest/gtest.h>
#include <vector>

namespace billiards::client {
namespace {

namespace server = protocol::server;
using std::chrono::seconds;
using told::kNow;
using told::welcome;

constexpr ReconnectLimits kLimits{};

Reconnect welcomed(std::uint64_t seed = 1) {
    Reconnect reconnect("Ada", std::nullopt, seed);
    reconnect.received(welcome(protocol::TableId{7}), kNow);
    return reconnect;
}

std::vector<base::Duration> delays(Reconnect& reconnect, int count) {
    std::vector<base::Duration> delays;
    for (int i = 0; i < count; ++i) {
        const auto delay = reconnect.lost(LostCode::Closed, kNow);
        if (delay) delays.push_back(*delay);
    }
    return delays;
}

TEST(Reconnect, ALinkLostBeforeTheFirstWelcomeIsFinal) {
    Reconnect reconnect("Ada", std::nullopt, 1);
    EXPECT_FALSE(reconnect.lost(LostCode::ConnectionRefused, kNow));
}

TEST(Reconnect, DelaysDoubleUpToTheirLimitAndAreSpread) {
    Reconnect reconnect = welcomed();
    base::Duration full = kLimits.first_delay;
    for (const base::Duration delay : delays(reconnect, 10)) {
        EXPECT_GE(delay, full / 2);
        EXPECT_LE(delay, full);
        full = std::min(2 * full, kLimits.max_delay);
    }
}

TEST(Reconnect, TwoClientsDoNotComeBackTogether) {
    Reconnect one = welcomed(1);
    Reconnect other = welcomed(2);
    Reconnect same = welcomed(1);
    const auto delays_of_one = delays(one, 5);
    EXPECT_NE(delays_of_one, delays(other, 5));
    EXPECT_EQ(delays_of_one, delays(same, 5));
}

TEST(Reconnect, GivesUpAfterSoManyAttempts) {
    Reconnect reconnect = welcomed();
    EXPECT_EQ(delays(reconnect, kLimits.max_attempts + 3).size(),
              static_cast<std::size_t>(kLimits.max_attempts));
}

TEST(Reconnect, NeverGivesUpAServerThatWelcomesItAgainAndAgain) {
    Reconnect reconnect = welcomed();
    for (int i = 0; i < 3 * kLimits.max_attempts; ++i) {
        ASSERT_TRUE(reconnect.lost(LostCode::Closed, kNow)) << i;
        reconnect.received(welcome(protocol::TableId{7}), kNow);
    }
}

TEST(Reconnect, OnlyALinkThatStoodStartsTheDelaysAgain) {
    Reconnect reconnect = welcomed();
    delays(reconnect, 6);
    reconnect.received(welcome(), kNow);
    EXPECT_GT(reconnect.lost(LostCode::Closed, kNow + seconds(1)), kLimits.first_delay);
    reconnect.received(welcome(), kNow);
    EXPECT_LE(reconnect.lost(LostCode::Closed, kNow + kLimits.stood), kLimits.first_delay);
}

TEST(Reconnect, WhatNoWaitingMendsIsFinal) {
    for (const LostCode code : {LostCode::OtherVersion, LostCode::NotAServer}) {
        Reconnect reconnect = welcomed();
        EXPECT_FALSE(reconnect.lost(code, kNow));
    }
    for (const LostCode code : {LostCode::UnknownHost, LostCode::ConnectionRefused,
                                LostCode::Unreachable, LostCode::NoAnswer, LostCode::Closed}) {
        Reconnect reconnect = welcomed();
        EXPECT_TRUE(reconnect.lost(code, kNow));
    }
}

TEST(Reconnect, AnUnknownTokenIsFinal) {
    Reconnect reconnect = welcomed();
    reconnect.received(told::refused(protocol::RefusedCode::UnknownToken, 0), kNow);
    EXPECT_FALSE(reconnect.lost(LostCode::Closed, kNow));
}

TEST(Reconnect, WhoeverWasReplacedDoesNotFightBack) {
    Reconnect reconnect = welcomed();
    reconnect.received(told::notice(server::NoticeCode::ReplacedByNewConnection), kNow);
    EXPECT_FALSE(reconnect.lost(LostCode::Closed, kNow));
}

TEST(Reconnect, AServerThatShutsDownIsTriedAgain) {
    Reconnect reconnect = welcomed();
    reconnect.received(told::notice(server::NoticeCode::ShuttingDown), kNow);
    EXPECT_TRUE(reconnect.lost(LostCode::Closed, kNow));
}

TEST(Reconnect, GreetsWithTheNewestToken) {
    Reconnect reconnect("Ada", protocol::ResumeToken{9}, 1);
    EXPECT_EQ(reconnect.hello().name, "Ada");
    EXPECT_EQ(reconnect.hello().token, protocol::ResumeToken{9});
    reconnect.received(welcome(), kNow);
    EXPECT_EQ(reconnect.hello().token, welcome().token);
}

protocol::ClientMessage take_shot() {
    return {.request_id = 12,
            .body = protocol::client::TakeShot{.turn = {3}, .shot_id = 77, .shot = {}, .call = {}}};
}

/// On a link that stands, at a table that is known.
Reconnect at_table() {
    Reconnect reconnect = welcomed();
    reconnect.received(told::snapshot(3, {}, std::nullopt), kNow);
    reconnect.take_repeats();
    return reconnect;
}

server::TableSnapshot snapshot_of(std::uint64_t stream, std::uint64_t sequence) {
    server::TableSnapshot snapshot = told::snapshot(sequence, {}, std::nullopt);
    snapshot.stream = stream;
    return snapshot;
}

TEST(Reconnect, SaysHowFarItHasFollowedItsTable) {
    Reconnect reconnect = welcomed();
    EXPECT_FALSE(reconnect.hello().followed);
    reconnect.received(snapshot_of(99, 4), kNow);
    const auto followed = [&] { return reconnect.hello().followed; };
    using Followed = protocol::client::Followed;
    EXPECT_EQ(followed(), (Followed{.table = {7}, .stream = 99, .sequence = 4}));
    reconnect.received(told::shot(6, {}), kNow);
    EXPECT_EQ(followed()->sequence, 6U);
    reconnect.received(told::shot(5, {}), kNow);
    EXPECT_EQ(followed()->sequence, 6U) << "an answer that is repeated is old";
    reconnect.received(server::Resumed{.table = {7}, .your_seats = {}, .server_time_us = 0}, kNow);
    reconnect.received(told::over(7, model::Seat::First), kNow);
    EXPECT_EQ(followed()->sequence, 7U);
    reconnect.received(snapshot_of(100, 1), kNow);
    EXPECT_EQ(followed(), (Followed{.table = {7}, .stream = 100, .sequence = 1}));
    reconnect.received(welcome(), kNow);
    EXPECT_FALSE(followed()) << "it has no place there any more";
}

TEST(Reconnect, SaysAgainWhatWasNotAnsweredOnceTheTableIsKnown) {
    const std::vector<protocol::ServerMessage> shown{
        told::snapshot(4, {}, told::match_at(3, model::Seat::First)),
        server::Resumed{.table = {7}, .your_seats = {}, .server_time_us = 0}};
    for (const protocol::ServerMessage& message : shown) {
        Reconnect reconnect = at_table();
        EXPECT_TRUE(reconnect.sent(take_shot()));
        EXPECT_TRUE(reconnect.sent({.request_id = 13, .body = protocol::client::Chat{"hello"}}));
        reconnect.lost(LostCode::Closed, kNow);
        reconnect.received(welcome(protocol::TableId{7}), kNow);
        EXPECT_TRUE(reconnect.take_repeats().empty()) << "how the table stands is not known yet";
        reconnect.received(message, kNow);
        EXPECT_EQ(reconnect.take_repeats(), std::vector{take_shot()});
        EXPECT_TRUE(reconnect.take_repeats().empty());
        reconnect.received(message, kNow);
        EXPECT_TRUE(reconnect.take_repeats().empty()) << "once a link";
    }
}

TEST(Reconnect, KeepsForTheTableWhatIsSaidBeforeItIsKnown) {
    Reconnect reconnect = at_table();
    reconnect.lost(LostCode::Closed, kNow);
    reconnect.received(welcome(protocol::TableId{7}), kNow);
    EXPECT_FALSE(reconnect.sent(take_shot()));
    EXPECT_TRUE(reconnect.sent({.request_id = 13, .body = protocol::client::Chat{"hello"}}));
    reconnect.received(told::snapshot(4, {}, std::nullopt), kNow);
    EXPECT_EQ(reconnect.take_repeats(), std::vector{take_shot()});
}

TEST(Reconnect, SaysNothingAgainWhereItsPlaceIsGone) {
    Reconnect reconnect = at_table();
    reconnect.sent(take_shot());
    reconnect.lost(LostCode::Closed, kNow);
    reconnect.received(welcome(), kNow);
    reconnect.received(told::snapshot(4, {}, std::nullopt), kNow);
    EXPECT_TRUE(reconnect.take_repeats().empty());
}

}  // namespace
}  // namespace billiards::client
