// Gives a whole server without sockets, disk or clock, and clients that talk to it in sentences.
#pragma once

#include "common/base/random.h"
#include "common/match/match_state.h"
#include "common/match/placement.h"
#include "common/model/table_spec.h"
#include "server/lobby/lobby.h"
#include "tests/server/support/manual_archive.h"
#include "tests/server/support/manual_committer.h"
#include "tests/server/support/recording_outbox.h"

#include <chrono>
#include <cstdint>
#include <gtest/gtest.h>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace billiards::server {

namespace client = protocol::client;
namespace told = protocol::server;
using namespace std::chrono_literals;
using protocol::RefusedCode;
using protocol::Role;

/// Of what has one: everything that a table tells all who are there, but chat and aims.
inline std::optional<std::uint64_t> sequence_of(const protocol::ServerMessage& message) {
    return std::visit(
        []<class Body>(const Body& body) -> std::optional<std::uint64_t> {
            if constexpr (requires { body.sequence; }) return body.sequence;
            return std::nullopt;
        },
        message);
}

class GameTest : public testing::Test {
  protected:
    GameTest() { start(); }

    /// A server on what is durable; everybody is disconnected.
    void restart() {
        lobby.reset();
        committer.kill();
        archive.kill();
        const DurableWorld world = committer.durable();
        start();
        left_alone = lobby->restore(now, world.stored());
    }

    SessionId connect(AddressKey from = {}) {
        const SessionId session{++last_session};
        lobby->connected(now, session, from);
        return session;
    }
    /// What waits for the disk is durable afterwards, but where `disk_is_slow`.
    void say(SessionId session, protocol::ClientMessageBody body) {
        lobby->received(now, session, {.request_id = ++last_request, .body = std::move(body)});
        if (!disk_is_slow) commit_all();
    }
    void disconnect(SessionId session) { lobby->disconnected(now, session); }
    /// Time passes as the game loop lets it pass: deadline by deadline.
    void pass(base::Duration duration) {
        const base::Instant end = now + duration;
        for (auto next = lobby->next_deadline(); next && *next <= end;
             next = lobby->next_deadline()) {
            now = std::max(now, *next);
            lobby->advance_time(now);
            if (!disk_is_slow) commit_all();
        }
        now = std::max(now, end);
    }

    /// Each commit takes its time.
    void commit_all() {
        while (committer.waiting() > 0) {
            now += committer.takes;
            committer.complete();
        }
    }

    template <class Message>
    std::vector<Message> all(SessionId session) {
        return outbox.all<Message>(session);
    }
    template <class Message>
    std::size_t count(SessionId session) {
        return outbox.all<Message>(session).size();
    }
    /// The newest of its kind; the test fails where there is none.
    template <class Message>
    Message last(SessionId session) {
        auto messages = outbox.all<Message>(session);
        if (messages.empty()) {
            ADD_FAILURE() << "session " << session.value << " was told no such thing";
            return {};
        }
        return std::move(messages.back());
    }
    /// What the last message of this session was refused for.
    std::optional<RefusedCode> refusal(SessionId session) {
        for (const told::Refused& refused : all<told::Refused>(session)) {
            if (refused.in_reply_to == last_request) return refused.code;
        }
        return std::nullopt;
    }
    std::optional<match::RefusalCode> match_refusal(SessionId session) {
        for (const told::Refused& refused : all<told::Refused>(session)) {
            if (refused.in_reply_to == last_request) return refused.match_code;
        }
        return std::nullopt;
    }

    SessionId greet(const std::string& name) {
        const SessionId session = connect();
        say(session, client::Hello{.name = name, .token = {}});
        return session;
    }
    SessionId come_back(const protocol::ResumeToken& token) {
        const SessionId session = connect();
        say(session, client::Hello{.name = {}, .token = token});
        return session;
    }
    protocol::ResumeToken token_of(SessionId session) { return last<told::Welcome>(session).token; }

