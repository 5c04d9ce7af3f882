// Holds the committer against stores that are slow or fail: groups, order, limits, an end.
#include "server/store/threaded_committer.h"

#include "server/store/sqlite_store.h"
#include "tests/server/store/stored_values.h"
#include "tests/support/temporary_folder.h"

#include <asio/post.hpp>
#include <atomic>
#include <future>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <mutex>
#include <semaphore>

namespace billiards::server {
namespace {

using testing::Each;
using testing::ElementsAre;

/// A store that waits for permission and remembers how many writes each commit held.
class SlowStore : public MatchStore {
  public:
    struct Control {
        std::counting_semaphore<> started{0};
        std::counting_semaphore<> allowed{0};
        std::mutex mutex;
        std::vector<std::size_t> commits;
        std::vector<std::size_t> sizes() {
            const std::lock_guard lock(mutex);
            return commits;
        }
    };
    explicit SlowStore(Control& control) : control_(control) {}

    /// Fails where one of the writes finishes match 13; is full where one finishes match 14.
    StoreResult<base::Done> commit(std::span<const Write> writes) override {
        control_.started.release();
        control_.allowed.acquire();
        const std::lock_guard lock(control_.mutex);
        control_.commits.push_back(writes.size());
        for (const Write& write : writes) {
            const auto* finish = std::get_if<FinishMatch>(&write);
            if (finish && finish->match.value == 13) {
                return StoreError{StoreErrorCode::Failed, "thirteen"};
            }
            if (finish && finish->match.value == 14) {
                return StoreError{StoreErrorCode::Full, "fourteen"};
            }
        }
        return base::Done{};
    }
    StoreResult<std::vector<StoredPlayer>> players() override { return no_rows(); }
    StoreResult<std::vector<StoredMatch>> live_matches() override { return no_rows(); }
    StoreResult<std::vector<EndedMatch>> ended_matches() override { return no_rows(); }
    StoreResult<std::vector<StoredTable>> tables() override { return no_rows(); }
    StoreResult<std::optional<KnownMatch>> last_match(protocol::TableId) override {
        return no_rows();
    }
    StoreResult<std::optional<KnownMatch>> find_match(MatchId) override { return no_rows(); }
    StoreResult<base::Done> journal(MatchId, const EntryVisitor&, std::uint64_t) override {
        return no_rows();
    }
    StoreResult<HighestIds> highest_ids() override { return no_rows(); }
    StoreResult<std::optional<PlayerId>> player_named(const std::string&) override {
        return no_rows();
    }
    StoreResult<std::vector<StoredResult>> history(const HistoryQuery&) override {
        return no_rows();
    }
    StoreResult<bool> may_see(MatchId, PlayerId) override { return no_rows(); }
    StoreResult<Standing> standing(PlayerId, PlayerId) override { return no_rows(); }
    StoreResult<Swept> sweep(const Retention&) override { return no_rows(); }

  private:
    static StoreError no_rows() { return {StoreErrorCode::Failed, "only commits"}; }
    Control& control_;
};

/// A committer over `Store`, and the thread of the game, which is the test's.
struct Game {
    explicit Game(std::unique_ptr<MatchStore> store, ThreadedCommitter::Limits limits = {})
        : committer(
              std::move(store), [this](auto answers) { asio::post(context, std::move(answers)); },
              [this](const CommitMeasured& one) {
                  const std::lock_guard lock(mutex);
                  measured.push_back(one);
              },
              limits) {}

    void submit(std::uint64_t number) {
        committer.submit({FinishMatch{{number}}}, [this, number](const Committed& committed) {
            answered.push_back(number);
            results.push_back(committed);
        });
    }
    void run_until_answered(std::size_t count) {
        while (answered.size() < count) {
            ASSERT_GT(context.run_one_for(std::chrono::seconds(10)), 0U);
        }
    }
    std::vector<CommitMeasured> measurements() {
        const std::lock_guard lock(mutex);
        return measured;
    }

    asio::io_context context;
    asio::executor_work_guard<asio::io_context::executor_type> work = make_work_guard(context);
    std::mutex mutex;
    std::vector<CommitMeasured> measured;
    std::vector<std::uint64_t> answered;
    std::vector<Committed> results;
    ThreadedCommitter committer;
};

/// A game whose first submission, number 1, is being committed and waits for permission.
struct BusyGame {
    explicit BusyGame(ThreadedCommitter::Limits limits = {})
        : game(std::make_unique<SlowStore>(control), limits) {
        game.submit(1);
        control.started.acquire();
    }
    ~BusyGame() { control.allowed.release(1000); }

