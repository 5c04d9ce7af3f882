// Holds the answers about what has been played against what was played, and against who asks.
#include "server/store/answer.h"

#include "common/protocol/framing.h"
#include "common/protocol/limits.h"
#include "tests/common/replay/bot_match.h"
#include "tests/server/store/opened_store.h"

#include <gmock/gmock.h>
#include <span>

namespace billiards::server {
namespace {

namespace say = protocol::server;
using model::Seat;
using protocol::RefusedCode;
using testing::ElementsAre;
using testing::IsEmpty;

constexpr PlayerId kAda{1};
constexpr PlayerId kGrace{2};
constexpr PlayerId kLinus{3};

class Answer : public StoreTest {
  protected:
    Answer() {
        open();
        commit({SavePlayer{some_player(1, "Ada#0001")}, SavePlayer{some_player(2, "Grace#0002")},
                SavePlayer{some_player(3, "Linus#0003")}});
    }

    template <class Message>
    Message answer(const Question& question) {
        const auto frame = answer_to(*store, question);
        EXPECT_TRUE(frame.ok()) << frame.error().detail;
        if (!frame) return {};
        const auto body = std::span(**frame).subspan(protocol::kFrameHeaderBytes);
        const auto message = protocol::decode_server(body);
        EXPECT_TRUE(message.ok()) << message.error().detail;
        return message ? std::get<Message>(*message) : Message{};
    }
    RefusedCode refusal(const Question& question) {
        const auto frame = answer_to(*store, question);
        EXPECT_FALSE(frame.ok());
        return frame ? RefusedCode::Malformed : frame.error().code;
    }
    std::vector<std::uint64_t> history(PlayerId asker, const std::string& player = "",
                                       std::uint64_t before = 0) {
        std::vector<std::uint64_t> numbers;
        const AskHistory question{.asker = asker, .player = player, .before = before};
        for (const auto& row : answer<say::HistoryPage>(question).rows) {
            numbers.push_back(row.match);
        }
        return numbers;
    }
    say::PlayerRecord record(PlayerId asker, const std::string& player) {
        return answer<say::PlayerRecord>(AskRecord{.asker = asker, .player = player});
    }
};

MatchResult hidden(MatchResult result, base::Duration hidden_for) {
    result.hidden_for = hidden_for;
    return result;
}
MatchResult secret(MatchResult result) {
    result.is_private = true;
    return result;
}

TEST_F(Answer, GivesTheHistoryNewestFirst) {
    play(4, 1, 2, won_by(Seat::Second));
    play(9, 2, 3, won_by(Seat::First));
    EXPECT_THAT(history(kLinus), ElementsAre(9, 4));
    EXPECT_THAT(history(kLinus, "Ada#0001"), ElementsAre(4));
    EXPECT_THAT(history(kGrace, "Grace#0002"), ElementsAre(9, 4));
    EXPECT_THAT(history(kGrace, "", 9), ElementsAre(4));
    EXPECT_THAT(history(kGrace, "", 4), IsEmpty());
    EXPECT_EQ(refusal(AskHistory{.asker = kAda, .player = "Nobody#0000"}),
              RefusedCode::UnknownPlayer);
}

TEST_F(Answer, SaysHowEachMatchEnded) {
    MatchResult result = won_by(Seat::Second);
    result.ending = say::Ending::Conceded;
    result.racks_won = {{{2, 4}}};
    result.shots = 77;
    result.game = rules::Game::TenBall;
    play(4, 1, 2, result);
    const auto page = answer<say::HistoryPage>(AskHistory{.asker = kLinus, .player = {}});
    ASSERT_EQ(page.rows.size(), 1U);
    EXPECT_EQ(page.rows[0], (say::HistoryRow{.match = 4,
                                             .ended_s = kTestToday_s,
                                             .game = rules::Game::TenBall,
                                             .names = {{{"Ada#0001", "Grace#0002"}}},
                                             .racks_won = {{{2, 4}}},
                                             .winner = Seat::Second,
                                             .shots = 77,
                                             .ending = say::Ending::Conceded}));
    EXPECT_FALSE(page.has_more);
}

TEST_F(Answer, GivesTheHistoryInPages) {
    const std::uint64_t matches = protocol::kMaxHistoryRows + 3;
    for (std::uint64_t match = 1; match <= matches; ++match) {
        play(match, 1, 2, won_by(Seat::First));
    }
    const auto first = answer<say::HistoryPage>(AskHistory{.asker = kAda, .player = {}});
    EXPECT_EQ(first.rows.size(), protocol::kMaxHistoryRows);
    EXPECT_TRUE(first.has_more);
    EXPECT_THAT(history(kAda, "", first.rows.back().match), ElementsAre(3, 2, 1));
}

TEST_F(Answer, ShowsPrivateMatchesToTheirPlayersAlone) {
    play(1, 1, 2, won_by(Seat::First));
    play(2, 1, 2, secret(won_by(Seat::First)));
    for (const std::string player : {"", "Ada#0001", "Grace#0002"}) {
        EXPECT_THAT(history(kLinus, player), ElementsAre(1));
        EXPECT_THAT(history(kAda, player), ElementsAre(2, 1));
        EXPECT_THAT(history(kGrace, player), ElementsAre(2, 1));
    }
    EXPECT_EQ(refusal(AskReplay{.asker = kLinus, .match = {2}}), RefusedCode::UnknownMatch);
}

TEST_F(Answer, HidesAMatchFromOthersForAsLongAsItsSpectatorsWereDelayed) {
    play(1, 1, 2, hidden(won_by(Seat::First), std::chrono::milliseconds(29'500)));
    pass(31);
    EXPECT_THAT(history(kLinus), IsEmpty());
    EXPECT_THAT(history(kLinus, "Ada#0001"), IsEmpty());
    EXPECT_THAT(history(kGrace), ElementsAre(1));
    EXPECT_EQ(record(kLinus, "Ada#0001").games, 0U);
    EXPECT_EQ(record(kAda, "Ada#0001").games, 1U);
    pass(1);
    EXPECT_THAT(history(kLinus), ElementsAre(1));
    EXPECT_EQ(record(kLinus, "Ada#0001").wins, 1U);
}

TEST_F(Answer, TellsNothingOfPrivateMatchesByARecord) {
    play(1, 1, 2, won_by(Seat::First));
    const say::PlayerRecord before = record(kLinus, "Ada#0001");
    play(2, 1, 2, secret(won_by(Seat::Second)));
    EXPECT_EQ(record(kLinus, "Ada#0001"), before);
    EXPECT_EQ(record(kAda, "Ada#0001").games, 2U);
    EXPECT_LT(record(kAda, "Ada#0001").rating, before.rating);
    play(3, 1, 3, won_by(Seat::First));
    EXPECT_EQ(record(kLinus, "Ada#0001").games, 2U);
    EXPECT_EQ(record(kAda, "Ada#0001").games, 3U);
}

TEST_F(Answer, ShowsNoResultThatRestsOnOneStillHidden) {
    play(1, 1, 2, hidden(won_by(Seat::First), std::chrono::seconds(100)));
    play(2, 2, 3, won_by(Seat::First));
    EXPECT_EQ(record(kAda, "Linus#0003").games, 0U);
    EXPECT_EQ(record(kLinus, "Linus#0003").games, 1U);
    pass(102);
    EXPECT_EQ(record(kAda, "Linus#0003").games, 1U);
}

TEST_F(Answer, CountsNeitherPracticeNorBothSeatsInOneHandNorWhatWasAbandoned) {
    MatchResult practice = won_by(Seat::First);
    practice.game = rules::Game::Practice;
    play(1, 1, 2, practice);
    play(2, 1, 1, won_by(Seat::First));
    MatchResult abandoned;
    abandoned.ending = say::Ending::Abandoned;
    play(3, 1, 2, abandoned);
    EXPECT_EQ(record(kAda, "Ada#0001"),
              (say::PlayerRecord{.name = "Ada#0001", .rating = 1500, .deviation = 350}));
    EXPECT_THAT(history(kLinus), ElementsAre(3, 2, 1));
}

TEST_F(Answer, CountsADrawAsHalf) {
    play(1, 1, 2, MatchResult{});
    const say::PlayerRecord ada = record(kLinus, "Ada#0001");
    EXPECT_EQ(ada.draws, 1U);
    EXPECT_NEAR(ada.rating, 1500, 1e-9);
    EXPECT_LT(ada.deviation, 350);
}

TEST_F(Answer, LetsWhatIsKnownOfAPlayerGrowOldWithoutACalendar) {
    play(1, 1, 2, won_by(Seat::First));
    const double fresh = record(kLinus, "Ada#0001").deviation;
    times.calendar_s -= 1000 * kTestDay_s;
    EXPECT_EQ(record(kLinus, "Ada#0001").deviation, fresh);
    pass(100 * kTestDay_s);
    EXPECT_GT(record(kLinus, "Ada#0001").deviation, fresh);
    EXPECT_EQ(refusal(AskRecord{.asker = kAda, .player = "Nobody#0000"}),
              RefusedCode::UnknownPlayer);
}

/// A match of two bots, which Ada and Grace have played.
class ReplayAnswer : public Answer {
  protected:
    void keep(std::uint64_t match, std::optional<MatchResult> result) {
        StoredMatch stored = some_match(match);
        stored.settings = protocol::encode_settings(bots.header.settings, bots.header.seed);
        std::vector<Write> writes{SaveMatch{stored}};
        for (std::size_t i = 0; i < bots.entries.size(); ++i) {
            writes.push_back(
                AppendEntry{{match}, {i + 1, protocol::encode_entry(bots.entries[i])}});
        }
        commit(writes);
        if (!result) return;
        result->shots = 1;
        commit({FinishMatch{{match}, *result}});
    }
    static protocol::ServerMessage decoded(const std::vector<std::byte>& bytes) {
        return protocol::decode_server(bytes).value();
    }
    static std::uint64_t sequence_of(const protocol::ServerMessage& message) {
        return std::visit(
            [](const auto& one) -> std::uint64_t {
                if constexpr (requires { one.sequence; }) return one.sequence;
                return ~std::uint64_t{0};
            },
            message);
    }
    static const match::MatchState* after(const protocol::ServerMessage& message) {
        if (const auto* started = std::get_if<say::MatchStarted>(&message)) return &started->state;
        if (const auto* played = std::get_if<say::ShotPlayed>(&message)) return &played->after;
        if (const auto* moved = std::get_if<say::MatchMoved>(&message)) return &moved->after;
        return nullptr;
    }
    std::vector<protocol::ServerMessage> whole(PlayerId asker, MatchId match) {
        std::vector<protocol::ServerMessage> messages;
        for (std::uint64_t total = 1; messages.size() < total;) {
            const auto chunk = answer<say::ReplayChunk>(
                AskReplay{.asker = asker, .match = match, .first = messages.size()});
            total = chunk.total;
            EXPECT_LE(chunk.messages.size(), protocol::kMaxReplaySteps);
            if (chunk.messages.empty()) break;
            for (const auto& bytes : chunk.messages) messages.push_back(decoded(bytes));
        }
        return messages;
    }

    replay::Replay bots = replay::bot_match(replay::race_to(2), 4);
};

TEST_F(ReplayAnswer, TellsEveryStepAsItWas) {
    keep(7, won_by(Seat::First));
    const auto messages = whole(kLinus, {7});
    ASSERT_EQ(messages.size(), bots.entries.size() + 1);
    ASSERT_TRUE(std::holds_alternative<say::MatchStarted>(messages[0]));
    EXPECT_EQ(after(messages[0])->seed, 0U);
    for (std::size_t step = 1; step < messages.size(); ++step) {
        const protocol::JournalEntry& entry = bots.entries[step - 1];
        EXPECT_EQ(sequence_of(messages[step]), step);
        if (const auto* played = std::get_if<say::ShotPlayed>(&messages[step])) {
            EXPECT_EQ(played->record, entry.record);
            EXPECT_EQ(played->verdict, entry.verdict);
            EXPECT_EQ(played->struck_us, 0);
        } else {
            EXPECT_FALSE(entry.record);
        }
    }
    EXPECT_EQ(after(messages.back())->stage, match::Stage::Over);
}

TEST_F(ReplayAnswer, ShowsALiveMatchOnlyWithinTheStepsThatMayBeSeen) {
    keep(7, std::nullopt);
    EXPECT_EQ(refusal(AskReplay{.asker = kAda, .match = {7}}), RefusedCode::UnknownMatch);
    const auto some =
        answer<say::ReplayChunk>(AskReplay{.asker = kLinus, .match = {7}, .first = 0, .steps = 5});
    EXPECT_EQ(some.total, 5U);
    EXPECT_EQ(some.messages.size(), 5U);
    const auto none =
        answer<say::ReplayChunk>(AskReplay{.asker = kLinus, .match = {7}, .first = 5, .steps = 5});
    EXPECT_EQ(none.total, 5U);
    EXPECT_THAT(none.messages, IsEmpty());
    const auto nothing =
        answer<say::ReplayChunk>(AskReplay{.asker = kLinus, .match = {7}, .first = 0, .steps = 0});
    EXPECT_THAT(nothing.messages, IsEmpty());
}

TEST_F(ReplayAnswer, StartsAtAnyStep) {
    keep(7, won_by(Seat::First));
    const auto all = whole(kLinus, {7});
    const std::uint64_t first = all.size() - 3;
    const auto chunk =
        answer<say::ReplayChunk>(AskReplay{.asker = kLinus, .match = {7}, .first = first});
    EXPECT_EQ(chunk.first, first);
    ASSERT_EQ(chunk.messages.size(), 3U);
    for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(decoded(chunk.messages[i]), all[first + i]);
}

TEST_F(ReplayAnswer, RefusesWhatIsNotThereAndWhatCannotBeRead) {
    EXPECT_EQ(refusal(AskReplay{.asker = kAda, .match = {99}}), RefusedCode::UnknownMatch);
    play(5, 1, 2, won_by(Seat::First));  // Its journal is no journal.
    EXPECT_EQ(refusal(AskReplay{.asker = kAda, .match = {5}}), RefusedCode::UnknownMatch);
}

}  // namespace
}  // namespace billiards::server
