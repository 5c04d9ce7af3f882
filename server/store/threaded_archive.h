// Takes questions about what has been played; answers them from a connection and a thread of its
// own, so that no commit waits for a long page.
#pragma once

#include "server/store/archive.h"
#include "server/store/match_store.h"

#include <asio/executor_work_guard.hpp>
#include <asio/io_context.hpp>
#include <cstddef>
#include <functional>
#include <memory>
#include <thread>

namespace billiards::server {

class ThreadedArchive final : public Archive {
  public:
    struct Limits {
        std::size_t questions_waiting = 256;  ///< Beyond it the answer is Busy.
    };
    /// Runs the given function later, on the thread that asks.
    using Reply = std::function<void(std::function<void()>)>;

    /// The store is for reading.
    ThreadedArchive(std::unique_ptr<MatchStore> store, Reply reply, Limits limits);
    ThreadedArchive(std::unique_ptr<MatchStore> store, Reply reply)
        : ThreadedArchive(std::move(store), std::move(reply), Limits{}) {}
    /// Questions that still wait are not answered any more.
    ~ThreadedArchive() override;

    void ask(Question question, Answered answered) override;

  private:
    const std::unique_ptr<MatchStore> store_;
    const Reply reply_;
    const Limits limits_;
    std::size_t unanswered_ = 0;  ///< Of the asking thread.

    asio::io_context context_{1};
    asio::executor_work_guard<asio::io_context::executor_type> work_ = make_work_guard(context_);
    std::thread thread_;
};

}  // namespace billiards::server
