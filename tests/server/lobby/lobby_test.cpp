// Holds the lobby: tables are opened, listed, joined, left and tidied, within limits.
#include "tests/server/support/game_test.h"

#include <gtest/gtest.h>

namespace billiards::server {
namespace {

class LobbyTest : public MatchTest {
  protected:
    protocol::TableId open_table(SessionId session, Role role = Role::Player) {
        say(session, client::CreateTable{.name = "Friday", .settings = {}, .role = role});
        return last<told::TableSnapshot>(session).row.table;
    }
    std::vector<told::TableRow> rows() {
        const SessionId session = greet("Reader");
        say(session, client::ListTables{});
        return last<told::TableList>(session).tables;
    }
};

TEST_F(LobbyTest, AnswersWhoOpensATableWithItsSnapshot) {
    const SessionId ada_session = greet("Ada");
    match::Settings settings;
    settings.race_to = 7;
    say(ada_session, client::CreateTable{.name = " Friday ", .settings = settings});
    const auto snapshot = last<told::TableSnapshot>(ada_session);
    EXPECT_EQ(snapshot.row.name, "Friday");
    EXPECT_EQ(snapshot.row.settings, settings);
    EXPECT_EQ(snapshot.your_seats, std::vector{model::Seat::First});
    EXPECT_EQ(snapshot.match, std::nullopt);
    EXPECT_FALSE(snapshot.row.playing);
    EXPECT_TRUE(snapshot.row.seats[model::Seat::First].connected);
    EXPECT_FALSE(snapshot.row.seats[model::Seat::Second].taken);
}

TEST_F(LobbyTest, ListsTheNewestTableFirst) {
    const auto first = open_table(greet("Ada"));
    const auto second = open_table(greet("Grace"));
    const auto listed = rows();
    ASSERT_EQ(listed.size(), 2U);
    EXPECT_EQ(listed[0].table, second);
    EXPECT_EQ(listed[1].table, first);
}

TEST_F(LobbyTest, SharesOneListFrameAmongThoseWhoAskTogether) {
    open_table(greet("Ada"));
    const SessionId one = greet("One");
    const SessionId two = greet("Two");
    say(one, client::ListTables{});
    say(two, client::ListTables{});
    EXPECT_EQ(outbox.frames<told::TableList>(one), outbox.frames<told::TableList>(two));
    pass(limits.table_list_kept + 1us);
    say(two, client::ListTables{});
    EXPECT_NE(outbox.frames<told::TableList>(one).back(),
              outbox.frames<told::TableList>(two).back());
}

TEST_F(LobbyTest, ListsWhatWasOpenedAMomentAgo) {
    EXPECT_TRUE(rows().empty());
    open_table(greet("Ada"));
    EXPECT_EQ(rows().size(), 1U);
}

TEST_F(LobbyTest, RefusesSettingsThatMakeNoMatch) {
    const SessionId session = greet("Ada");
    match::Settings settings;
    settings.race_to = match::kMaxRaceTo + 1;
    say(session, client::CreateTable{.name = "Friday", .settings = settings});
    EXPECT_EQ(match_refusal(session), match::RefusalCode::BadSettings);
    EXPECT_EQ(lobby->stats().tables, 0U);
}

TEST_F(LobbyTest, RefusesATableNameThatIsNoText) {
    const SessionId session = greet("Ada");
    say(session, client::CreateTable{.name = "a\x07", .settings = {}});
    EXPECT_EQ(refusal(session), RefusedCode::BadName);
}

TEST_F(LobbyTest, NamesATableWithoutANameAfterWhoOpenedIt) {
    const SessionId session = greet("Ada");
    say(session, client::CreateTable{});
    EXPECT_EQ(last<told::TableSnapshot>(session).row.name, last<told::Welcome>(session).name);
}

TEST_F(LobbyTest, TellsThoseAtATableWhoSatDown) {
    seat_players();
    const auto changed = last<told::SeatChanged>(ada);
    EXPECT_EQ(changed.seats[model::Seat::Second].name, last<told::Welcome>(grace).name);
    EXPECT_EQ(last<told::TableSnapshot>(grace).your_seats, std::vector{model::Seat::Second});
    EXPECT_TRUE(last<told::TableSnapshot>(linus).your_seats.empty());
}

TEST_F(LobbyTest, RefusesAThirdPlayerAndBothSeatsWhereOneIsTaken) {
    seat_players();
    const SessionId third = greet("Third");
    say(third, client::Join{table, Role::Player});
    EXPECT_EQ(refusal(third), RefusedCode::SeatTaken);
    const auto half_full = open_table(greet("Alone"));
    say(third, client::Join{half_full, Role::BothSeats});
    EXPECT_EQ(refusal(third), RefusedCode::SeatTaken);
}

TEST_F(LobbyTest, RefusesATableThatIsNotThere) {
    const SessionId session = greet("Ada");
    say(session, client::Join{{77}, Role::Player});
    EXPECT_EQ(refusal(session), RefusedCode::UnknownTable);
}

TEST_F(LobbyTest, KeepsASessionAtOneTable) {
    seat_players();
    say(ada, client::CreateTable{});
    EXPECT_EQ(refusal(ada), RefusedCode::NotInThisPhase);
    say(linus, client::Join{table, Role::Player});
    EXPECT_EQ(refusal(linus), RefusedCode::NotInThisPhase);
}

TEST_F(LobbyTest, BringsWhoLeavesBackToTheLobbyWithTheListOfTables) {
    seat_players();
    say(linus, client::ListTables{});
    say(grace, client::Leave{});
    ASSERT_EQ(last<told::TableList>(grace).tables.size(), 1U);
    EXPECT_FALSE(last<told::TableList>(grace).tables[0].seats[model::Seat::Second].taken);
    EXPECT_FALSE(last<told::SeatChanged>(ada).seats[model::Seat::Second].taken);
    say(grace, client::Join{table, Role::Player});
    EXPECT_EQ(last<told::TableSnapshot>(grace).your_seats, std::vector{model::Seat::Second});
}

TEST_F(LobbyTest, RefusesSpectatorsBeyondTheLimit) {
    limits.max_spectators_per_table = 1;
    start();
    seat_players();
    const SessionId one_more = greet("More");
    say(one_more, client::Join{table, Role::Spectator});
    EXPECT_EQ(refusal(one_more), RefusedCode::TableFull);
}

TEST_F(LobbyTest, CountsSpectatorsOnceASecondHoweverManyCome) {
    seat_players();
    pass(2s);
    outbox.clear();
    for (int i = 0; i < 50; ++i) say(greet("Fan"), client::Join{table, Role::Spectator});
    EXPECT_EQ(count<told::SeatChanged>(ada), 0U);
    pass(1s);
    ASSERT_EQ(count<told::SeatChanged>(ada), 1U);
    EXPECT_EQ(last<told::SeatChanged>(ada).spectators, 51U);
    pass(10s);
    EXPECT_EQ(count<told::SeatChanged>(ada), 1U);
}

TEST_F(LobbyTest, CountsSpectatorsInTimeThoughMoreKeepComing) {
    seat_players();
    pass(2s);
    outbox.clear();
    for (int i = 0; i < 3; ++i) {
        say(greet("Fan"), client::Join{table, Role::Spectator});
        pass(limits.spectator_count_every / 2);
    }
    EXPECT_EQ(count<told::SeatChanged>(ada), 1U);
}

TEST_F(LobbyTest, GivesNewcomersTheSnapshotFirstAndNothingTwice) {
    seat_players();
    for (const SessionId session : {ada, grace, linus}) {
        const auto& all_told = outbox.told(session);
        ASSERT_GE(all_told.size(), 2U);
        EXPECT_TRUE(std::holds_alternative<told::Welcome>(all_told[0].message));
        EXPECT_TRUE(std::holds_alternative<told::TableSnapshot>(all_told[1].message));
    }
    EXPECT_EQ(count<told::SeatChanged>(grace), 0U);
}

TEST_F(LobbyTest, RefusesTablesBeyondTheLimit) {
    limits.max_tables = 1;
    start();
    open_table(greet("Ada"));
    const SessionId session = greet("Grace");
    say(session, client::CreateTable{});
    EXPECT_EQ(refusal(session), RefusedCode::TooMany);
}

TEST_F(LobbyTest, RefusesTablesBeyondTheLimitOfAnAddressUntilOneOfThemIsClosed) {
    limits.tables_per_address = 2;
    start();
    const auto greet_from = [this](AddressKey from) {
        const SessionId session = connect(from);
        say(session, client::Hello{.name = "Ada", .token = {}});
        return session;
    };
    const SessionId first = greet_from(7);
    open_table(first);
    open_table(greet_from(7));
    const SessionId third = greet_from(7);
    say(third, client::CreateTable{});
    EXPECT_EQ(refusal(third), RefusedCode::TooMany);
    open_table(greet_from(8));
    for (int i = 0; i < 4; ++i) open_table(greet("Nobody's neighbour"));
    say(first, client::Leave{});
    open_table(first);
    disconnect(first);
    pass(limits.empty_table_kept);
    open_table(greet_from(7));
}

TEST_F(LobbyTest, LeavesNoTableToSpectatorsWhoAreNotThereHoweverLateTheyWouldSeeIt) {
    const SessionId session = greet("Ada");
    match::Settings late;
    late.spectator_delay_s = 600;
    for (int i = 0; i < 3; ++i) {
        say(session, client::CreateTable{.name = {}, .settings = late});
        say(session, client::Leave{});
    }
    EXPECT_EQ(lobby->stats().tables, 1U);
}

TEST_F(LobbyTest, ClosesTheEmptyTableOfWhoOpensAnother) {
    const SessionId session = greet("Ada");
    const auto first = open_table(session);
    const SessionId watching = greet("Linus");
    say(watching, client::Join{first, Role::Spectator});
    say(session, client::Leave{});
    const auto second = open_table(session);
    EXPECT_NE(second, first);
    EXPECT_EQ(lobby->stats().tables, 1U);
    EXPECT_EQ(last<told::Notice>(watching).code, told::NoticeCode::TableClosed);
    say(watching, client::Join{second, Role::Spectator});
    EXPECT_EQ(last<told::TableSnapshot>(watching).row.table, second);
}

TEST_F(LobbyTest, LeavesATableToThoseWhoStillSitAtIt) {
    seat_players();
    say(ada, client::Leave{});
    open_table(ada);
    EXPECT_EQ(lobby->stats().tables, 2U);
}

TEST_F(LobbyTest, LeavesATableToAMatchWhosePlayersAreAway) {
    const SessionId opener = greet("Opener");
    table = open_table(opener);
    say(opener, client::Leave{});
    ada = greet("Ada");
    grace = greet("Grace");
    for (const SessionId session : {ada, grace}) {
        say(session, client::Join{table, Role::Player});
        say(session, client::Ready{});
    }
    disconnect(ada);
    disconnect(grace);
    open_table(opener);
    EXPECT_EQ(lobby->stats().tables, 2U);
    EXPECT_EQ(lobby->stats().matches_running, 1U);
}

TEST_F(LobbyTest, ListsAClosedTableNoMore) {
    limits.empty_table_kept = 1s;
    start();
    const SessionId session = greet("Ada");
    open_table(session);
    say(session, client::Leave{});
    pass(1s - limits.table_list_kept / 2);
    say(session, client::ListTables{});
    EXPECT_EQ(last<told::TableList>(session).tables.size(), 1U);
    pass(limits.table_list_kept / 2);
    say(session, client::ListTables{});
    EXPECT_TRUE(last<told::TableList>(session).tables.empty());
}

TEST_F(LobbyTest, TidiesATableAtWhichNobodyPlaysAfterAWhile) {
    committer.takes = 0s;
    const SessionId session = greet("Ada");
    open_table(session);
    say(session, client::Leave{});
    disconnect(session);
    pass(limits.empty_table_kept - 1us);
    EXPECT_EQ(lobby->stats().tables, 1U);
    pass(1us);
    EXPECT_EQ(lobby->stats().tables, 0U);
    EXPECT_EQ(lobby->next_deadline(), std::nullopt);
}

TEST_F(LobbyTest, GivesTheSeatOfAnAbsentPlayerAwayBeforeAMatch) {
    seat_players();
    disconnect(grace);
    const SessionId barbara = greet("Barbara");
    say(barbara, client::Join{table, Role::Player});
    EXPECT_EQ(last<told::TableSnapshot>(barbara).your_seats, std::vector{model::Seat::Second});

    const SessionId again = come_back(token_of(grace));
    EXPECT_EQ(last<told::Welcome>(again).table, table);
    EXPECT_TRUE(last<told::TableSnapshot>(again).your_seats.empty());
    say(again, client::Ready{});
    EXPECT_EQ(refusal(again), RefusedCode::NotInThisPhase);
}

TEST_F(LobbyTest, ShowsChatToEveryoneAtTheTableCleanedAndNamed) {
    seat_players();
    say(linus, client::Chat{"  well played "});
    const told::ChatSaid expected{.name = last<told::Welcome>(linus).name, .text = "well played"};
    EXPECT_EQ(last<told::ChatSaid>(ada), expected);
    EXPECT_EQ(last<told::ChatSaid>(grace), expected);
    EXPECT_EQ(outbox.frames<told::ChatSaid>(ada), outbox.frames<told::ChatSaid>(linus));
}

TEST_F(LobbyTest, RefusesChatThatIsNoText) {
    seat_players();
    for (const char* text : {"", "  ", "\x1b[31m", "\xc3"}) {
        say(ada, client::Chat{text});
        EXPECT_EQ(refusal(ada), RefusedCode::Malformed) << text;
    }
    EXPECT_EQ(count<told::ChatSaid>(grace), 0U);
}

TEST_F(LobbyTest, LimitsAPlayersChatToItsRate) {
    seat_players();
    for (int i = 0; i < limits.chat_per_10s + 1; ++i) say(ada, client::Chat{"again"});
    EXPECT_EQ(refusal(ada), RefusedCode::TooMany);
    EXPECT_EQ(count<told::ChatSaid>(grace), static_cast<std::size_t>(limits.chat_per_10s));
    pass(10s);
    say(ada, client::Chat{"again"});
    EXPECT_EQ(refusal(ada), std::nullopt);
}

TEST_F(LobbyTest, LimitsTheChatOfAWholeTableToItsRate) {
    limits.table_chat_per_10s = 3;
    start();
    seat_players();
    for (int i = 0; i < 2; ++i) {
        say(ada, client::Chat{"one"});
        say(grace, client::Chat{"two"});
    }
    EXPECT_EQ(refusal(grace), RefusedCode::TooMany);
    EXPECT_EQ(count<told::ChatSaid>(linus), 3U);
}

TEST_F(LobbyTest, LetsThePlayersTalkHoweverLoudTheSpectatorsAre) {
    limits.table_chat_per_10s = 3;
    start();
    seat_players();
    for (int i = 0; i < 4; ++i) say(linus, client::Chat{"come on"});
    EXPECT_EQ(refusal(linus), RefusedCode::TooMany);
    say(ada, client::Chat{"well played"});
    EXPECT_EQ(refusal(ada), std::nullopt);
}

TEST_F(LobbyTest, LimitsWhatASessionAsksOfTheLobby) {
    const SessionId session = greet("Ada");
    for (int i = 0; i < limits.lobby_requests_per_10s; ++i) say(session, client::ListTables{});
    EXPECT_EQ(refusal(session), std::nullopt);
    say(session, client::ListTables{});
    EXPECT_EQ(refusal(session), RefusedCode::TooMany);
    pass(10s);
    say(session, client::ListTables{});
    EXPECT_EQ(refusal(session), std::nullopt);
}

TEST_F(LobbyTest, ClosesWhoKeepsSayingWhatHasNoPlace) {
    const SessionId session = greet("Ada");
    for (int i = 0; i < limits.illegal_messages; ++i) say(session, client::Ready{});
    EXPECT_TRUE(outbox.is_closed(session));
    EXPECT_EQ(lobby->stats().sessions, 0U);
    EXPECT_EQ(lobby->stats().refusals, static_cast<std::uint64_t>(limits.illegal_messages));
}

}  // namespace
}  // namespace billiards::server
