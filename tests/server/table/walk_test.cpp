// Holds a table against seeded walks: players and spectators who do anything and lose their links
// in the middle of it. In the end each of their clients shows what the table is.
#include "client/app/reduce.h"
#include "server/table/picture.h"
#include "tests/server/support/game_test.h"

#include <array>
#include <gtest/gtest.h>
#include <string>

namespace billiards::server {
namespace {

using ::billiards::client::TableView;
using model::Seat;

/// A client that reads what it is told as the real one does.
struct Person {
    std::string name;
    SessionId session{};
    bool is_connected = false;
    std::size_t read = 0;
    ::billiards::client::ClientState state{};
    std::uint64_t sequence = 0;  ///< Of the last event.
};

class Walk : public MatchTest {
  protected:
    Walk() {
        settings.shot_clock_s = settings.break_shot_clock_s = 90.0;
        settings.race_to = 1;
        committer.takes = 0s;
        limits.absence_grace = 20s;
        limits.lobby_requests_per_10s = 1000;
        start();
    }

    void begin(base::Duration spectators_late, std::uint64_t seed) {
        dice = base::Random(seed);
        settings.spectator_delay_s = base::seconds(spectators_late);
        seat_players(settings);
        const SessionId barbara = greet("Barbara");
        say(barbara, client::Join{table, Role::Spectator});
        const std::array<SessionId, 4> sessions{ada, grace, linus, barbara};
        for (std::size_t i = 0; i < people.size(); ++i) {
            people[i].session = sessions[i];
            people[i].is_connected = true;
        }
        read_all();
    }

    bool happens(std::uint64_t percent) { return dice.below(100) < percent; }

    /// What was said to this one since; every event once, and in its order.
    void read(Person& person) {
        const auto& told = outbox.told(person.session);
        for (; person.read < told.size(); ++person.read) {
            const protocol::ServerMessage& message = told[person.read].message;
            if (const auto sequence = sequence_of(message)) {
                const bool is_snapshot = std::holds_alternative<told::TableSnapshot>(message);
                if (!is_snapshot) {
                    ASSERT_EQ(*sequence, person.sequence + 1) << person.name;
                }
                person.sequence = *sequence;
            }
            person.state = ::billiards::client::reduce(std::move(person.state), message, now);
        }
    }
    void read_all() {
        for (Person& person : people) read(person);
    }

    void lose(Person& person) {
        disconnect(person.session);
        person.is_connected = false;
    }
    void come_back(Person& person) {
        read(person);
        const protocol::ResumeToken token = *person.state.token;
        client::Hello hello{.name = {}, .token = token};
        const auto& view = person.state.table;
        if (view && happens(70)) {
            hello.followed = client::Followed{view->row.table, view->stream, view->sequence};
        }
        person.session = connect();
        person.read = 0;
        person.is_connected = true;
        say(person.session, hello);
        read(person);
        (&person == &people[0] ? ada : &person == &people[1] ? grace : linus) = person.session;
    }

    void act(Person& person) {
        const std::optional<TableView>& view = person.state.table;
        if (!view || view->my_seats.empty()) {
            if (happens(20)) say(person.session, client::Chat{"hello"});
            return;
        }
        if (!view->match || view->match->stage == match::Stage::Over) {
            return say(person.session, client::Ready{});
        }
        const match::MatchState& match = *view->match;
        switch (dice.below(8)) {
            case 0:
                return say(person.session, client::Offer{match.turn, match::OfferKind::Draw});
            case 1:
                return say(person.session, client::Answer{match.turn, happens(10)});
            case 2:
                return say(person.session, client::Extend{match.turn});
            case 3:
                return say(person.session, client::ClaimMatch{});
            case 4:
                if (view->last_shot) say(person.session, client::Seen{view->last_shot->sequence});
                return;
            default:
                return play(person, match);
        }
    }

    void play(Person& person, const match::MatchState& match) {
        if (match.stage == match::Stage::Choosing) {
            const rules::Choice choice = match.pending->verdict.choices.front();
            return say(person.session, client::Choose{match.turn, choice});
        }
        if (!match.layout.on_table(model::kCueBall)) {
            say(person.session,
                client::PlaceCueBall{match.turn,
                                     match::default_placement(model::table_of(match.settings.table),
                                                              match.layout, match.rack.in_hand)});
        }
        client::TakeShot shot{.turn = match.turn,
                              .shot_id = ++shots,
                              .shot = {.angle_rad = 0.01, .power = 0.3},
                              .call = model::NoCall{}};
        if (match.rack.phase != rules::Phase::Break) shot.call = model::Safety{};
        say(person.session, shot);
    }

    void keep_all_alive() {
        for (const Person& person : people) {
            if (person.is_connected) say(person.session, client::Ping{});
        }
    }

