// Plays on a real server through a screen's hands; gives whether everything a person does arrives,
// and everything that happens is shown.
#include "client/play/game.h"

#include "client/net/clock.h"
#include "tests/client/app/told.h"
#include "tests/client/net/fake_server.h"
#include "tests/support/chaos_proxy.h"
#include "tests/tools/test_server.h"

#include <chrono>
#include <functional>
#include <gtest/gtest.h>
#include <string>
#include <thread>
#include <vector>

namespace billiards::client {
namespace {

using model::Seat;

protocol::client::CreateTable a_table(protocol::Role role) {
    protocol::client::CreateTable table;
    table.name = "Ours";
    table.role = role;
    table.settings.race_to = 1;
    return table;
}

class GameTest : public testing::Test {
  protected:
    /// Draws frames of all screens until the condition holds; false: it never did.
    bool until(const std::vector<Game*>& screens, const std::function<bool()>& condition) {
        const base::Instant limit = local_now() + std::chrono::seconds(20);
        while (local_now() < limit) {
            for (Game* screen : screens) screen->advance(local_now());
            if (condition()) return true;
            std::this_thread::yield();
        }
        return false;
    }

    /// Two players at one screen, before their first break.
    void sit_down(Game& here) {
        here.connect(server_.address(), "Ada", OpenTable{a_table(protocol::Role::BothSeats)});
        ASSERT_TRUE(until({&here}, [&] { return here.known().table.has_value(); }));
        here.ready();
        ASSERT_TRUE(until({&here}, [&] { return here.acting().has_value(); }));
    }

