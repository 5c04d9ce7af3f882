// Holds the lobby against clients who say anything, legal or not, in any order: what each is told,
// what the list says and what may be said next always agree.
#include "tests/server/support/game_test.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <map>
#include <set>

namespace billiards::server {
namespace {

/// One player, with what follows from everything that they were told.
struct Guest {
    std::string given_name;
    std::optional<SessionId> session{};
    std::optional<protocol::ResumeToken> token{};
    std::string name{};
    bool is_welcome = false;
    std::optional<protocol::TableId> at{};
    bool is_seated = false;
    std::set<protocol::TableId> kicked_from{};
    std::size_t heard = 0;
};

class RandomClientsTest : public GameTest, public testing::WithParamInterface<std::uint64_t> {
  protected:
    RandomClientsTest() {
        limits.lobby_requests_per_10s = 1'000'000;
        limits.chat_per_10s = 1'000'000;
        limits.table_chat_per_10s = 1'000'000;
        limits.illegal_messages = 1'000'000;
        limits.max_tables = 5;
        limits.max_spectators_per_table = 2;
        start();
        for (const char* name : {"Ada", "Grace", "Linus", "Barbara", "Edsger", "Donald", "Alan"}) {
            guests.push_back({.given_name = name});
        }
        follower = greet("Follower");
        say(follower, client::FollowTables{});
    }

    bool happens(int percent) { return static_cast<int>(dice.below(100)) < percent; }
    Guest& anyone() { return guests[dice.below(guests.size())]; }

    void step() {
        Guest& guest = anyone();
        if (!guest.session) {
            arrive(guest);
        } else if (happens(6)) {
            disconnect(*guest.session);
            gone(guest);
        } else {
            speak(guest);
        }
        for (Guest& one : guests) listen(one);
        if (happens(20)) pass(base::Duration{static_cast<std::int64_t>(dice.below(4'000'000))});
        for (const Guest& one : guests) {
            if (one.session)
                lobby->received(now, *one.session, {.request_id = 0, .body = client::Ping{}});
        }
        lobby->received(now, follower, {.request_id = 0, .body = client::Ping{}});
        commit_all();
    }

    void gone(Guest& guest) {
        guest.session.reset();
        guest.is_welcome = false;
        guest.at.reset();
        guest.heard = 0;
    }

    void arrive(Guest& guest) {
        guest.session = connect();
        say(*guest.session, client::Hello{.name = guest.given_name, .token = guest.token});
    }

    void speak(Guest& guest) {
        const bool leaves = guest.at && happens(10);
        if (!leaves) return say(*guest.session, some_message(guest));
        say(*guest.session, client::Leave{});
        if (!refusal(*guest.session)) guest.at.reset();
    }

    protocol::ClientMessageBody some_message(const Guest& guest) {
        switch (dice.below(15)) {
            case 0:
                return client::CreateTable{.name = "Table",
                                           .settings = some_settings(),
                                           .role = some_role(),
                                           .is_private = happens(30),
                                           .passcode = some_passcode()};
            case 1:
            case 2:
            case 3:
                return client::Join{.table = some_table(),
                                    .role = some_role(),
                                    .invite = some_invite(),
                                    .passcode = some_passcode()};
            case 4:
                return client::QuickMatch{rules::Game::EightBall};
            case 5:
            case 6:
                return client::Ready{};
            case 7:
                return client::Concede{};
            case 8:
                return client::Kick{some_name(guest)};
            case 9:
                return client::ChangeTable{
                    .settings = some_settings(),
                    .is_private = happens(40),
                    .passcode = happens(50) ? std::optional(some_passcode()) : std::nullopt};
            case 10:
                return client::MakeInvite{happens(50) ? Role::Player : Role::Spectator};
            case 11:
                return happens(30) ? protocol::ClientMessageBody(client::RevokeInvites{})
                                   : client::ListTables{};
            case 12:
                return client::AskReplay{.match = dice.below(3), .first = 0};
            case 13:
                return client::Rematch{};
            default:
                return client::FollowTables{};
        }
    }
    /// Mostly of somebody at the same table.
    std::string some_name(const Guest& guest) {
        for (const Guest& other : guests) {
            if (guest.at && other.at == guest.at && other.name != guest.name && happens(60)) {
                return other.name;
            }
        }
        return anyone().name;
    }
    match::Settings some_settings() {
        match::Settings settings;
        settings.race_to = static_cast<int>(dice.below(3));  // 0 is refused.
        return settings;
    }
    Role some_role() {
        return std::array{Role::Player, Role::Player, Role::Spectator,
                          Role::BothSeats}[dice.below(4)];
    }
    std::string some_passcode() { return std::array{"", "", "cue", "wrong"}[dice.below(4)]; }
    std::optional<protocol::InviteSecret> some_invite() {
        if (invites.empty() || happens(50)) return std::nullopt;
        return invites[dice.below(invites.size())];
    }
    protocol::TableId some_table() {
        return {newest.value + 1 -
                std::min(newest.value, static_cast<std::uint32_t>(dice.below(6)))};
    }