    void go_on(std::size_t answers) {
        control.allowed.release(1000);
        game.run_until_answered(answers);
    }

    SlowStore::Control control;
    Game game;
};

TEST(ThreadedCommitter, CommitsTogetherWhatIsSubmittedWhileOneCommitRuns) {
    BusyGame busy;
    for (std::uint64_t number = 2; number <= 5; ++number) busy.game.submit(number);
    busy.go_on(5);
    EXPECT_THAT(busy.control.sizes(), ElementsAre(1, 4));
    EXPECT_THAT(busy.game.answered, ElementsAre(1, 2, 3, 4, 5));
}

TEST(ThreadedCommitter, KeepsAGroupWithinItsLimit) {
    BusyGame busy({.submissions_waiting = 100, .submissions_per_transaction = 3});
    for (std::uint64_t number = 2; number <= 9; ++number) busy.game.submit(number);
    busy.go_on(9);
    EXPECT_THAT(busy.control.sizes(), ElementsAre(1, 3, 3, 2));
}

TEST(ThreadedCommitter, LetsOnlyTheWritesFailThatCannotBeStored) {
    BusyGame busy;
    for (const std::uint64_t number : {12U, 13U, 15U}) busy.game.submit(number);
    busy.go_on(4);
    EXPECT_THAT(busy.game.answered, ElementsAre(1, 12, 13, 15));
    EXPECT_TRUE(busy.game.results[1].result.ok());
    EXPECT_FALSE(busy.game.results[2].result.ok());
    EXPECT_TRUE(busy.game.results[3].result.ok());
}

TEST(ThreadedCommitter, TriesAGroupOnceWhereTheDiskIsFull) {
    BusyGame busy;
    for (const std::uint64_t number : {12U, 14U, 15U}) busy.game.submit(number);
    busy.go_on(2);
    EXPECT_THAT(busy.control.sizes(), ElementsAre(1, 3));
    for (std::size_t i = 1; i < 4; ++i) EXPECT_FALSE(busy.game.results[i].result.ok()) << i;
}

TEST(ThreadedCommitter, AnswersBusyInItsTurnBeyondTheLimit) {
    BusyGame busy({.submissions_waiting = 3, .submissions_per_transaction = 100});
    for (std::uint64_t number = 2; number <= 4; ++number) busy.game.submit(number);
    busy.go_on(4);
    EXPECT_THAT(busy.game.answered, ElementsAre(1, 2, 3, 4));
    EXPECT_TRUE(busy.game.results[2].result.ok());
    ASSERT_FALSE(busy.game.results[3].result.ok());
    EXPECT_EQ(busy.game.results[3].result.error().code, StoreErrorCode::Busy);
    EXPECT_THAT(busy.control.sizes(), ElementsAre(1, 2));
    busy.game.submit(5);
    busy.game.run_until_answered(5);
    EXPECT_TRUE(busy.game.results[4].result.ok());
}

TEST(ThreadedCommitter, NeverAnswersFromWithinSubmit) {
    BusyGame busy;
    busy.control.allowed.release(1000);
    busy.game.committer.finish();
    busy.game.submit(2);
    EXPECT_TRUE(busy.game.answered.empty());
    busy.game.run_until_answered(2);
    EXPECT_THAT(busy.game.answered, ElementsAre(1, 2));
}

TEST(ThreadedCommitter, CommitsEverythingBeforeItFinishesAndNothingAfterwards) {
    BusyGame busy;
    busy.game.submit(2);
    busy.control.allowed.release(1000);
    busy.game.committer.finish();
    EXPECT_THAT(busy.control.sizes(), ElementsAre(1, 1));
    busy.game.submit(3);
    busy.game.run_until_answered(3);
    EXPECT_TRUE(busy.game.results[1].result.ok());
    EXPECT_FALSE(busy.game.results[2].result.ok());
    EXPECT_THAT(busy.control.sizes(), ElementsAre(1, 1));
}

TEST(ThreadedCommitter, MeasuresEveryTransaction) {
    BusyGame busy;
    busy.game.submit(2);
    busy.game.submit(13);
    busy.go_on(3);
    const auto measured = busy.game.measurements();
    ASSERT_EQ(measured.size(), 4U);
    EXPECT_EQ(measured[1].submissions, 2U);
    EXPECT_TRUE(measured[1].error);
    EXPECT_FALSE(measured[2].error);
    EXPECT_TRUE(measured[3].error);
    EXPECT_GE(busy.game.results[2].took, measured[3].took);
}

TEST(ThreadedCommitter, MakesWritesDurableInADatabase) {
    const support::TemporaryFolder folder;
    const auto file = folder.path() / "test.db";
    {
        Game game(std::move(open_sqlite_store(file)).value());
        std::vector<bool> durable;
        for (std::uint64_t number = 1; number <= 100; ++number) {
            game.committer.submit({SavePlayer{some_player(number)}},
                                  [&](const Committed& c) { durable.push_back(c.result.ok()); });
        }
        game.committer.finish();
        game.context.poll();
        EXPECT_EQ(durable.size(), 100U);
        EXPECT_THAT(durable, Each(true));
    }
    const auto store = std::move(open_sqlite_store(file)).value();
    EXPECT_EQ(store->players().value().size(), 100U);
}

/// A store of memory that fails while it is told to, and sweeps in so many steps.
class MoodyStore final : public SlowStore {
  public:
    struct Mood {
        std::atomic<bool> fails = false;
        std::atomic<int> sweeps_left = 0;
    };
    MoodyStore(SlowStore::Control& control, Mood& mood) : SlowStore(control), mood_(mood) {}

