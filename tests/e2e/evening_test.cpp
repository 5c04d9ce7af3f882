// A whole evening over real connections: a private table by invite, somebody who watches a second
// late, an opponent who stays away, a match that is claimed, a rematch, and what is told of it all.
#include "client/net/clock.h"
#include "server/server.h"
#include "tests/e2e/guest.h"
#include "tests/support/temporary_folder.h"
#include "tools/player/simple_shot.h"

#include <gtest/gtest.h>
#include <map>
#include <spdlog/logger.h>
#include <spdlog/sinks/null_sink.h>

namespace billiards::e2e {
namespace {

namespace asked = protocol::client;
namespace told = protocol::server;
using protocol::Role;

constexpr double kDelay_s = 1.0;
constexpr std::chrono::seconds kGrace{3};
constexpr std::chrono::milliseconds kClocksDiffer{100};

class Evening : public testing::Test {
  protected:
    Evening() : server(config(), log) {}

    server::ServerConfig config() const {
        server::ServerConfig config;
        config.listen = {{asio::ip::address_v4::loopback(), 0}};
        config.data = folder.path() / "data";
        config.lobby.absence_grace = kGrace;
        return config;
    }
    Guest guest(const std::string& name) {
        return Guest({.host = "127.0.0.1", .port = server.port()}, name);
    }

    /// Ada opens it; Bob plays and Grace watches by their invites.
    void gather() {
        match::Settings settings;
        settings.race_to = 1;
        settings.shot_clock_s = 0.0;
        settings.spectator_delay_s = kDelay_s;
        ada.say(asked::CreateTable{.name = "Friday", .settings = settings, .is_private = true});
        table = ada.hear<told::TableSnapshot>("her table").row.table;
        enter(bob, Role::Player);
        enter(grace, Role::Spectator);
    }
    void enter(Guest& who, Role role) {
        ada.say(asked::MakeInvite{role});
        const auto invite = ada.hear<told::InviteMade>("an invite");
        who.say(asked::Join{.table = table, .role = role, .invite = invite.secret});
        who.hear<told::TableSnapshot>("a place");
    }
    void begin() {
        ada.say(asked::Ready{});
        bob.say(asked::Ready{});
        ada.hear<told::MatchStarted>("the match");
        bob.hear<told::MatchStarted>("the match");
    }
    /// Until both know of so many shots; when each was sent, by its number.
    void play(int shots) {
        while (ada.state().table->match->shots_played < shots) {
            Guest& shooter = client::my_turn(ada.state()) ? ada : bob;
            const match::MatchState before = *shooter.state().table->match;
            act(shooter, before);
            for (Guest* each : {&ada, &bob}) {
                each->wait_until("the next step", [&](const client::ClientState& state) {
                    return *state.table->match != before;
                });
                each->say(asked::Seen{.sequence = each->state().table->sequence});
            }
        }
    }
    void act(Guest& shooter, const match::MatchState& before) {
        const match::Command command = tools::simple_shot(before, random);
        const auto* take = std::get_if<match::TakeShot>(&command);
        const auto* place = std::get_if<match::PlaceCueBall>(&command);
        const auto* choose = std::get_if<match::Choose>(&command);
        if (place != nullptr) {
            shooter.say(asked::PlaceCueBall{before.turn, place->position_m});
        } else if (choose != nullptr) {
            shooter.say(asked::Choose{before.turn, choose->choice});
        } else {
            ASSERT_NE(take, nullptr);
            shooter.wait_until("an open turn", [](const client::ClientState& state) {
                const auto opens = client::local_time_of(state, state.table->turn.opens_us);
                return opens && *opens <= client::local_now();
            });
            sent[before.shots_played + 1] = client::local_now();
            shooter.say(asked::TakeShot{before.turn, random.next(), take->shot, take->call});
        }
    }

    support::TemporaryFolder folder;
    spdlog::logger log{"test", std::make_shared<spdlog::sinks::null_sink_mt>()};
    server::Server server;
    Guest ada = guest("Ada");
    Guest bob = guest("Bob");
    Guest grace = guest("Grace");
    protocol::TableId table;
    base::Random random{5};
    std::map<int, base::Instant> sent;
};

TEST_F(Evening, APrivateMatchIsWatchedLateClaimedPlayedAgainAndKeptForItsPlayers) {
    gather();
    Guest eve = guest("Eve");
    eve.say(asked::Join{.table = table, .role = Role::Spectator});
    EXPECT_EQ(eve.hear<told::Refused>("a refusal").code, protocol::RefusedCode::UnknownTable);

    begin();
    play(3);
    grace.wait_until("the third shot", [](const client::ClientState& state) {
        return state.table->match && state.table->match->shots_played == 3;
    });
    for (const auto& [number, at] : sent) {
        EXPECT_GE(grace.heard_shot_at(number) - at, base::duration_of(kDelay_s)) << number;
    }
    EXPECT_EQ(grace.state().table->match, ada.state().table->match);

    bob.vanish();
    ada.wait_until("the right to claim", [](const client::ClientState& state) {
        const auto& from = state.table->row.seats[model::Seat::Second].claimable_us;
        const auto at = from ? client::local_time_of(state, *from) : std::nullopt;
        return at && *at + kClocksDiffer <= client::local_now();
    });
    ada.say(asked::ClaimMatch{});
    const auto claimed = ada.hear<told::MatchOver>("the end");
    EXPECT_EQ(claimed.ending, told::Ending::Claimed);
    EXPECT_EQ(claimed.winner, model::Seat::First);

    bob.come_back();
    ASSERT_TRUE(bob.state().table->match);
    EXPECT_EQ(bob.state().table->match->stage, match::Stage::Over);
    ada.say(asked::Rematch{});
    bob.say(asked::Rematch{});
    ada.hear<told::MatchStarted>("the rematch");
    play(1);
    bob.say(asked::Concede{});
    EXPECT_EQ(ada.hear<told::MatchOver>("the end").ending, told::Ending::Conceded);
    grace.wait_until("the end", [](const client::ClientState& state) {
        return state.table->over && state.table->over->ending == told::Ending::Conceded;
    });

    ada.say(asked::AskHistory{});
    EXPECT_EQ(ada.hear<told::HistoryPage>("the history").rows.size(), 2U);
    eve.say(asked::AskHistory{});
    EXPECT_TRUE(eve.hear<told::HistoryPage>("the history").rows.empty());
    ada.say(asked::AskRecord{});
    EXPECT_EQ(ada.hear<told::PlayerRecord>("her record").wins, 2U);
}

}  // namespace
}  // namespace billiards::e2e
