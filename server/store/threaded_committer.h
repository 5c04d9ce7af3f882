// Takes writes from the game thread; commits them in groups on a thread of its own, and answers.
#pragma once

#include "server/store/committer.h"

#include <asio/executor_work_guard.hpp>
#include <asio/io_context.hpp>
#include <asio/steady_timer.hpp>
#include <chrono>
#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <thread>
#include <utility>
#include <vector>

namespace billiards::server {

/// One transaction, as it was measured.
struct CommitMeasured {
    base::Duration took{};              ///< From its begin to durable.
    std::size_t submissions = 0;        ///< How many calls of submit it held; 0: only a trial.
    std::optional<StoreError> error{};  ///< None: it is durable.
};

/// Groups without waiting: whatever is submitted while one transaction is flushed to the disk is
/// the next one, so that an idle store answers at once and a busy one flushes once for many. Once a
/// commit has failed, it tries by itself whether the next may work, so that all hear of it.
class ThreadedCommitter final : public Committer {
  public:
    struct Limits {
        std::size_t submissions_waiting = 16'384;  ///< Beyond it the answer is Busy.
        std::size_t submissions_per_transaction = 256;
        std::chrono::milliseconds trial_every{1000};  ///< While commits fail.
    };
    /// Runs the given function later, on the thread that submits.
    using Reply = std::function<void(std::function<void()>)>;
    /// Called on the store's thread.
    using Measure = std::function<void(const CommitMeasured&)>;
    /// Called on the store's thread, with everything that one call of sweep has dropped.
    using SweepDone = std::function<void(const StoreResult<Swept>&)>;

    ThreadedCommitter(std::unique_ptr<MatchStore> store, Reply reply, Measure measure,
                      Limits limits);
    ThreadedCommitter(std::unique_ptr<MatchStore> store, Reply reply, Measure measure)
        : ThreadedCommitter(std::move(store), std::move(reply), std::move(measure), Limits{}) {}
    ~ThreadedCommitter() override;

    void submit(std::vector<Write> writes, Done done) override;
    /// From any thread: drops what need not be kept, a little at a time between the commits. While
    /// one sweep is under way, another does nothing.
    void sweep(const Retention& retention, SweepDone done);
    /// On the thread that submits: commits everything submitted so far, hands the answers to
    /// `reply`, and ends the store's thread. What is submitted afterwards fails.
    void finish();

  private:
    using Clock = std::chrono::steady_clock;
    struct Submission {
        std::vector<Write> writes;
        Done done;
        Clock::time_point submitted;
        std::optional<StoreError> refused;  ///< Answered in its turn, without a commit.
    };
    struct Answer {
        Done done;
        Committed committed;
    };

    void enqueue(Submission submission);
    void commit_waiting();
    std::vector<Answer> commit_group(std::span<Submission> group);
    StoreResult<base::Done> commit_together(std::span<const Submission> group);
    void send(std::vector<Answer> answers);
    void measured(const CommitMeasured& one);
    void try_later();
    void sweep_on(const Retention& retention, Swept so_far, const SweepDone& done);

    const std::unique_ptr<MatchStore> store_;
    const Reply reply_;
    const Measure measure_;
    const Limits limits_;

    // Of the submitting thread:
    std::size_t unanswered_ = 0;
    bool finished_ = false;

    // Of the store's thread:
    std::vector<Submission> waiting_;
    bool commit_is_posted_ = false;
    bool is_trying_ = false;
    bool is_sweeping_ = false;
    bool is_ending_ = false;

    asio::io_context context_{1};
    asio::executor_work_guard<asio::io_context::executor_type> work_ = make_work_guard(context_);
    asio::steady_timer trial_{context_};
    std::thread thread_;
};

}  // namespace billiards::server
