// Gives the way to what has been played, for those who ask: never in the way of a commit.
#pragma once

#include "common/base/result.h"
#include "common/protocol/codec.h"
#include "common/protocol/messages.h"
#include "server/store/match_store.h"

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <variant>

namespace billiards::server {

// Who asks decides what is seen: a match at a private table and one whose spectators are still
// delayed are for its players alone, and count in nobody else's sight.

struct AskHistory {
    PlayerId asker;
    std::string player;        ///< As shown; empty: everybody.
    std::uint64_t before = 0;  ///< protocol::client::AskHistory
    friend bool operator==(const AskHistory&, const AskHistory&) = default;
};
struct AskRecord {
    PlayerId asker;
    std::string player;  ///< As shown.
    friend bool operator==(const AskRecord&, const AskRecord&) = default;
};
struct AskReplay {
    PlayerId asker;
    MatchId match;
    std::uint64_t first = 0;
    /// Of a match at the asker's table: so many steps may be seen, ended or not. None: the match
    /// must have ended, and be the asker's to see.
    std::optional<std::uint64_t> steps{};
    friend bool operator==(const AskReplay&, const AskReplay&) = default;
};

using Question = std::variant<AskHistory, AskRecord, AskReplay>;

/// A HistoryPage, PlayerRecord or ReplayChunk, ready to be sent; or how it is refused.
using ArchiveAnswer = base::Result<protocol::SharedFrame, protocol::server::Refused>;

class Archive {
  public:
    using Answered = std::function<void(ArchiveAnswer)>;

    virtual ~Archive() = default;

    /// `answered` is called later, on the thread that asked, in the order of asking; never from
    /// within ask.
    virtual void ask(Question question, Answered answered) = 0;
};

}  // namespace billiards::server
