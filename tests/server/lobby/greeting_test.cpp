// Holds how players are known: names, tokens, and what a lost connection may and may not do.
#include "tests/server/support/game_test.h"

#include <gtest/gtest.h>
#include <set>
#include <string>

namespace billiards::server {
namespace {

class GreetingTest : public GameTest {};

TEST_F(GreetingTest, GivesANameWithADiscriminatorAndAToken) {
    const SessionId ada = greet("  Ada ");
    const auto welcome = last<told::Welcome>(ada);
    EXPECT_EQ(welcome.name.substr(0, 4), "Ada#");
    EXPECT_EQ(welcome.name.size(), 8U);
    EXPECT_EQ(welcome.name.find_first_not_of("0123456789abcdef", 4), std::string::npos);
    EXPECT_NE(welcome.token, protocol::ResumeToken{});
    EXPECT_EQ(welcome.table, std::nullopt);
}

TEST_F(GreetingTest, GivesNoTwoPlayersTheSameName) {
    std::set<std::string> names;
    for (int i = 0; i < 1000; ++i) names.insert(last<told::Welcome>(greet("Ada")).name);
    EXPECT_EQ(names.size(), 1000U);
}

TEST_F(GreetingTest, GivesNoNameOfAPlayerFromBeforeARestart) {
    std::set<std::string> names;
    for (int i = 0; i < 500; ++i) names.insert(last<told::Welcome>(greet("Ada")).name);
    restart();
    for (int i = 0; i < 500; ++i) names.insert(last<told::Welcome>(greet("Ada")).name);
    EXPECT_EQ(names.size(), 1000U);
}

TEST_F(GreetingTest, WelcomesOnlyOnceThePlayerIsDurable) {
    disk_is_slow = true;
    const SessionId ada = greet("Ada");
    EXPECT_EQ(count<told::Welcome>(ada), 0U);
    committer.complete();
    EXPECT_EQ(count<told::Welcome>(ada), 1U);
    EXPECT_EQ(committer.durable().players.front().token_hash, hash_of(token_of(ada)));
}

TEST_F(GreetingTest, RefusesNamesThatAreNone) {
    for (const char* name : {"", "   ", "a\x01", "\xff\xfe", "abcdefghijklmnopqrstuvwxyz"}) {
        const SessionId session = greet(name);
        EXPECT_EQ(refusal(session), RefusedCode::BadName) << name;
    }
}

TEST_F(GreetingTest, LetsWhoWasRefusedSayHelloAgain) {
    const SessionId session = greet("");
    say(session, client::Hello{.name = "Ada", .token = {}});
    EXPECT_EQ(count<told::Welcome>(session), 1U);
}

TEST_F(GreetingTest, RefusesEverythingElseBeforeHello) {
    const SessionId session = connect();
    say(session, client::ListTables{});
    EXPECT_EQ(refusal(session), RefusedCode::NotInThisPhase);
}

TEST_F(GreetingTest, RefusesHelloAgainWhileTheFirstIsOnItsWayToTheDisk) {
    disk_is_slow = true;
    const SessionId session = greet("Ada");
    say(session, client::Hello{.name = "Ada", .token = {}});
    EXPECT_EQ(refusal(session), RefusedCode::NotInThisPhase);
    EXPECT_EQ(committer.waiting(), 1U);
}

TEST_F(GreetingTest, RefusesAnUnknownTokenAndThenTakesANewPlayer) {
    protocol::ResumeToken wrong{};
    wrong.fill(0x42);
    const SessionId session = come_back(wrong);
    EXPECT_EQ(refusal(session), RefusedCode::UnknownToken);
    say(session, client::Hello{.name = "Ada", .token = {}});
    EXPECT_EQ(count<told::Welcome>(session), 1U);
}

TEST_F(GreetingTest, ClosesWhoTriesTokensOut) {
    const SessionId session = connect();
    for (int i = 0; i < limits.illegal_messages; ++i) {
        EXPECT_FALSE(outbox.is_closed(session));
        protocol::ResumeToken guess{};
        guess[0] = static_cast<std::uint8_t>(i);
        say(session, client::Hello{.name = {}, .token = guess});
    }
    EXPECT_TRUE(outbox.is_closed(session));
    EXPECT_EQ(lobby->stats().sessions, 0U);
}

TEST_F(GreetingTest, BringsTheSamePlayerBackWithANewToken) {
    const SessionId before = greet("Ada");
    disconnect(before);
    const SessionId after = come_back(token_of(before));
    EXPECT_EQ(last<told::Welcome>(after).name, last<told::Welcome>(before).name);
    EXPECT_NE(token_of(after), token_of(before));
}

TEST_F(GreetingTest, KeepsTheOldTokenGoodUntilTheFirstMessageUnderTheNewOne) {
    const SessionId before = greet("Ada");
    const auto old_token = token_of(before);
    disconnect(before);

    disconnect(come_back(old_token));  // The Welcome may have been lost on the way.
    const SessionId again = come_back(old_token);
    EXPECT_EQ(count<told::Welcome>(again), 1U);
    say(again, client::Ping{});
    disconnect(again);

    const SessionId late = come_back(old_token);
    EXPECT_EQ(refusal(late), RefusedCode::UnknownToken);
    const SessionId last_one = come_back(token_of(again));
    EXPECT_EQ(count<told::Welcome>(last_one), 1U);
}

TEST_F(GreetingTest, KeepsBothTokensGoodOverARestartUntilTheNewOneIsConfirmed) {
    const SessionId before = greet("Ada");
    disconnect(before);
    const SessionId half_way = come_back(token_of(before));
    restart();
    const SessionId with_old = come_back(token_of(before));
    EXPECT_EQ(count<told::Welcome>(with_old), 1U);

    say(with_old, client::Ping{});
    restart();
    EXPECT_EQ(refusal(come_back(token_of(before))), RefusedCode::UnknownToken);
    EXPECT_EQ(refusal(come_back(token_of(half_way))), RefusedCode::UnknownToken);
    EXPECT_EQ(count<told::Welcome>(come_back(token_of(with_old))), 1U);
}

TEST_F(GreetingTest, ReplacesAConnectionThatIsOnlyHalfGone) {
    const SessionId half_open = greet("Ada");
    const SessionId fresh = come_back(token_of(half_open));
    EXPECT_EQ(last<told::Notice>(half_open).code, told::NoticeCode::ReplacedByNewConnection);
    EXPECT_TRUE(outbox.is_closed(half_open));
    EXPECT_EQ(count<told::Welcome>(fresh), 1U);
    EXPECT_EQ(lobby->stats().sessions, 1U);

    say(half_open, client::Ping{});  // Was on its way; there is no such session any more.
    EXPECT_EQ(count<told::Pong>(half_open), 0U);
    disconnect(half_open);
    say(fresh, client::Ping{});
    EXPECT_EQ(count<told::Pong>(fresh), 1U);
}

TEST_F(GreetingTest, WelcomesOnlyTheLastOfTwoWhoComeWithOneToken) {
    const SessionId before = greet("Ada");
    const auto token = token_of(before);
    disconnect(before);
    disk_is_slow = true;
    const SessionId first = come_back(token);
    const SessionId second = come_back(token);
    committer.complete_all();
    EXPECT_EQ(count<told::Welcome>(first), 0U);
    EXPECT_TRUE(outbox.is_closed(first));
    EXPECT_EQ(count<told::Welcome>(second), 1U);
    EXPECT_EQ(committer.durable().players.front().token_hash, hash_of(token_of(second)));
}

TEST_F(GreetingTest, LetsWhoCouldNotBeStoredTryAgain) {
    disk_is_slow = true;
    const SessionId ada = greet("Ada");
    committer.fail();
    EXPECT_EQ(refusal(ada), RefusedCode::StorageFailed);
    EXPECT_TRUE(lobby->stats().storage_failing);
    EXPECT_EQ(count<told::Welcome>(ada), 0U);

    say(ada, client::Hello{.name = "Ada", .token = {}});
    committer.complete();
    EXPECT_EQ(count<told::Welcome>(ada), 1U);
    EXPECT_FALSE(lobby->stats().storage_failing);
}

TEST_F(GreetingTest, KeepsTheUsedTokenGoodWhereTheNewOneCouldNotBeStored) {
    const SessionId before = greet("Ada");
    disconnect(before);
    disk_is_slow = true;
    const SessionId unlucky = come_back(token_of(before));
    committer.fail();
    EXPECT_EQ(refusal(unlucky), RefusedCode::StorageFailed);
    disk_is_slow = false;
    EXPECT_EQ(count<told::Welcome>(come_back(token_of(before))), 1U);
}

TEST_F(GreetingTest, ForgetsANewPlayerWhoLeftBeforeTheWelcome) {
    limits.max_players = 1;
    start();
    disk_is_slow = true;
    const SessionId gone = greet("Ada");
    disconnect(gone);
    committer.complete();
    EXPECT_TRUE(outbox.told(gone).empty());
    disk_is_slow = false;
    EXPECT_EQ(count<told::Welcome>(greet("Grace")), 1U);
    EXPECT_EQ(refusal(greet("Linus")), RefusedCode::TooMany);
}

TEST_F(GreetingTest, ClosesWhoDoesNotSayHelloInTime) {
    const SessionId session = connect();
    pass(4999ms);
    EXPECT_FALSE(outbox.is_closed(session));
    pass(1ms);
    EXPECT_EQ(last<told::Refused>(session).code, RefusedCode::GreetingTimeout);
    EXPECT_TRUE(outbox.is_closed(session));
    EXPECT_EQ(lobby->next_deadline(), std::nullopt);
}

TEST_F(GreetingTest, WaitsForNothingOnceEverybodyIsGone) {
    disconnect(connect());
    disconnect(greet("Ada"));
    EXPECT_EQ(lobby->next_deadline(), std::nullopt);
    EXPECT_EQ(lobby->stats().sessions, 0U);
}

TEST_F(GreetingTest, DoesNotProlongTheGreetingByRefusedMessages) {
    const SessionId session = connect();
    pass(4s);
    say(session, client::Ping{});
    say(session, client::Hello{.name = "", .token = {}});
    pass(1s);
    EXPECT_TRUE(outbox.is_closed(session));
}

TEST_F(GreetingTest, ClosesWhoIsSilentForTooLongAndCountsAPingAsLife) {
    const SessionId alive = greet("Ada");
    const SessionId silent = greet("Grace");
    pass(59s);
    say(alive, client::Ping{});
    pass(1s);
    EXPECT_EQ(last<told::Refused>(silent).code, RefusedCode::IdleTimeout);
    EXPECT_TRUE(outbox.is_closed(silent));
    EXPECT_FALSE(outbox.is_closed(alive));
    pass(58s);
    EXPECT_FALSE(outbox.is_closed(alive));
    pass(1s);
    EXPECT_TRUE(outbox.is_closed(alive));
}

TEST_F(GreetingTest, AnswersAPingWithBothTimes) {
    const SessionId ada = greet("Ada");
    now = base::Instant{1234us};
    say(ada, client::Ping{.client_time_us = -77});
    EXPECT_EQ(last<told::Pong>(ada), (told::Pong{.client_time_us = -77, .server_time_us = 1234}));
}

TEST_F(GreetingTest, CountsBytesThatAreNoMessageAndClosesInTheEnd) {
    const SessionId ada = greet("Ada");
    for (int i = 1; i < limits.illegal_messages; ++i) lobby->malformed(now, ada, "no frame");
    EXPECT_EQ(last<told::Refused>(ada).code, RefusedCode::Malformed);
    EXPECT_EQ(last<told::Refused>(ada).detail, "no frame");
    EXPECT_FALSE(outbox.is_closed(ada));
    lobby->malformed(now, ada, "no frame");
    EXPECT_TRUE(outbox.is_closed(ada));
}

TEST_F(GreetingTest, CutsADetailThatIsTooLongBetweenTwoCharacters) {
    const SessionId ada = greet("Ada");
    std::string detail(protocol::kMaxDetailLength - 1, 'x');
    lobby->malformed(now, ada, detail + "\xc3\xa4");
    EXPECT_EQ(last<told::Refused>(ada).detail, detail);
}

TEST_F(GreetingTest, TellsEveryoneWhenItGoesDownAndStartsNothingNew) {
    const SessionId ada = greet("Ada");
    const SessionId nobody = connect();
    lobby->shut_down(now);
    EXPECT_EQ(last<told::Notice>(ada).code, told::NoticeCode::ShuttingDown);
    EXPECT_EQ(last<told::Notice>(nobody).code, told::NoticeCode::ShuttingDown);

    say(nobody, client::Hello{.name = "Grace", .token = {}});
    EXPECT_EQ(refusal(nobody), RefusedCode::ShuttingDown);
    say(ada, client::CreateTable{});
    EXPECT_EQ(refusal(ada), RefusedCode::ShuttingDown);
    const SessionId late = connect();
    EXPECT_EQ(last<told::Notice>(late).code, told::NoticeCode::ShuttingDown);
    EXPECT_TRUE(outbox.is_closed(late));
}

TEST_F(GreetingTest, KeepsTenThousandSessionsDeadlinesInOrder) {
    for (int i = 0; i < 10'000; ++i) {
        now += 1us;
        connect();
    }
    EXPECT_EQ(lobby->next_deadline(), base::Instant{5s + 1us});
    pass(5s);
    EXPECT_EQ(lobby->stats().sessions, 0U);
}

}  // namespace
}  // namespace billiards::server