    void listen(Guest& guest) {
        if (!guest.session) return;
        const auto& all_told = outbox.told(*guest.session);
        while (guest.heard < all_told.size()) learn(guest, all_told[guest.heard++].message);
        if (outbox.is_closed(*guest.session)) gone(guest);
    }

    void learn(Guest& guest, const protocol::ServerMessage& message) {
        if (const auto* welcome = std::get_if<told::Welcome>(&message)) {
            guest.token = welcome->token;
            guest.name = welcome->name;
            guest.is_welcome = true;
        } else if (const auto* snapshot = std::get_if<told::TableSnapshot>(&message)) {
            guest.at = snapshot->row.table;
            guest.is_seated = !snapshot->your_seats.empty();
            newest = std::max(newest, snapshot->row.table);
            EXPECT_FALSE(guest.kicked_from.contains(*guest.at)) << "back though kicked";
        } else if (const auto* invite = std::get_if<told::InviteMade>(&message)) {
            invites.push_back(invite->secret);
        } else if (const auto* notice = std::get_if<told::Notice>(&message)) {
            if (notice->code == told::NoticeCode::Kicked) guest.kicked_from.insert(*guest.at);
            kicks += notice->code == told::NoticeCode::Kicked ? 1 : 0;
            guest.at.reset();
        }
    }

    /// What must be true between any two messages.
    void expect_agreement() {
        pass(2s);
        for (Guest& one : guests) listen(one);
        say(follower, client::ListTables{});
        std::map<protocol::TableId, told::TableRow> listed;
        for (const auto& row : last<told::TableList>(follower).tables) listed[row.table] = row;
        EXPECT_EQ(followed(), listed);

        std::size_t connected = 1;
        for (Guest& guest : guests) {
            if (!guest.session) continue;
            ++connected;
            expect_phase(guest);
        }
        EXPECT_EQ(lobby->stats().sessions, connected);
        for (const auto& [id, row] : listed) expect_row(row);
        rows_seen += listed.size();
    }

    void expect_phase(Guest& guest) {
        say(*guest.session, client::Chat{"anybody here?"});
        const bool may_chat = refusal(*guest.session) != RefusedCode::NotInThisPhase;
        EXPECT_EQ(may_chat, guest.at.has_value()) << guest.name;
        say(*guest.session, client::Ready{});
        const bool may_be_ready = refusal(*guest.session) != RefusedCode::NotInThisPhase;
        EXPECT_EQ(may_be_ready, guest.at && guest.is_seated) << guest.name;
        listen(guest);
    }

    /// Whoever the list shows at a table is there, and all who are there are shown.
    void expect_row(const told::TableRow& row) {
        EXPECT_FALSE(row.is_private);
        std::set<std::string> shown;
        for (const model::Seat seat : model::kSeats) {
            if (row.seats[seat].connected) shown.insert(row.seats[seat].name);
        }
        std::set<std::string> seated;
        std::uint32_t watching = 0;
        for (const Guest& guest : guests) {
            if (guest.at != row.table) continue;
            if (guest.is_seated) seated.insert(guest.name);
            watching += guest.is_seated ? 0 : 1;
        }
        EXPECT_EQ(shown, seated) << "table " << row.table.value;
        EXPECT_EQ(row.spectators, watching) << "table " << row.table.value;
    }

    /// The list as the follower knows it, without having asked for it again.
    std::map<protocol::TableId, told::TableRow> followed() {
        std::map<protocol::TableId, told::TableRow> rows;
        for (const auto& change : all<told::TableListChange>(follower)) {
            for (const auto& row : change.changed) rows[row.table] = row;
            for (const auto& table : change.gone) rows.erase(table);
        }
        return rows;
    }

    base::Random dice{GetParam()};
    std::vector<Guest> guests;
    SessionId follower;
    std::vector<protocol::InviteSecret> invites;
    protocol::TableId newest;
    int kicks = 0;
    std::size_t rows_seen = 0;
};

TEST_P(RandomClientsTest, NeverBringTheLobbyInDisagreementWithWhatItTells) {
    for (int part = 0; part < 120; ++part) {
        for (int i = 0; i < 40; ++i) step();
        expect_agreement();
        if (HasFailure()) FAIL() << "in part " << part;
    }
    EXPECT_GT(rows_seen, 60U);
    EXPECT_GT(kicks, 0);
}

INSTANTIATE_TEST_SUITE_P(Seeds, RandomClientsTest, testing::Range<std::uint64_t>(0, 12));

}  // namespace
}  // namespace billiards::server
