// Takes what a person at a screen does; gives everything that the screen shows: the client as a
// whole, without a window.
#pragma once

#include "client/app/client_state.h"
#include "client/input/shot_control.h"
#include "client/net/address.h"
#include "client/net/server_link.h"
#include "client/play/offered.h"
#include "client/play/placing.h"
#include "client/play/presentation.h"
#include "client/play/rewatch.h"
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

// What to do once the server has greeted: look around, open a table, go to one, play whoever waits
// for this game, or go on where a place is kept.
struct LookAround {};
struct OpenTable {
    protocol::client::CreateTable table;
};
struct GoToTable {
    protocol::client::Join join;
};
struct PlayWhoeverWaits {
    rules::Game game = rules::Game::EightBall;
};
struct GoOn {};
using Errand = std::variant<LookAround, OpenTable, GoToTable, PlayWhoeverWaits, GoOn>;

/// One person, or two at one screen. Never waits: what it asks of the server is answered in a later
/// advance(). All times are local ones.
class Game {
  public:
    /// The seed makes shot ids and the jitter between attempts; no two runs should share it.
    explicit Game(std::uint64_t seed) : seed_(seed) {}

    /// Leaves what was before. A token comes back to an earlier session; where the server does not
    /// know it any more, the player is a new one.
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
    /// Of the match as it is played, or as it is watched from its start.
    const Presentation& presentation() const {
        return is_rewatching() ? rewatch_->presentation() : presentation_;
    }
    /// The balls as they are shown; one in hand is where it is held.
    std::vector<ShownBall> balls(base::Instant now) const;

    // In the lobby, and at a table between two matches.
    void join(const protocol::client::Join& join);
    void open_table(const protocol::client::CreateTable& table);
    void ready();
    /// As ready(), for another match between the same two.
    void rematch();
    /// Ready was said, and counts: the match has not started yet, nor changed what will be played.
    bool has_asked_to_start() const;
    /// Back to the lobby, once the server says so.
    void leave_table();
    bool is_leaving() const { return leaving_.has_value(); }

    // By the owner of the table.
    void change_table(const protocol::client::ChangeTable& change);
    void make_invite(protocol::Role role);
    void revoke_invites();
    void kick(const std::string& name);
    const std::optional<protocol::server::InviteMade>& invite() const { return state_.last_invite; }

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
    void mute(const std::string& name);
    void unmute(const std::string& name);
    void skip_roll();

    /// What may be asked for now, besides the shot.
    Offered offered(base::Instant now) const;
    // Where offered() has it.
    void extend();
    void offer(match::OfferKind kind);
    void answer_offer(bool accept);
    void claim_stalemate();
    void spot_nearest();
    void claim_match();

    // Watching from the start, while the live match goes on unseen.
    void watch_from_start();
    void watch_live() { rewatch_.reset(); }
    /// Null where what is shown is live, or its steps have not come yet.
    Rewatch* rewatch() { return is_rewatching() ? &*rewatch_ : nullptr; }
    const Rewatch* rewatch() const { return is_rewatching() ? &*rewatch_ : nullptr; }
    bool is_rewatching() const { return rewatch_ && rewatch_->steps() > 0; }

    // Practice.
    void place_ball(model::BallId ball, base::Vec2 at_m);
    void undo();
    void repeat();
    void rerack();

    /// What the server would not do, in words; until the next thing is asked.
    const std::string& refusal() const { return refusal_; }
    void forget_refusal() { refusal_.clear(); }

  private:
    void take(const LinkEvent& event);
    void on(const Arrived& arrived);
    void on(const LinkLost& lost);
    void listen_for_farewell(const protocol::ServerMessage& message);
    void run_errand();
    void start_turn_if_new();
    void send_seen();
    void show_aim(base::Instant now);
    std::uint32_t send(protocol::ClientMessageBody body);
    /// Sends what is answered by what happens, or by a refusal.
    void ask(protocol::ClientMessageBody body);
    void ask_for_steps();
    void go_to_lobby();
    /// Sends what moves the match on; nothing else is sent until it is answered.
    void send_move(protocol::ClientMessageBody body);
    std::uint64_t next_shot_id();

    /// The server and the name of connect(), where its token is not known any more.
    struct Known {
        ServerAddress address;
        std::string name;
    };

    std::uint64_t seed_;
    std::uint64_t shots_sent_ = 0;
    std::unique_ptr<ServerLink> link_;
    std::optional<Known> forgotten_by_;  ///< Greeted with a token; none once it is welcome.
    bool is_forgotten_ = false;
    std::string lost_;
    std::string farewell_;  ///< What the server said last, where that tells why it closes the link.
    bool coming_back_ = false;
    std::string refusal_;
    Errand errand_;
    ClientState state_;
    Presentation presentation_;
    ShotControl shot_;
    std::optional<Placing> placing_;
    std::optional<Rewatch> rewatch_;
    std::optional<std::uint32_t> rewatch_asked_;  ///< The request for its next steps.
    std::optional<model::TurnNumber> turn_;       ///< The one that `shot_` and `placing_` are for.
    std::optional<std::uint32_t> awaited_;        ///< The request that moves the match on.
    bool shoots_once_placed_ = false;
    bool asked_to_start_ = false;           ///< Not answered yet.
    std::optional<std::uint32_t> leaving_;  ///< The request to leave the table.
    std::optional<model::Shot> shown_aim_;
    base::Instant aim_sent_at_{};
    base::Instant now_{};
};

}  // namespace billiards::client
