// Holds the archive against many questions at once: order, its limit, an end.
#include "server/store/threaded_archive.h"

#include "server/store/sqlite_store.h"
#include "tests/server/store/opened_store.h"

#include <asio/executor_work_guard.hpp>
#include <asio/io_context.hpp>
#include <asio/post.hpp>
#include <chrono>
#include <gmock/gmock.h>
#include <string>

namespace billiards::server {
namespace {

using protocol::RefusedCode;
using testing::ElementsAre;

/// An archive beside an open store, and the thread that asks, which is the test's.
class ThreadedArchiveTest : public StoreTest {
  protected:
    ThreadedArchiveTest() { open(); }

    void begin(ThreadedArchive::Limits limits) {
        archive.emplace(
            open_sqlite_reader(file).value(),
            [this](auto call) { asio::post(context, std::move(call)); }, limits);
    }
    void ask(const std::string& player) {
        archive->ask(
            AskRecord{.asker = {1}, .player = player}, [this](const ArchiveAnswer& answer) {
                answers.push_back(answer.ok() ? "answered" : detail_of(answer.error().code));
            });
    }
    void run_until_answered(std::size_t count) {
        while (answers.size() < count) {
            ASSERT_GT(context.run_one_for(std::chrono::seconds(10)), 0U);
        }
    }
    static std::string detail_of(RefusedCode code) {
        return code == RefusedCode::UnknownPlayer ? "unknown" : "busy";
    }

    asio::io_context context;
    asio::executor_work_guard<asio::io_context::executor_type> work = make_work_guard(context);
    std::vector<std::string> answers;
    std::optional<ThreadedArchive> archive;
};

TEST_F(ThreadedArchiveTest, AnswersInTheOrderOfAskingAndNeverFromWithin) {
    commit({SavePlayer{some_player(1)}});
    begin({});
    ask(some_player(1).name);
    ask("Nobody#0000");
    ask(some_player(1).name);
    EXPECT_TRUE(answers.empty());
    run_until_answered(3);
    EXPECT_THAT(answers, ElementsAre("answered", "unknown", "answered"));
}

TEST_F(ThreadedArchiveTest, SeesWhatIsCommittedAfterItsBeginning) {
    begin({});
    commit({SavePlayer{some_player(1)}});
    ask(some_player(1).name);
    run_until_answered(1);
    EXPECT_THAT(answers, ElementsAre("answered"));
}

TEST_F(ThreadedArchiveTest, IsBusyBeyondItsLimitAndTakesQuestionsAgainAfterwards) {
    begin({.questions_waiting = 2});
    for (int time = 0; time < 3; ++time) ask("Nobody#0000");
    run_until_answered(3);
    EXPECT_THAT(answers, ElementsAre("unknown", "unknown", "busy"));
    ask("Nobody#0000");
    run_until_answered(4);
    EXPECT_EQ(answers.back(), "unknown");
}

TEST_F(ThreadedArchiveTest, EndsWithQuestionsStillWaiting) {
    begin({});
    for (int time = 0; time < 100; ++time) ask("Nobody#0000");
    archive.reset();
    EXPECT_TRUE(answers.empty());
}

}  // namespace
}  // namespace billiards::server
