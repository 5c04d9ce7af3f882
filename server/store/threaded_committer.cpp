// Takes writes from the game thread; commits them in groups on a thread of its own, and answers.
#include "server/store/threaded_committer.h"

#include <algorithm>
#include <asio/post.hpp>
#include <iterator>

namespace billiards::server {
namespace {

base::Duration since(std::chrono::steady_clock::time_point start) {
    return std::chrono::duration_cast<base::Duration>(std::chrono::steady_clock::now() - start);
}

}  // namespace

ThreadedCommitter::ThreadedCommitter(std::unique_ptr<MatchStore> store, Reply reply,
                                     Measure measure, Limits limits)
    : store_(std::move(store)),
      reply_(std::move(reply)),
      measure_(std::move(measure)),
      limits_(limits),
      thread_([this] { context_.run(); }) {}

ThreadedCommitter::~ThreadedCommitter() {
    finish();
}

void ThreadedCommitter::finish() {
    if (finished_) return;
    finished_ = true;
    asio::post(context_, [this] {
        is_ending_ = true;
        trial_.cancel();
    });
    work_.reset();
    thread_.join();
}

void ThreadedCommitter::submit(std::vector<Write> writes, Done done) {
    Submission submission{std::move(writes), std::move(done), Clock::now(), std::nullopt};
    ++unanswered_;
    if (finished_) {
        const StoreError refused{StoreErrorCode::Failed, "the server is shutting down"};
        send({{std::move(submission.done), {refused, {}}}});
        return;
    }
    if (unanswered_ > limits_.submissions_waiting) {
        submission.writes = {};
        submission.refused = StoreError{StoreErrorCode::Busy, "too many writes are waiting"};
    }
    asio::post(context_,
               [this, one = std::move(submission)]() mutable { enqueue(std::move(one)); });
}

void ThreadedCommitter::enqueue(Submission submission) {
    waiting_.push_back(std::move(submission));
    if (commit_is_posted_) return;
    // Behind everything that was submitted meanwhile: all of it is one group.
    commit_is_posted_ = true;
    asio::post(context_, [this] { commit_waiting(); });
}

void ThreadedCommitter::commit_waiting() {
    commit_is_posted_ = false;
    std::vector<Submission> taken = std::exchange(waiting_, {});
    std::span<Submission> rest(taken);
    while (!rest.empty()) {
        const std::size_t size = std::min(rest.size(), limits_.submissions_per_transaction);
        send(commit_group(rest.first(size)));
        rest = rest.subspan(size);
    }
}

std::vector<ThreadedCommitter::Answer> ThreadedCommitter::commit_group(
    std::span<Submission> group) {
    const auto together = commit_together(group);
    std::vector<Answer> answers;
    answers.reserve(group.size());
    for (std::size_t i = 0; i < group.size(); ++i) {
        // One that cannot be stored must fail alone, so each of its group has its own try. What
        // no submission can cause, as a full disk, fails them all.
        const bool again =
            !together.ok() && together.error().code == StoreErrorCode::Failed && group.size() > 1;
        auto result = again ? commit_together(group.subspan(i, 1)) : together;
        if (group[i].refused) result = *group[i].refused;
        answers.push_back(
            {std::move(group[i].done), {std::move(result), since(group[i].submitted)}});
    }
    return answers;
}

StoreResult<base::Done> ThreadedCommitter::commit_together(std::span<const Submission> group) {
    std::vector<Write> writes;
    for (const Submission& submission : group) {
        std::copy(submission.writes.begin(), submission.writes.end(), std::back_inserter(writes));
    }
    if (writes.empty()) return base::Done{};
    const auto start = Clock::now();
    auto result = store_->commit(writes);
    measured(
        {since(start), group.size(), result.ok() ? std::nullopt : std::optional(result.error())});
    return result;
}

void ThreadedCommitter::measured(const CommitMeasured& one) {
    measure_(one);
    if (one.error) try_later();
}

/// Nobody plays while nothing can be stored, so no commit would tell that it can be again.
void ThreadedCommitter::try_later() {
    if (is_trying_ || is_ending_) return;
    is_trying_ = true;
    trial_.expires_after(limits_.trial_every);
    trial_.async_wait([this](const asio::error_code& cancelled) {
        is_trying_ = false;
        if (cancelled) return;
        const auto start = Clock::now();
        const auto tried = store_->sweep(Retention{});
        measured({since(start), 0, tried.ok() ? std::nullopt : std::optional(tried.error())});
    });
}

void ThreadedCommitter::sweep(const Retention& retention, SweepDone done) {
    asio::post(context_, [this, retention, then = std::move(done)] {
        if (std::exchange(is_sweeping_, true)) return;
        sweep_on(retention, {}, then);
    });
}

void ThreadedCommitter::sweep_on(const Retention& retention, Swept so_far, const SweepDone& done) {
    const auto swept = store_->sweep(retention);
    if (swept) {
        so_far.entries += swept->entries;
        so_far.matches += swept->matches;
        so_far.is_done = swept->is_done;
        if (!so_far.is_done && !is_ending_) {
            asio::post(context_, [=, this] { sweep_on(retention, so_far, done); });
            return;
        }
    }
    is_sweeping_ = false;
    done(swept ? StoreResult<Swept>(so_far) : swept);
}

void ThreadedCommitter::send(std::vector<Answer> answers) {
    reply_([this, handed = std::move(answers)] {
        for (const Answer& answer : handed) {
            --unanswered_;
            answer.done(answer.committed);
        }
    });
}

}  // namespace billiards::server
