// Takes what a server says and what time it is; gives what a player without a screen answers. No
// socket and no clock in it, so that one thread can be a thousand players.
#pragma once

#include "client/app/client_state.h"
#include "common/base/random.h"
#include "common/base/time.h"
#include "common/match/match_state.h"
#include "common/protocol/messages.h"
#include "tools/player/match_digest.h"

#include <cstdint>
#include <functional>
#include <optional>
#include <string>

namespace billiards::tools {

struct PlayerOptions {
    protocol::Role role = protocol::Role::Player;
    std::optional<protocol::TableId> table;  ///< To join; none: opens one.
    std::string table_name = "Table";        ///< Of the one it opens, as are its settings.
    match::Settings settings;
    std::uint64_t seed = 0;
    /// How long it thinks once the turn is open: uniform between the two.
    base::Duration min_think{};
    base::Duration max_think{};
    /// Says `seen` when the balls have come to rest, as a person would; else at once.
    bool watches_balls_roll = false;
    std::optional<base::Duration> aim_every;  ///< Shows its aim while it thinks.
    bool plays_again = false;                 ///< Wants a rematch when a match is over.
    bool claims_match = false;                ///< As soon as its opponent was away for too long.
    std::optional<bool> accepts_offers{};     ///< None: leaves them unanswered.
    /// Decides; bot::choose plays best.
    std::function<match::Command(const match::MatchState&, base::Random&)> choose;
};

/// What it tells; each may be empty. `before` is the table as it was before the message.
struct PlayerEvents {
    using Table = client::TableView;
    std::function<void(const protocol::server::Welcome&)> welcome;
    std::function<void(const Table& now)> seated;  ///< At a table, or back at it.
    std::function<void(const Table& before, const protocol::server::ShotPlayed&)> shot;
    std::function<void(const Table& before, const protocol::server::MatchMoved&)> moved;
    std::function<void(const Table& before, const protocol::server::MatchOver&)> over;
    std::function<void(const protocol::server::Refused&)> refused;
};

class HeadlessPlayer {
  public:
    /// Gives the request_id that a refusal will name.
    using Send = std::function<std::uint32_t(protocol::ClientMessageBody)>;

    HeadlessPlayer(PlayerOptions options, PlayerEvents events, Send send);

    void received(const protocol::ServerMessage& message, base::Instant now);
    /// Until the server speaks again, nothing is said.
    void link_lost();

    /// When advance_time should next be called; none: it waits for the server alone.
    std::optional<base::Instant> next_deadline() const;
    void advance_time(base::Instant now);

    const client::ClientState& state() const { return state_; }
    const MatchDigest& digest() const { return digest_; }
    /// The match is over and it plays no other, or it cannot go on: failure() says why.
    bool is_finished() const { return is_over_ || !failure_.empty(); }
    const std::string& failure() const { return failure_; }

  private:
    /// What was asked and not answered yet.
    using Awaited = std::optional<protocol::ClientMessage>;

    void tell(const protocol::ServerMessage& message);
    void tell_shot(const client::TableView& before, const protocol::server::ShotPlayed& shot);
    void tell_over(const client::TableView& before, const protocol::server::MatchOver& over);
    void tell_missed(const protocol::server::TableSnapshot& snapshot);
    void react(const protocol::ServerMessage& message, base::Instant now);
    void on_welcome(const protocol::server::Welcome& welcome);
    void on_snapshot(const protocol::server::TableSnapshot& snapshot, base::Instant now);
    void on_resumed();
    void back_at_table();
    void on_shot(const protocol::server::ShotPlayed& shot, base::Instant now);
    void on_over();
    void on_refused(const protocol::server::Refused& refused, base::Instant now);
    void settle(const protocol::ServerMessage& message);
    void plan(base::Instant now);
    void plan_turn(base::Instant now);
    void plan_answer(base::Instant now);
    void plan_claim();
    protocol::ClientMessage ask(protocol::ClientMessageBody body);
    void decide();
    void answer_offer(base::Instant now);
    void act(base::Instant now);
    void show_aim(base::Instant now);
    void get_ready_if_needed();

    PlayerOptions options_;
    PlayerEvents events_;
    Send send_;
    base::Random random_;
    client::ClientState state_;
    MatchDigest digest_;

    bool was_seated_ = false;
    bool was_playing_ = false;
    bool is_over_ = false;
    std::string failure_;
    std::optional<std::uint32_t> entering_;  ///< The request to open or join a table.
    Awaited move_;                           ///< Of its turn.
    Awaited answer_;                         ///< To an offer.
    Awaited claim_;
    Awaited readiness_;  ///< Ready or Rematch.
    std::optional<match::Command> decided_;
    model::TurnNumber planned_turn_;
    base::Duration think_{};      ///< Of the planned turn.
    base::Instant not_before_{};  ///< After a refusal.
    int refusals_ = 0;            ///< In a row.
    std::optional<base::Instant> act_at_;
    std::optional<base::Instant> aim_at_;
    std::optional<base::Instant> answer_at_;
    std::optional<base::Instant> claim_at_;
    std::optional<base::Instant> seen_at_;
    std::uint64_t seen_sequence_ = 0;
};

}  // namespace billiards::tools