    tools::TestServer server_;
};

TEST_F(GameTest, TwoPlayersAtOneScreenBreakAndPlayOn) {
    Game here(1);
    sit_down(here);
    ASSERT_TRUE(here.placing());
    here.shot().set_power(0.9);
    here.shoot();
    ASSERT_TRUE(until({&here}, [&] { return here.presentation().rolling() != nullptr; }));
    EXPECT_FALSE(here.acting()) << "nobody acts while the balls roll";
    here.skip_roll();
    ASSERT_TRUE(until({&here}, [&] { return here.acting().has_value(); }));
    EXPECT_EQ(here.known().table->match->shots_played, 1);
    EXPECT_EQ(here.presentation().lines().size(), 1U);
}

TEST_F(GameTest, TheCueBallIsSetDownWhereItWasMoved) {
    Game here(1);
    sit_down(here);
    here.hold_cue_ball_at({-0.8, 0.1});
    here.move_cue_ball({0.0, kNudge_m});
    EXPECT_EQ(here.cue_ball_m(), base::Vec2(-0.8, 0.101));
    here.set_down();
    ASSERT_TRUE(until({&here}, [&] { return here.placing()->is_down(); }));
    EXPECT_EQ(here.known().table->match->layout.find(model::kCueBall)->position_m,
              base::Vec2(-0.8, 0.101));
}

TEST_F(GameTest, AnIllegalPlaceIsRefusedBeforeItIsSent) {
    Game here(1);
    sit_down(here);
    here.hold_cue_ball_at({0.3, 0.0});
    here.shoot();
    EXPECT_FALSE(here.refusal().empty());
    EXPECT_TRUE(here.acting()) << "nothing was sent";
}

TEST_F(GameTest, TwoScreensAndAWatcherSeeTheSameShot) {
    Game ada(1);
    Game grace(2);
    Game mary(3);
    const std::vector<Game*> all{&ada, &grace, &mary};
    ada.connect(server_.address(), "Ada", OpenTable{a_table(protocol::Role::Player)});
    ASSERT_TRUE(until(all, [&] { return ada.known().table.has_value(); }));
    const protocol::TableId table = ada.known().table->row.table;
    mary.connect(server_.address(), "Mary", GoToTable{{table, protocol::Role::Spectator}});
    grace.connect(server_.address(), "Grace", GoToTable{{table, protocol::Role::Player}});
    ASSERT_TRUE(until(
        all, [&] { return grace.known().table.has_value() && mary.known().table.has_value(); }));
    ada.ready();
    grace.ready();
    ASSERT_TRUE(until(all, [&] { return ada.acting() || grace.acting(); }));
    Game& breaker = ada.acting() ? ada : grace;
    breaker.shot().set_power(1.0);
    breaker.shoot();
    const auto all_saw = [&] {
        return ada.known().table->last_shot && grace.known().table->last_shot &&
               mary.known().table->last_shot;
    };
    ASSERT_TRUE(until(all, all_saw));
    EXPECT_EQ(ada.known().table->last_shot, grace.known().table->last_shot);
    EXPECT_EQ(ada.known().table->last_shot, mary.known().table->last_shot);
    EXPECT_FALSE(mary.acting());
}

TEST_F(GameTest, AWatcherSeesWhereThePlayerAims) {
    Game here(1);
    Game mary(3);
    sit_down(here);
    const protocol::TableId table = here.known().table->row.table;
    mary.connect(server_.address(), "Mary", GoToTable{{table, protocol::Role::Spectator}});
    ASSERT_TRUE(until({&here, &mary}, [&] { return mary.known().table.has_value(); }));
    here.shot().set_angle(0.25);
    ASSERT_TRUE(until({&here, &mary}, [&] {
        const auto& aim = mary.known().table->aim;
        return aim && aim->shot.angle_rad == 0.25;
    }));
}

TEST_F(GameTest, AServerThatIsNotThereIsToldInWords) {
    Game here(1);
    here.connect({.host = "127.0.0.1", .port = 1}, "Ada", LookAround{});
    ASSERT_TRUE(until({&here}, [&] { return !here.lost().empty(); }));
    EXPECT_FALSE(here.is_coming_back());
}

TEST_F(GameTest, AServerThatClosesTheLinkIsQuotedOnWhy) {
    FakeServer server([](FakeServer& self) {
        Peer peer = self.accept();
        peer.exchange_preambles();
        peer.read();
        peer.write(protocol::server::Refused{
            .code = protocol::RefusedCode::BadName, .match_code = {}, .detail = "name: 0 of 24"});
    });
    Game here(1);
    here.connect(server.address(), "Ada", LookAround{});
    ASSERT_TRUE(until({&here}, [&] { return !here.lost().empty(); }));
    EXPECT_EQ(here.lost(), "this name cannot be used: it is empty, too long or no text");
    server.finish();
}

TEST_F(GameTest, BytesThatAreNoMessageAreToldWithoutWhatWasWrongWithThem) {
    FakeServer server([](FakeServer& self) {
        Peer peer = self.accept();
        peer.exchange_preambles();
        peer.read();
        peer.write(std::string(8, '\x01'));
        peer.wait_until_closed();
    });
    Game here(1);
    here.connect(server.address(), "Ada", LookAround{});
    ASSERT_TRUE(until({&here}, [&] { return !here.lost().empty(); }));
    EXPECT_EQ(here.lost(), "the server sent what this program does not understand");
    here.disconnect();
    server.finish();
}

/// Ada is at the table and may shoot; what the server does then.
FakeServer::Script at_a_table(const std::function<void(Peer&)>& then) {
    return [then](FakeServer& self) {
        Peer peer = self.accept();
        peer.exchange_preambles();
        peer.read_a<protocol::client::Hello>();
        peer.write(told::welcome());
        peer.write(told::snapshot(1, {Seat::First}, told::match_at(3, Seat::First)));
        then(peer);
        peer.wait_until_closed();
    };
}

TEST_F(GameTest, ARefusalThatNamesNothingEndsTheWaitingForAShot) {
    FakeServer server(at_a_table([](Peer& peer) {
        peer.read_a<protocol::client::TakeShot>();
        peer.write(protocol::server::Refused{.code = protocol::RefusedCode::Malformed,
                                             .match_code = {},
                                             .detail = "shot: no number"});
    }));
    Game here(1);
    here.connect(server.address(), "Ada", LookAround{});
    ASSERT_TRUE(until({&here}, [&] { return here.acting().has_value(); }));
    here.shoot();
    EXPECT_FALSE(here.acting());
    EXPECT_TRUE(until({&here}, [&] { return here.acting().has_value(); }));
    EXPECT_EQ(here.refusal(), "the server did not understand what was asked of it");
    here.disconnect();
    server.finish();
}

TEST_F(GameTest, TheServerIsAskedToSpotTheNearestBallOfThisTurn) {
    FakeServer server(at_a_table([](Peer& peer) {
        EXPECT_EQ(peer.read_a<protocol::client::SpotNearest>().turn, model::TurnNumber{3});
        peer.write(protocol::server::Refused{.code = protocol::RefusedCode::Match,
                                             .match_code = match::RefusalCode::NotSpottable,
                                             .detail = ""});
    }));
    Game here(1);
    here.connect(server.address(), "Ada", LookAround{});
    ASSERT_TRUE(until({&here}, [&] { return here.acting().has_value(); }));
    here.spot_nearest();
    EXPECT_TRUE(until({&here}, [&] { return here.refusal() == "no ball is spotted now"; }));
    here.disconnect();
    server.finish();
}

TEST_F(GameTest, ATableThatWasClosedIsToldSo) {
    FakeServer server(at_a_table([](Peer& peer) {
        peer.write(protocol::server::Notice{.code = protocol::server::NoticeCode::TableClosed,
                                            .detail = ""});
    }));
    Game here(1);
    here.connect(server.address(), "Ada", LookAround{});
    EXPECT_TRUE(until({&here}, [&] {
        return here.refusal() == "the table is closed: nobody had been there for too long";
    }));
    EXPECT_FALSE(here.known().table);
    here.disconnect();
    server.finish();
}

TEST_F(GameTest, ReadyIsSaidAgainOnceTheTableIsChanged) {
    Game ada(1);
    Game grace(2);
    ada.connect(server_.address(), "Ada", OpenTable{a_table(protocol::Role::Player)});
    ASSERT_TRUE(until({&ada}, [&] { return ada.known().table.has_value(); }));
    grace.connect(server_.address(), "Grace", GoToTable{{.table = ada.known().table->row.table}});
    ASSERT_TRUE(until({&ada, &grace}, [&] { return grace.known().table.has_value(); }));
    grace.ready();
    EXPECT_TRUE(grace.has_asked_to_start());
    ASSERT_TRUE(
        until({&ada, &grace}, [&] { return ada.known().table->row.seats[Seat::Second].ready; }));
    EXPECT_TRUE(grace.has_asked_to_start());
    protocol::client::ChangeTable change;
    change.settings = ada.known().table->row.settings;
    change.settings.race_to = 2;
    ada.change_table(change);
    EXPECT_TRUE(until({&ada, &grace}, [&] { return !grace.has_asked_to_start(); }));
}

TEST_F(GameTest, TheLobbyListsTheTables) {
    Game here(1);
    Game mary(3);
    sit_down(here);
    mary.connect(server_.address(), "Mary", LookAround{});
    ASSERT_TRUE(until({&here, &mary}, [&] { return !mary.known().tables.empty(); }));
    mary.join({.table = mary.known().tables.front().table, .role = protocol::Role::Spectator});
    EXPECT_TRUE(until({&here, &mary}, [&] { return mary.known().table.has_value(); }));
}

TEST_F(GameTest, WhoWasReadyBeforeTheLinkWasLostIsAskedAgain) {
    support::ChaosProxy proxy({asio::ip::address_v4::loopback(), server_.address().port}, {}, 1);
    Game ada(1);
    ada.connect({.host = "127.0.0.1", .port = proxy.port()}, "Ada",
                OpenTable{a_table(protocol::Role::Player)});
    ASSERT_TRUE(until({&ada}, [&] { return ada.known().table.has_value(); }));
    const auto is_ready = [&] { return ada.known().table->row.seats[Seat::First].ready; };
    ada.ready();
    ASSERT_TRUE(until({&ada}, is_ready));
    proxy.reset_all();
    ASSERT_TRUE(until({&ada}, [&] { return !ada.is_connected(); }));
    ASSERT_TRUE(until({&ada}, [&] { return ada.is_connected() && !ada.known().is_table_stale; }));
    EXPECT_FALSE(is_ready());
    EXPECT_FALSE(ada.has_asked_to_start());
    ada.ready();
    EXPECT_TRUE(until({&ada}, is_ready));
}

TEST_F(GameTest, AScreenComesBackToItsTableWhenTheServerStartsAgain) {
    Game here(1);
    sit_down(here);
    here.shot().set_power(0.9);
    here.shoot();
    ASSERT_TRUE(until({&here}, [&] { return here.presentation().rolling() != nullptr; }));
    server_.restart();
    ASSERT_TRUE(until({&here}, [&] { return !here.is_connected(); }));
    EXPECT_TRUE(here.is_coming_back());
    ASSERT_TRUE(until({&here}, [&] {
        here.skip_roll();
        return here.acting().has_value();
    }));
    EXPECT_EQ(here.known().table->match->shots_played, 1);
}

}  // namespace
}  // namespace billiards::client
