// Holds how players ask for what has been played: who asks what of the archive, and how often.
#include "tests/server/support/game_test.h"

#include <gtest/gtest.h>

namespace billiards::server {
namespace {

class QuestionsTest : public MatchTest {
  protected:
    std::string name_of(SessionId session) { return last<told::Welcome>(session).name; }
    template <class Asked>
    Asked asked() {
        if (archive.waiting() == 0 || !std::holds_alternative<Asked>(archive.next())) {
            ADD_FAILURE() << "no such question was asked";
            return {};
        }
        return std::get<Asked>(archive.next());
    }
    void answer_with(protocol::ServerMessage message) {
        archive.answer(protocol::encode(std::move(message)));
    }
    void answer_with(RefusedCode code) {
        archive.answer(told::Refused{.code = code, .match_code = {}, .detail = "why"});
    }
};

TEST_F(QuestionsTest, HandsTheAnswerOnAsItIs) {
    const SessionId session = greet("Ada");
    say(session, client::AskHistory{.player = "Grace#0001", .before = 7});
    const auto question = asked<AskHistory>();
    EXPECT_EQ(question.player, "Grace#0001");
    EXPECT_EQ(question.before, 7U);
    const auto frame = protocol::encode(told::HistoryPage{.rows = {}, .has_more = true});
    archive.answer(frame);
    ASSERT_EQ(count<told::HistoryPage>(session), 1U);
    EXPECT_EQ(outbox.frames<told::HistoryPage>(session).front(), frame);
}

TEST_F(QuestionsTest, AsksAsThePlayerWhoAsks) {
    const SessionId first = greet("Ada");
    const SessionId second = greet("Grace");
    say(first, client::AskHistory{});
    const PlayerId one = asked<AskHistory>().asker;
    answer_with(RefusedCode::Busy);
    say(second, client::AskHistory{});
    EXPECT_NE(asked<AskHistory>().asker, one);
}

TEST_F(QuestionsTest, TakesNobodysRecordForOnesOwn) {
    const SessionId session = greet("Ada");
    say(session, client::AskRecord{});
    EXPECT_EQ(asked<AskRecord>().player, name_of(session));
    answer_with(told::PlayerRecord{.name = name_of(session)});
    EXPECT_EQ(last<told::PlayerRecord>(session).name, name_of(session));
    say(session, client::AskRecord{"Grace#0001"});
    EXPECT_EQ(asked<AskRecord>().player, "Grace#0001");
}

TEST_F(QuestionsTest, NamesTheRequestThatIsRefused) {
    const SessionId session = greet("Ada");
    say(session, client::AskRecord{"Nobody#0000"});
    answer_with(RefusedCode::UnknownPlayer);
    EXPECT_EQ(refusal(session), RefusedCode::UnknownPlayer);
    EXPECT_EQ(last<told::Refused>(session).detail, "why");
}

TEST_F(QuestionsTest, WaitsForOneAnswerBeforeTheNextQuestion) {
    const SessionId session = greet("Ada");
    say(session, client::AskHistory{});
    say(session, client::AskRecord{});
    EXPECT_EQ(refusal(session), RefusedCode::Busy);
    EXPECT_EQ(archive.waiting(), 1U);
    answer_with(told::HistoryPage{});
    say(session, client::AskRecord{});
    EXPECT_EQ(refusal(session), std::nullopt);
    EXPECT_EQ(archive.waiting(), 1U);
}

TEST_F(QuestionsTest, AreCountedAmongTheRequestsToTheLobby) {
    const SessionId session = greet("Ada");
    for (int i = 0; i < limits.lobby_requests_per_10s; ++i) {
        say(session, client::AskHistory{});
        answer_with(told::HistoryPage{});
    }
    say(session, client::AskHistory{});
    EXPECT_EQ(refusal(session), RefusedCode::TooMany);
}

TEST_F(QuestionsTest, AreForgottenWithTheConnection) {
    const SessionId session = greet("Ada");
    say(session, client::AskHistory{});
    disconnect(session);
    outbox.clear();
    answer_with(told::HistoryPage{});
    EXPECT_TRUE(outbox.told(session).empty());
}

TEST_F(QuestionsTest, ShowOnesOwnTablesMatchAsFarAsOneHasSeenIt) {
    start_match();
    take_turn(1);
    const std::uint64_t steps = 2 + (state().shots_played > 0 ? 1U : 0U);  // Began, ball set, shot.
    for (const SessionId session : {ada, linus}) {
        say(session, client::AskReplay{.match = 0, .first = 1});
        const auto question = asked<AskReplay>();
        EXPECT_EQ(question.match, MatchId{1});
        EXPECT_EQ(question.first, 1U);
        EXPECT_EQ(question.steps, steps);
        answer_with(told::ReplayChunk{.match = 1, .first = 1, .total = steps, .messages = {}});
        EXPECT_EQ(last<told::ReplayChunk>(session).total, steps);
    }
    say(grace, client::AskReplay{.match = 1, .first = 0});
    EXPECT_EQ(asked<AskReplay>().steps, steps) << "named by its number it is the same match";
}

TEST_F(QuestionsTest, TellADelayedSpectatorOfTheNextMatchOnlyOnceItIsShown) {
    match::Settings settings;
    settings.spectator_delay_s = 20.0;
    start_match(settings);
    keep_alive();
    pass(30s);
    say(ada, client::Concede{});
    for (const SessionId session : {ada, grace}) say(session, client::Ready{});
    const auto ask = [&](std::uint64_t match) {
        say(linus, client::AskReplay{.match = match, .first = 0});
        const auto question = asked<AskReplay>();
        answer_with(told::ReplayChunk{});
        return question;
    };
    EXPECT_EQ(ask(0).match, MatchId{1});
    EXPECT_EQ(ask(2).steps, std::nullopt) << "it is another's match, as to any stranger";
    keep_alive();
    pass(20s);
    EXPECT_EQ(ask(0).match, MatchId{2});
    EXPECT_EQ(ask(2).steps, 1U);
}

TEST_F(QuestionsTest, LeaveAPrivateMatchToTheArchiveForWhoComesOnceItsTableIsPublic) {
    seat_players();
    say(ada, client::ChangeTable{.settings = {}, .is_private = true, .passcode = {}});
    for (const SessionId session : {ada, grace}) say(session, client::Ready{});
    say(ada, client::Concede{});
    const auto steps_for = [&](SessionId session) {
        say(session, client::AskReplay{});
        const auto question = asked<AskReplay>();
        answer_with(told::ReplayChunk{});
        return question.steps;
    };
    EXPECT_EQ(steps_for(linus), 2U);
    say(ada, client::ChangeTable{.settings = {}, .is_private = false, .passcode = {}});
    const SessionId stranger = greet("Stranger");
    say(stranger, client::Join{table, Role::Spectator});
    EXPECT_EQ(steps_for(stranger), std::nullopt);
    EXPECT_EQ(steps_for(grace), 2U);
}

TEST_F(QuestionsTest, LeaveItToTheArchiveWhetherAnotherMatchIsOver) {
    start_match();
    const SessionId stranger = greet("Stranger");
    say(stranger, client::AskReplay{.match = 1, .first = 0});
    EXPECT_EQ(asked<AskReplay>().steps, std::nullopt);
}

TEST_F(QuestionsTest, FindNoMatchWhereNoneWasPlayed) {
    seat_players();
    for (const SessionId session : {ada, linus, greet("Stranger")}) {
        say(session, client::AskReplay{});
        EXPECT_EQ(refusal(session), RefusedCode::UnknownMatch);
    }
    EXPECT_EQ(archive.waiting(), 0U);
}

}  // namespace
}  // namespace billiards::server
