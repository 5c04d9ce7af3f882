// Takes what a person at a screen does; gives everything that the screen shows: the client as a
// whole, without a window.
#pragma once

#include "client/app/client_state.h"
#include "client/input/shot_control.h"
#include "client/net/address.h"
#include "client/net/server_link.h"
#include "client/play/placing.h"
#include "client/play/presentation.h"
#include "common/base/time.h"
#include "common/match/match_state.h"
#include "common/protocol/messages.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace billiards::client {

// What to do once the server has greeted: look around, open a table, or go to one.
struct LookAround {};
struct OpenTable {
    protocol::client::CreateTable table;
};
struct GoToTable {
    protocol::client::Join join;
};
using Errand = std::variant<LookAround, OpenTable, GoToTable>;

/// One person, or two at one screen. Never waits: what it asks of the server is answered in a later
/// advance(). All times are local ones.
class Game {
  public:
    /// The seed makes shot ids and the jitter between attempts; no two runs should share it.
    explicit Game(std::uint64_t seed) : seed_(seed) {}

    /// Leaves what was before. A token comes back to an earlier session.
    void connect(const ServerAddress& address, const std::string& name, Errand errand,
                 std::optional<protocol::ResumeToken> token = std::nullopt);
    void disconnect();
    bool is_connected() const { return state_.link == LinkState::Ready; }
    /// Why the link is lost, in words; empty while it is not.
    const std::string& lost() const { return lost_; }
    /// The link is lost, and made again by itself.
    bool is_coming_back() const { return coming_back_; }

    /// Takes what arrived, shows what is due, sends what waits. Once a frame.
    void advance(base::Instant now);
    // Its two halves, for who may not miss a shot though the next one has arrived.
    /// Takes the next thing that arrived; false where nothing waits.
    bool take_next();
    void show(base::Instant now);

    /// The newest that is known; what is shown may be a shot behind.
    const ClientState& known() const { return state_; }
    const Presentation& presentation() const { return presentation_; }
    /// The balls as they are shown; one in hand is where it is held.
    std::vector<ShownBall> balls(base::Instant now) const;

    // In the lobby, and at a table between two matches.
    void list_tables();
    void join(protocol::TableId table, protocol::Role role);
    void open_table(const protocol::client::CreateTable& table);
    void ready();
    /// Ready was said, and the match has not started yet.
    bool has_asked_to_start() const { return asked_to_start_; }
    void leave_table();

    // At a table, while it is this screen's turn; otherwise they do nothing.

    /// The seat that may act here and now: the balls rest, the turn is open, nothing is on its way.
    std::optional<model::Seat> acting() const;
    ShotControl& shot() { return shot_; }
    const ShotControl& shot() const { return shot_; }
    /// The cue ball as it is shown; none where it is not on the table nor held.
    std::optional<base::Vec2> cue_ball_m() const;
    /// Plays the shot as it stands. A cue ball that is held is set down first.
    void shoot();
    const std::optional<Placing>& placing() const { return placing_; }
    void move_cue_ball(base::Vec2 by_m);
    void hold_cue_ball_at(base::Vec2 at_m);
    /// Sets the held cue ball down where it is, if it may lie there.
    void set_down();
    void choose(rules::Choice choice);
    void concede();
    void chat(const std::string& text);
    void skip_roll();

    /// What the server would not do, in its words; until the next thing is asked.
    const std::string& refusal() const { return refusal_; }

  private:
    void take(const LinkEvent& event);
    void on(const Arrived& arrived);
    void on(const LinkLost& lost);
    void run_errand();
    void start_turn_if_new();
    void send_seen();
    void show_aim(base::Instant now);
    std::uint32_t send(protocol::ClientMessageBody body);
    /// Sends what moves the match on; nothing else is sent until it is answered.
    void send_move(protocol::ClientMessageBody body);
    std::uint64_t next_shot_id();

    std::uint64_t seed_;
    std::uint64_t shots_sent_ = 0;
    std::unique_ptr<ServerLink> link_;
    std::string lost_;
    bool coming_back_ = false;
    std::string refusal_;
    Errand errand_;
    ClientState state_;
    Presentation presentation_;
    ShotControl shot_;
    std::optional<Placing> placing_;
    std::optional<model::TurnNumber> turn_;  ///< The one that `shot_` and `placing_` are for.
    std::optional<std::uint32_t> awaited_;   ///< The request that moves the match on.
    bool shoots_once_placed_ = false;
    bool asked_to_start_ = false;
    std::optional<model::Shot> shown_aim_;
    base::Instant aim_sent_at_{};
    base::Instant now_{};
};

}  // namespace billiards::client
