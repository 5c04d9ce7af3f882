// Takes what a server tells of a match that was or is played; gives the match at any of its steps.
#pragma once

#include "client/app/client_state.h"
#include "common/base/result.h"
#include "common/protocol/messages.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace billiards::client {

inline constexpr std::size_t kMaxRewoundSteps = 20'000;
inline constexpr std::size_t kMaxRewoundBytes = 16 * 1024 * 1024;  ///< As they came.

/// A match from how it began (step 0) to its newest step. Keeps the steps as they came, and folds
/// as few of them as a moment needs: each shot tells the whole match.
class Rewind {
  public:
    /// `live`: what is known of the table. `match`: as AskReplay has it, 0 for the one played
    /// there.
    Rewind(const ClientState& live, std::uint64_t match);

    /// What to ask next; none while everything that there is has come. One question at a time.
    std::optional<protocol::client::AskReplay> question() const;
    /// More steps of a match that is still played; the next question asks for them.
    void look_for_more() { is_complete_ = false; }

    /// The error says in words why these are not the steps that were asked for, or why they are too
    /// many; nothing has changed then, and no question is left.
    base::Result<base::Done, std::string> take(const protocol::server::ReplayChunk& chunk);

    /// So many have come; the first is how the match began.
    std::size_t steps() const { return steps_.size(); }
    /// What the step said. `step` is below steps().
    protocol::ServerMessage message(std::size_t step) const;
    /// What a client knew after it that had watched from the beginning; its times count from 0.
    ClientState at(std::size_t step) const;
    /// The nearest step with a shot after this one, or the last step: "next shot".
    std::size_t next_shot(std::size_t step) const;
    /// The nearest step with a shot before this one, or the first step.
    std::size_t previous_shot(std::size_t step) const;

  private:
    struct Step {
        std::vector<std::byte> message;
        std::size_t told_by = 0;  ///< The last shot up to here, which tells all that was before it.
        bool is_shot = false;
    };

    base::Result<std::vector<Step>, std::string> steps_of(
        const protocol::server::ReplayChunk& chunk) const;

    ClientState before_;  ///< The table without a match.
    std::uint64_t asked_match_;
    std::optional<std::uint64_t> match_;  ///< As the first answer names it.
    std::vector<Step> steps_;
    std::size_t bytes_ = 0;
    bool is_complete_ = false;
    bool has_failed_ = false;
};

}  // namespace billiards::client