    LobbyLimits limits;
    base::Instant now{};
    RecordingOutbox outbox;
    ManualCommitter committer;
    ManualArchive archive;
    std::unique_ptr<Lobby> lobby;
    std::vector<std::string> left_alone;
    bool disk_is_slow = false;

    void start() {
        lobby = std::make_unique<Lobby>(limits, outbox, committer, archive, [this](auto bytes) {
            for (std::uint8_t& byte : bytes) byte = static_cast<std::uint8_t>(random.next());
        });
    }

  private:
    base::Random random{2024};
    std::uint64_t last_session = 0;
    std::uint32_t last_request = 0;
};

/// Ada and Grace at one table, Linus watching.
class MatchTest : public GameTest {
  protected:
    void seat_players(const match::Settings& settings = {}) {
        ada = greet("Ada");
        grace = greet("Grace");
        linus = greet("Linus");
        say(ada, client::CreateTable{.name = "Friday", .settings = settings, .role = Role::Player});
        table = last<told::TableSnapshot>(ada).row.table;
        say(grace, client::Join{table, Role::Player});
        say(linus, client::Join{table, Role::Spectator});
    }
    void start_match(const match::Settings& settings = {}) {
        seat_players(settings);
        say(ada, client::Ready{});
        say(grace, client::Ready{});
    }

    /// The match as the newest message to this session has it.
    match::MatchState state(SessionId session) {
        match::MatchState state;
        for (const Told& one : outbox.told(session)) {
            if (const auto* snapshot = std::get_if<told::TableSnapshot>(&one.message)) {
                if (snapshot->match) state = *snapshot->match;
            } else if (const auto* started = std::get_if<told::MatchStarted>(&one.message)) {
                state = started->state;
            } else if (const auto* played = std::get_if<told::ShotPlayed>(&one.message)) {
                state = played->after;
            } else if (const auto* moved = std::get_if<told::MatchMoved>(&one.message)) {
                state = moved->after;
            } else if (const auto* placed = std::get_if<told::CueBallPlaced>(&one.message)) {
                state.layout.find(model::kCueBall)->place = model::Place::OnTable;
                state.layout.find(model::kCueBall)->position_m = placed->position_m;
            }
        }
        return state;
    }
    match::MatchState state() { return state(linus); }

    SessionId session_of(model::Seat seat) { return seat == model::Seat::First ? ada : grace; }
    SessionId shooter() { return session_of(state().to_act); }
    SessionId other() { return session_of(opponent_of(state().to_act)); }

    base::Vec2 free_place() {
        const match::MatchState before = state();
        return match::default_placement(model::table_of(before.settings.table), before.layout,
                                        before.rack.in_hand);
    }
    void place_cue_ball() { say(shooter(), client::PlaceCueBall{state().turn, free_place()}); }
    /// A shot that is legal now, at the balls: the break, else a safety.
    client::TakeShot shot(std::uint64_t shot_id) {
        const match::MatchState before = state();
        client::TakeShot shot{.turn = before.turn,
                              .shot_id = shot_id,
                              .shot = {.angle_rad = 0.01, .power = 0.6},
                              .call = model::NoCall{}};
        if (before.rack.phase != rules::Phase::Break) shot.call = model::Safety{};
        return shot;
    }
    /// Whoever is to act does: chooses what is offered first, or sets the cue ball down and shoots.
    void take_turn(std::uint64_t shot_id) {
        if (state().stage == match::Stage::Choosing) {
            say(shooter(), client::Choose{state().turn, state().pending->verdict.choices.front()});
        }
        if (!state().layout.on_table(model::kCueBall)) place_cue_ball();
        say(shooter(), shot(shot_id));
    }
    /// The balls come to rest.
    void let_rest() {
        keep_alive();
        pass(base::Instant{base::Duration{last<told::ShotPlayed>(linus).turn.opens_us}} - now);
    }

    void keep_alive() {
        for (const SessionId session : {ada, grace, linus}) say(session, client::Ping{});
    }

    SessionId ada;
    SessionId grace;
    SessionId linus;
    protocol::TableId table;
};

}  // namespace billiards::server