    base::Random dice{1};
    match::Settings settings;
    std::array<Person, 4> people{Person{.name = "Ada"}, Person{.name = "Grace"},
                                 Person{.name = "Linus"}, Person{.name = "Barbara"}};
    std::uint64_t shots = 0;
};

class WalkTest : public Walk, public testing::WithParamInterface<std::uint64_t> {};

void expect_same(const TableView& view, const TableView& truth, const std::string& name) {
    EXPECT_EQ(view.sequence, truth.sequence) << name;
    EXPECT_EQ(view.row, truth.row) << name;
    EXPECT_EQ(view.match, truth.match) << name;
    EXPECT_EQ(view.turn, truth.turn) << name;
}

TEST_P(WalkTest, EveryoneShowsTheSameTableInTheEnd) {
    begin(GetParam() % 2 == 0 ? base::Duration{} : 7s, GetParam());
    for (int i = 0; i < 120; ++i) {
        Person& person = people[dice.below(people.size())];
        if (!person.is_connected) {
            come_back(person);
        } else if (happens(15)) {
            lose(person);
        } else {
            act(person);
        }
        keep_all_alive();
        if (happens(60)) pass(base::Duration{static_cast<std::int64_t>(dice.below(6'000'000))});
        read_all();
        if (HasFatalFailure()) return;
    }
    for (Person& person : people) {
        if (!person.is_connected) come_back(person);
    }
    for (int i = 0; i < 6; ++i) {
        keep_all_alive();
        pass(3s);
    }
    read_all();
    const SessionId late = greet("Late");
    say(late, client::Join{table, Role::Spectator});
    const auto seated = [](const Person& person) { return !person.state.table->my_seats.empty(); };
    for (Person& person : people) {
        ASSERT_TRUE(person.state.table.has_value()) << person.name;
        const Person& like = seated(person) ? people[0] : people[3];
        if (seated(person) != seated(like)) continue;
        expect_same(*person.state.table, *like.state.table, person.name);
    }
    EXPECT_EQ(people[3].state.table->match, last<told::TableSnapshot>(late).match);
    EXPECT_EQ(people[3].state.table->turn, last<told::TableSnapshot>(late).turn);
}

INSTANTIATE_TEST_SUITE_P(Seeds, WalkTest, testing::Range<std::uint64_t>(0, 24));

/// Grace always there, and Linus, who sees everything later than she.
class DelayedWalkTest : public Walk, public testing::WithParamInterface<std::uint64_t> {
  protected:
    static constexpr base::Duration kLate = 9s;

    void sample() {
        read_all();
        seen.push_back({now, *people[1].state.table});
        const TableView* earlier = nullptr;
        for (const auto& [when, view] : seen) {
            if (when <= now - kLate) earlier = &view;
        }
        if (earlier != nullptr) expect_later(*people[2].state.table, *earlier);
    }
    static std::int64_t later(std::int64_t time_us) { return time_us + kLate.count(); }
    static told::Turn later(told::Turn turn) {
        turn.opens_us = later(turn.opens_us);
        if (turn.deadline_us) turn.deadline_us = later(*turn.deadline_us);
        return turn;
    }
    void expect_later(const TableView& view, TableView earlier) {
        for (told::SeatView& seat : earlier.row.seats.values) {
            if (seat.claimable_us) seat.claimable_us = later(*seat.claimable_us);
        }
        earlier.turn = earlier.match ? later(earlier.turn) : view.turn;  // Of no match: of no time.
        expect_same(view, earlier, "Linus");
        EXPECT_EQ(view.over, earlier.over);
        ASSERT_EQ(view.last_shot.has_value(), earlier.last_shot.has_value());
        if (!view.last_shot) return;
        EXPECT_EQ(view.last_shot->record, earlier.last_shot->record);
        EXPECT_EQ(view.last_shot->struck_us, later(earlier.last_shot->struck_us));
        EXPECT_EQ(view.last_shot->turn, later(earlier.last_shot->turn));
    }
    void pass_watching(base::Duration duration) {
        const base::Instant end = now + duration;
        for (auto next = lobby->next_deadline(); next && *next <= end;
             next = lobby->next_deadline()) {
            now = std::max(now, *next);
            lobby->advance_time(now);
            commit_all();
            sample();
        }
        now = end;
        sample();
    }

    std::vector<std::pair<base::Instant, TableView>> seen;
};

TEST_P(DelayedWalkTest, ShowsASpectatorWhatAPlayerSawSoMuchEarlier) {
    begin(kLate, GetParam());
    say(ada, client::Ready{});
    say(grace, client::Ready{});
    for (int i = 0; i < 80 && !HasFailure(); ++i) {
        Person& person = people[dice.below(people.size())];
        const bool may_go = person.name == "Ada" || person.name == "Barbara";
        if (!person.is_connected) {
            come_back(person);
        } else if (may_go && happens(15)) {
            lose(person);
        } else {
            act(person);
        }
        keep_all_alive();
        sample();
        pass_watching(base::Duration{static_cast<std::int64_t>(dice.below(5'000'000))});
    }
    EXPECT_GT(shots, 5U);
}

INSTANTIATE_TEST_SUITE_P(Seeds, DelayedWalkTest, testing::Range<std::uint64_t>(100, 116));

}  // namespace
}  // namespace billiards::server
