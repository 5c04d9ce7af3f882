// Takes questions as the archive would; answers them when the test says so, with what it says.
#pragma once

#include "server/store/archive.h"

#include <cstddef>
#include <deque>
#include <gtest/gtest.h>
#include <utility>

namespace billiards::server {

class ManualArchive final : public Archive {
  public:
    void ask(Question question, Answered answered) override {
        waiting_.push_back({std::move(question), std::move(answered)});
    }

    std::size_t waiting() const { return waiting_.size(); }
    /// The question that has waited longest.
    const Question& next() const { return waiting_.front().question; }
    void answer(ArchiveAnswer answer) {
        ASSERT_FALSE(waiting_.empty());
        Asked asked = std::move(waiting_.front());
        waiting_.pop_front();
        asked.answered(std::move(answer));
    }
    /// The server is killed: nobody waits for the answers any more.
    void kill() { waiting_.clear(); }

  private:
    struct Asked {
        Question question;
        Answered answered;
    };
    std::deque<Asked> waiting_;
};

}  // namespace billiards::server
