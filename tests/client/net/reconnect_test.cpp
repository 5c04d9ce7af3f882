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

TEST(Reconnect, OnlyALinkThatStoodStartsTheCountAgain) {
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

Reconnect with_shot() {
    Reconnect reconnect = welcomed();
    reconnect.sent(take_shot());
    return reconnect;
}

TEST(UnansweredShot, IsKeptAsItWas) {
    Reconnect reconnect = with_shot();
    reconnect.sent({.request_id = 13, .body = protocol::client::Chat{"hello"}});
    reconnect.lost(LostCode::Closed, kNow);
    reconnect.received(welcome(protocol::TableId{7}), kNow);
    EXPECT_EQ(reconnect.unanswered_shot(), take_shot());
}

TEST(UnansweredShot, ANewOneTakesThePlaceOfTheOld) {
    Reconnect reconnect = with_shot();
    protocol::ClientMessage next = take_shot();
    std::get<protocol::client::TakeShot>(next.body).shot_id = 78;
    reconnect.sent(next);
    EXPECT_EQ(reconnect.unanswered_shot(), next);
}

struct Answer {
    const char* name;
    protocol::ServerMessage message;
    bool ends_waiting;
};

TEST(UnansweredShot, IsAnsweredByWhatNamesIt) {
    server::TableSnapshot rolling = told::snapshot(4, {}, std::nullopt);
    rolling.rolling = told::shot(4, {}, 77);
    const std::vector<Answer> answers{
        {"its result", told::shot(4, {}, 77), true},
        {"another's result", told::shot(4, {}, 78), false},
        {"its refusal", told::refused(protocol::RefusedCode::TooEarly, 12), true},
        {"another's refusal", told::refused(protocol::RefusedCode::TooEarly, 13), false},
        {"a snapshot that shows it rolling", rolling, true},
        {"a snapshot", told::snapshot(4, {}, std::nullopt), false},
        {"the end of the match", server::MatchOver{}, true},
        {"the end of the table", told::notice(server::NoticeCode::TableClosed), true},
        {"a welcome that names no table", welcome(), true},
        {"a welcome that names the table", welcome(protocol::TableId{7}), false},
        {"a pong", server::Pong{}, false}};
    for (const Answer& answer : answers) {
        Reconnect reconnect = with_shot();
        reconnect.received(answer.message, kNow);
        EXPECT_EQ(!reconnect.unanswered_shot().has_value(), answer.ends_waiting) << answer.name;
    }
}

}  // namespace
}  // namespace billiards::client
