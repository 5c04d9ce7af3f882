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
    measure_(
        {since(start), group.size(), result.ok() ? std::nullopt : std::optional(result.error())});
    return result;
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
