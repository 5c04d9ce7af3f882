// Takes what happens to a session's link; gives when to try again, how to greet, and what must be
// said a second time. Pure: time and seed come in.
#pragma once

#include "client/net/lost.h"
#include "client/net/unanswered.h"
#include "common/base/random.h"
#include "common/base/time.h"
#include "common/protocol/messages.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace billiards::client {

struct ReconnectLimits {
    base::Duration first_delay = std::chrono::milliseconds(200);
    base::Duration max_delay = std::chrono::seconds(5);
    int max_attempts = 60;  ///< In a row without a Welcome, then it gives up.
    /// A link that lived this long since its Welcome stood: the delays start again.
    base::Duration stood = std::chrono::seconds(10);
};

/// One player's session over as many links as it takes. Before the first Welcome a lost link is
/// final, because a person is there to be told; after it, the link is made again.
class Reconnect {
  public:
    Reconnect(std::string name, std::optional<protocol::ResumeToken> token, std::uint64_t seed,
              const ReconnectLimits& limits = {});

    /// The greeting of the next link, with the newest token and how far the table was followed.
    protocol::client::Hello hello() const;

    // Everything that is sent and received goes through here.

    /// False: not now, because the table has yet to show how it stands; it is said with the rest of
    /// take_repeats() then.
    bool sent(const protocol::ClientMessage& message);
    void received(const protocol::ServerMessage& message, base::Instant now);
    /// What must be said now, after a message was received: everything that may be said again and
    /// was not answered, once a new link has shown how the table stands.
    std::vector<protocol::ClientMessage> take_repeats();

    /// How long to wait before the next link: doubled each time, and spread over the upper half of
    /// that, so that a thousand clients of one server do not come back at once. None: give up.
    std::optional<base::Duration> lost(LostCode code, base::Instant now);

    const std::optional<protocol::ResumeToken>& token() const { return token_; }

  private:
    void follow(const protocol::ServerMessage& message);

    std::string name_;
    std::optional<protocol::ResumeToken> token_;
    base::Random random_;
    ReconnectLimits limits_;
    std::optional<base::Instant> welcomed_;  ///< When the present or last link was.
    bool was_ever_welcomed_ = false;
    bool is_over_ = false;  ///< Replaced by another connection, or the token is no longer known.
    int attempts_ = 0;      ///< Since the last Welcome.
    int delays_ = 0;        ///< Since the last link that stood.
    std::optional<protocol::client::Followed> followed_;
    Unanswered unanswered_;
    bool is_table_due_ = false;   ///< A Welcome named it, and it has not been shown yet.
    bool is_repeat_due_ = false;  ///< It has been shown, and nothing was said again yet.
};

}  // namespace billiards::client