    StoreResult<Swept> sweep(const Retention& retention) override {
        if (mood_.fails) return StoreError{StoreErrorCode::Full, "full"};
        if (retention.kept_s == 0) return Swept{};
        const bool is_done = --mood_.sweeps_left == 0;
        return Swept{.entries = 10, .matches = 1, .is_done = is_done};
    }

  private:
    Mood& mood_;
};

TEST(ThreadedCommitter, TriesByItselfWhetherItCanStoreAgain) {
    SlowStore::Control control;
    control.allowed.release(1000);
    MoodyStore::Mood mood;
    mood.fails = true;
    ThreadedCommitter::Limits limits;
    limits.trial_every = std::chrono::milliseconds(1);
    std::promise<void> fails_still;
    std::promise<void> can_again;
    int trials = 0;
    ThreadedCommitter committer(
        std::make_unique<MoodyStore>(control, mood), [](const auto&) {},
        [&](const CommitMeasured& one) {
            if (one.error && one.submissions == 0 && ++trials == 2) fails_still.set_value();
            if (!one.error) can_again.set_value();
        },
        limits);
    committer.submit({FinishMatch{.match = {14}}}, [](const Committed&) {});
    fails_still.get_future().wait();
    mood.fails = false;
    can_again.get_future().wait();
    committer.finish();
}

TEST(ThreadedCommitter, EndsAlthoughATrialIsStillToCome) {
    SlowStore::Control control;
    control.allowed.release(1000);
    MoodyStore::Mood mood;
    ThreadedCommitter::Limits limits;
    limits.trial_every = std::chrono::hours(1);
    ThreadedCommitter committer(
        std::make_unique<MoodyStore>(control, mood), [](const auto&) {},
        [](const CommitMeasured&) {}, limits);
    committer.submit({FinishMatch{.match = {14}}}, [](const Committed&) {});
    committer.finish();
    EXPECT_EQ(control.sizes().size(), 1U);
}

TEST(ThreadedCommitter, SweepsStepByStepUntilNothingIsLeftToDrop) {
    SlowStore::Control control;
    MoodyStore::Mood mood;
    mood.sweeps_left = 3;
    std::promise<Swept> swept;
    ThreadedCommitter committer(
        std::make_unique<MoodyStore>(control, mood), [](const auto&) {},
        [](const CommitMeasured&) {});
    Retention retention;
    retention.kept_s = 1;
    committer.sweep(retention,
                    [&](const StoreResult<Swept>& result) { swept.set_value(result.value()); });
    const Swept all = swept.get_future().get();
    EXPECT_EQ(all.entries, 30U);
    EXPECT_EQ(all.matches, 3U);
    EXPECT_TRUE(all.is_done);
}

}  // namespace
}  // namespace billiards::server
