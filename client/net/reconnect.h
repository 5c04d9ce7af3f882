// Takes what happens to a session's link; gives when to try again, how to greet, and what must be
// said a second time. Pure: time and seed come in.
#pragma once

#include "client/net/lost.h"
#include "common/base/random.h"
#include "common/base/time.h"
#include "common/protocol/messages.h"

#include <cstdint>
#include <optional>
#include <string>

namespace billiards::client {

struct ReconnectLimits {
    base::Duration first_delay = std::chrono::milliseconds(200);
    base::Duration max_delay = std::chrono::seconds(5);
    int max_attempts = 60;  ///< In a row without a link that stood, then it gives up.
    /// A link that lived this long since its Welcome stood: the count starts again.
    base::Duration stood = std::chrono::seconds(10);
};

/// One player's session over as many links as it takes. Before the first Welcome a lost link is
/// final, because a person is there to be told; after it, the link is made again.
class Reconnect {
  public:
    Reconnect(std::string name, std::optional<protocol::ResumeToken> token, std::uint64_t seed,
              const ReconnectLimits& limits = {});

    /// The greeting of the next link, with the newest token.
    protocol::client::Hello hello() const;

    /// Everything that was sent and received goes through here.
    void sent(const protocol::ClientMessage& message);
    void received(const protocol::ServerMessage& message, base::Instant now);

    /// How long to wait before the next link: doubled each time, and spread over the upper half of
    /// that, so that a thousand clients of one server do not come back at once. None: give up.
    std::optional<base::Duration> lost(LostCode code, base::Instant now);

    /// The shot that was sent and not answered: to be sent again, as it is, after each Welcome that
    /// still names a table.
    const std::optional<protocol::ClientMessage>& unanswered_shot() const { return shot_; }
    const std::optional<protocol::ResumeToken>& token() const { return token_; }

  private:
    bool is_answered_by(const protocol::ServerMessage& message) const;

    std::string name_;
    std::optional<protocol::ResumeToken> token_;
    base::Random random_;
    ReconnectLimits limits_;
    std::optional<base::Instant> welcomed_;  ///< When the present or last link was.
    bool was_ever_welcomed_ = false;
    bool is_over_ = false;  ///< Replaced by another connection, or the token is no longer known.
    int attempts_ = 0;
    std::optional<protocol::ClientMessage> shot_;
};

}  // namespace billiards::client
