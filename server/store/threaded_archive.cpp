// Takes questions about what has been played; answers them from a connection and a thread of its
// own.
#include "server/store/threaded_archive.h"

#include "server/store/answer.h"

#include <asio/post.hpp>
#include <utility>

namespace billiards::server {

ThreadedArchive::ThreadedArchive(std::unique_ptr<MatchStore> store, Reply reply, Limits limits)
    : store_(std::move(store)),
      reply_(std::move(reply)),
      limits_(limits),
      thread_([this] { context_.run(); }) {}

ThreadedArchive::~ThreadedArchive() {
    context_.stop();
    thread_.join();
}

void ThreadedArchive::ask(Question question, Answered answered) {
    const bool is_full = unanswered_ >= limits_.questions_waiting;
    ++unanswered_;
    asio::post(context_, [this, is_full, asked = std::move(question),
                          then = std::move(answered)]() mutable {
        ArchiveAnswer answer = is_full ? ArchiveAnswer(busy("too many questions are waiting"))
                                       : answer_to(*store_, asked);
        reply_([this, then = std::move(then), answer = std::move(answer)] {
            --unanswered_;
            then(answer);
        });
    });
}

}  // namespace billiards::server
