// Holds the whole server against seeded evenings of players who come, go, play, break the rules
// and lose their connections, on a disk that is slow, fails, and is killed.
#include "server/table/refold.h"
#include "tests/server/support/game_test.h"

#include <algorithm>
#include <array>
#include <gtest/gtest.h>
#include <map>

namespace billiards::server {
namespace {

struct Person {
    std::string name;
    std::optional<SessionId> session;
    std::optional<protocol::ResumeToken> token;
};

class EveningTest : public MatchTest, public testing::WithParamInterface<std::uint64_t> {
  protected:
    EveningTest() {
        limits.max_tables = 3;
        limits.illegal_messages = 50;
        start();
        disk_is_slow = true;
        for (const char* name : {"Ada", "Grace", "Linus", "Barbara", "Edsger", "Donald"}) {
            people.push_back({.name = name, .session = {}, .token = {}});
        }
    }

    bool happens(int percent) { return static_cast<int>(dice.below(100)) < percent; }

    void step() {
        Person& person = people[dice.below(people.size())];
        if (!person.session || outbox.is_closed(*person.session)) {
            arrive(person);
        } else {
            act(person, *person.session);
        }
        learn_from_answers(person);
        let_the_world_turn();
    }

    void arrive(Person& person) {
        person.session = connect();
        say(*person.session, client::Hello{.name = person.name, .token = person.token});
        if (refusal(*person.session) == RefusedCode::UnknownToken) person.token.reset();
    }

    void learn_from_answers(Person& person) {
        for (const auto& welcome : all<told::Welcome>(*person.session)) {
            person.token = welcome.token;
        }
        for (const auto& snapshot : all<told::TableSnapshot>(*person.session)) {
            newest_table = std::max(newest_table, snapshot.row.table.value);
        }
    }

    void act(Person& person, SessionId session) {
        switch (dice.below(16)) {
            case 0:
                if (!happens(20)) return;
                disconnect(session);
                person.session.reset();
                person.session = connect();
                return;
            case 1:
                return say(session, client::ListTables{});
            case 2:
                return say(session, create());
            case 3:
                return say(session, client::Join{some_table(), some_role()});
            case 4:
                return say(session, client::Leave{});
            case 5:
            case 6:
                return say(session, client::Ready{});
            case 7:
                return say(session, client::Chat{"hello"});
            case 8:
                return say(session, client::Seen{dice.below(40)});
            case 9:
                return say(session, client::Aim{.turn = state(session).turn, .shot = {}});
            case 10:
                return lobby->malformed(now, session, "nonsense");
            case 11:
                if (happens(10)) say(session, client::Concede{});
                return;
            default:
                return play(session);
        }
    }

    void play(SessionId session) {
        const match::MatchState before = state(session);
        if (before.layout.balls.empty()) return say(session, client::TakeShot{});
        if (before.stage == match::Stage::Choosing) {
            return say(session,
                       client::Choose{before.turn, before.pending->verdict.choices.front()});
        }
        if (!before.layout.on_table(model::kCueBall)) {
            say(session,
                client::PlaceCueBall{
                    before.turn, match::default_placement(model::table_of(before.settings.table),
                                                          before.layout, before.rack.in_hand)});
        }
        client::TakeShot shot{
            .turn = before.turn,
            .shot_id = dice.below(6),
            .shot = {.angle_rad = dice.uniform(-3.2, 3.2), .power = dice.uniform(-0.05, 1.05)},
            .call = model::NoCall{}};
        if (before.rack.phase != rules::Phase::Break) shot.call = model::Safety{};
        say(session, shot);
    }

    client::CreateTable create() {
        match::Settings settings;
        settings.race_to = 1;
        settings.shot_clock_s = happens(50) ? 10.0 : 0.0;
        return {.name = "Table", .settings = settings, .role = some_role()};
    }
    /// One of the newest, or one that never was.
    protocol::TableId some_table() {
        return {newest_table + 1 -
                std::min(newest_table, static_cast<std::uint32_t>(dice.below(5)))};
    }
    Role some_role() {
        return std::array{Role::Player, Role::Player, Role::Spectator,
                          Role::BothSeats}[dice.below(4)];
    }

    void let_the_world_turn() {
        while (committer.waiting() > 0 && happens(70)) {
            now += committer.takes;
            if (happens(95)) {
                committer.complete();
            } else {
                committer.fail();
            }
        }
        if (happens(30)) pass(base::Duration{static_cast<std::int64_t>(dice.below(8'000'000))});
    }

    /// A newcomer sees at each table exactly what the disk has of it.
    void expect_that_what_is_shown_is_durable() {
        committer.complete_all();
        const DurableWorld world = committer.durable();
        for (const DurableMatch& live : world.matches) {
            const auto refolded = refold_journal(live.match, live.entries);
            ASSERT_TRUE(refolded.ok()) << refolded.error();
            match::MatchState stored = refolded->state;
            stored.seed = 0;
            const SessionId inspector = greet("Inspector");
            committer.complete_all();
            say(inspector, client::Join{live.match.table, Role::Spectator});
            EXPECT_EQ(last<told::TableSnapshot>(inspector).match, stored);
        }
    }

    /// Whoever was told of a shot was told the same bytes.
    void expect_that_all_saw_the_same_shots() {
        std::map<std::pair<protocol::TableId, std::uint64_t>, protocol::SharedFrame> frames;
        outbox.for_each_session([&](const std::vector<Told>& all_told) {
            protocol::TableId at;
            for (const Told& one : all_told) {
                if (const auto* snapshot = std::get_if<told::TableSnapshot>(&one.message)) {
                    at = snapshot->row.table;
                }
                const auto* played = std::get_if<told::ShotPlayed>(&one.message);
                if (played == nullptr) continue;
                const auto [known, is_new] = frames.try_emplace({at, played->sequence}, one.frame);
                EXPECT_EQ(known->second, one.frame);
            }
        });
        shots_seen += frames.size();
    }

    void kill_and_start_again() {
        expect_that_all_saw_the_same_shots();
        outbox.clear();
        restart();
        EXPECT_TRUE(left_alone.empty()) << left_alone.front();
        for (Person& person : people) person.session.reset();
    }

    base::Random dice{GetParam()};
    std::vector<Person> people;
    std::uint32_t newest_table = 0;
    std::size_t shots_seen = 0;
};

TEST_P(EveningTest, ShowsEveryoneTheSameAndOnlyWhatIsDurable) {
    for (int part = 0; part < 4; ++part) {
        for (int i = 0; i < 500; ++i) step();
        expect_that_what_is_shown_is_durable();
        kill_and_start_again();
    }
    EXPECT_GT(shots_seen, 5U);
}

INSTANTIATE_TEST_SUITE_P(Seeds, EveningTest, testing::Range<std::uint64_t>(0, 20));

}  // namespace
}  // namespace billiards::server
