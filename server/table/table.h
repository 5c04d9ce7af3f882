// Takes what people at one table do and what time it is; gives frames to everyone there and steps
// to the journal. Knows the network only as Outbox, the disk only as Committer.
#pragma once

#include "common/base/result.h"
#include "common/base/time.h"
#include "common/match/match.h"
#include "common/match/match_state.h"
#include "common/protocol/codec_journal.h"
#include "common/protocol/messages.h"
#include "server/session/rate_limit.h"
#include "server/store/match_store.h"
#include "server/table/absence.h"
#include "server/table/access.h"
#include "server/table/event_log.h"
#include "server/table/gallery.h"
#include "server/table/outbox.h"
#include "server/table/refold.h"
#include "server/table/refuse.h"
#include "server/table/seating.h"
#include "server/table/surroundings.h"
#include "server/table/turn_clock.h"

#include <cstdint>
#include <deque>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace billiards::server {

/// Its match moves by one step at a time: a command is applied to the last committed state,
/// journalled, and published once that is durable. Commands that come meanwhile wait.
class Table {
  public:
    /// The settings must be such that match::start takes them.
    Table(protocol::TableId id, std::string name, const match::Settings& settings, Access access,
          Surroundings& around, base::Instant now);
    Table(const Table&) = delete;
    Table& operator=(const Table&) = delete;

    struct Sitter {
        PlayerId player;
        std::string name;
    };
    using Sitters = model::PerSeat<std::optional<Sitter>>;
    struct Played {
        StoredMatch match;
        Refolded refolded;
    };
    /// As before a restart, just opened: those who sat here are away, the clock of the match is
    /// full.
    void restore(base::Instant now, const Sitters& sitters, const std::optional<Played>& played);

    /// The newcomer gets a snapshot, the others the change. A seat and the invite that it uses up
    /// are durable together. The error says what is full.
    base::Result<base::Done, protocol::RefusedCode> join(base::Instant now, const Visitor& visitor,
                                                         protocol::Role role,
                                                         const Admission& admission);
    /// Whether who sat or stood here before still has a place.
    bool has_place_for(PlayerId player) const;
    /// Takes that place again, under a new connection. Who had followed the table up to an event
    /// that is not forgotten yet is told what came after it; anyone else is answered as by join.
    void come_back(base::Instant now, const Visitor& visitor,
                   const std::optional<protocol::client::Followed>& followed = std::nullopt);
    /// A snapshot, for a spectator who has lost what came before.
    void refresh(base::Instant now, SessionId session);
    /// Refused to players while a match runs.
    base::Result<base::Done, protocol::RefusedCode> leave(base::Instant now, SessionId session);
    /// Frees the player's seats, connected or not. MatchRunning while one is played.
    base::Result<base::Done, protocol::RefusedCode> vacate(base::Instant now, PlayerId player);
    void lose(base::Instant now, SessionId session);
    /// Tells those who are left; the match, if one runs, ends without a winner. No step may be on
    /// its way.
    void close();
    /// What is durable of the table, where that has changed. A seat does not wait for the disk; a
    /// match does, and is never durable without its table.
    void save();
    /// Likewise, where the disk may not have what was last sent to it.
    void save_again();
    /// For the next match; whoever was ready is asked again. MatchRunning while one is played.
    base::Result<base::Done, protocol::RefusedCode> change_settings(
        base::Instant now, const match::Settings& settings);
    /// Another one owns the table from now on.
    void owner_changed(base::Instant now);

    /// What a player asks of the match.
    struct Command {
        match::Command command;
        std::uint64_t shot_id = 0;                     ///< Of a TakeShot.
        std::optional<model::TurnNumber> only_turn{};  ///< For commands that do not name theirs.
    };

    void ready(base::Instant now, const Asker& asker);
    /// As ready, once a match is over and while the same two sit here.
    void rematch(base::Instant now, const Asker& asker);
    /// The match for the asker, whose opponent has been away for longer than the grace.
    void claim(base::Instant now, const Asker& asker);
    void request(base::Instant now, const Asker& asker, Command command);
    void aim(base::Instant now, SessionId session, const protocol::client::Aim& aim);
    void seen(base::Instant now, SessionId session, std::uint64_t sequence);
    /// The text is clean.
    void say(base::Instant now, const Asker& asker, const std::string& name,
             const std::string& text);

    /// None while a step is on its way to the disk, but for what does not depend on it.
    std::optional<base::Instant> next_deadline() const;
    void advance(base::Instant now);

    const Seating& seating() const { return seating_; }
    bool is_playing() const { return match_ && match_->state.stage != match::Stage::Over; }
    /// No player has been connected for LobbyLimits::empty_table_kept, and no step is on its way.
    bool is_abandoned(base::Instant now) const;
    /// No player is connected, and nothing would be lost by closing it.
    bool is_idle() const;
    /// As everyone may see it who has no seat here: late, where its spectators are.
    protocol::server::TableRow row() const;
    const match::Settings& settings() const { return settings_; }
    /// Who may come in. The lobby asks it, and says so to the table where it changed.
    Access& access() { return access_; }
    const Access& access() const { return access_; }
    StoredTable stored() const;
    struct ShownMatch {
        MatchId match;
        /// So many of them, with how it began. None: what everybody may see of it, once it is over.
        std::optional<std::uint64_t> steps;
    };
    /// The match that is played, or the last one, as far as this session has seen it.
    std::optional<ShownMatch> match_shown_to(SessionId session) const;

  private:
    struct LastShot {
        std::uint64_t shot_id = 0;
        protocol::SharedFrame frame;
    };
    struct Match {
        MatchId id;
        model::PerSeat<PlayerId> players;
        match::MatchState state;  ///< As last committed.
        std::uint64_t entries = 0;
        bool was_private = false;  ///< When it began; true where nobody knows any more.
        model::PerSeat<std::optional<LastShot>> last_shots{};
    };
    struct Rolling {
        std::uint64_t sequence = 0;
        protocol::SharedFrame frame;  ///< ShotPlayed.
        base::Instant rests{};
        model::PerSeat<bool> seen{};
    };
    struct Request {
        std::optional<Asker> asker;  ///< None: the clock.
        model::PerSeat<bool> seats;  ///< Those the asker held.
        Command what;
    };
    // What becomes true when it is durable.
    struct Start {
        Match match;
    };
    struct Step {
        std::optional<Asker> asker;
        protocol::JournalEntry entry;
        match::MatchState next;
    };
    using Pending = std::variant<std::monostate, Start, Step>;

    // table.cpp: people
    bool is_pending() const { return !std::holds_alternative<std::monostate>(pending_); }
    /// From when the match is on its way to the disk until it is over.
    bool is_between_matches() const;
    bool has_room_to_watch() const;
    std::optional<protocol::RefusedCode> take_places(const Visitor& visitor, protocol::Role role);
    void seats_changed(base::Instant now, std::optional<SessionId> except = std::nullopt);
    void spectators_changed(base::Instant now);
    void count_absence(base::Instant now);
    bool are_players_of_last_match() const;

    // table_time.cpp: what waits for time
    void open_turn(base::Instant now, std::optional<SessionId> except = std::nullopt);
    void open_turn_if_all_have_seen(base::Instant now,
                                    std::optional<SessionId> except = std::nullopt);
    void free_seats_of_absent(base::Instant now);
    std::optional<base::Instant> clock_runs_out() const;

    // table_requests.cpp: what may be asked of the match
    bool refuse_too_many(base::Instant now, const Asker& asker, const match::Command& command);
    void enqueue(base::Instant now, Request request);
    bool refuse_claim(base::Instant now, const Request& request);
    void run(base::Instant now, const Request& request);
    bool answer_repeat(const Request& request);
    bool refuse_too_long(const Request& request);
    bool refuse_early(const Request& request);
    bool refuse_stale(const Request& request);
    model::Seat acting_seat(const Request& request) const;

    // table_steps.cpp: the journal, and what follows when the disk has answered
    std::optional<base::Duration> time_allowed() const;
    void commit(base::Instant now, Step step);
    void start_match(base::Instant now);
    MatchResult result_of(const match::MatchState& state, protocol::server::Ending ending) const;
    void submit(base::Instant now, Pending pending, std::vector<Write> writes);
    void submit_and_forget(std::vector<Write> writes);
    void settle(const Committed& committed);
    void restore_match(base::Instant now, const Played& played);
    void restore_gallery(base::Instant now);
    void happen(base::Instant now, Start start);
    void happen(base::Instant now, Step step, const Committed& committed);
    void go_on(base::Instant now, const Step& step, model::TurnNumber before);
    void undo_start(base::Instant now);
    void undo_step(base::Instant now, const Step& step);

    // table_frames.cpp: what is told
    template <class Event>
    protocol::SharedFrame numbered(Event event);
    void publish(base::Instant now, const protocol::SharedFrame& frame,
                 std::optional<SessionId> except = std::nullopt);
    /// What has no number: an aim, a remark.
    void show_spectators(base::Instant now, const protocol::SharedFrame& frame, Delivery delivery);
    void deliver_to_spectators(const protocol::SharedFrame& frame, Delivery delivery);
    void show_what_is_due(base::Instant now);
    void delay_gallery(base::Instant now, const Picture& shown);
    bool is_shown_late(SessionId session) const;
    Picture picture() const;
    protocol::server::TableRow row_now() const;
    void send_snapshot(base::Instant now, SessionId to);
    void catch_up(base::Instant now, SessionId to,
                  const std::optional<protocol::client::Followed>& followed);
    void announce_seats(base::Instant now, std::optional<SessionId> except = std::nullopt);
    void announce_turn(base::Instant now, std::optional<SessionId> except = std::nullopt);
    void announce_start(base::Instant now);
    void announce_shot(base::Instant struck, Step step, const Committed& committed);
    void announce_move(base::Instant now, Step step);
    void announce_over(base::Instant now, protocol::server::Ending ending);
    void announce_change(base::Instant now);
    void announce_closing();
    void announce_storage_failed(base::Instant now, const std::optional<Asker>& asker);
    model::PerSeat<protocol::server::SeatView> seat_views() const;

    const protocol::TableId id_;
    const std::string name_;
    match::Settings settings_;  ///< Of the next match.
    Access access_;
    Surroundings& around_;

    Seating seating_;
    Absence absence_;
    std::optional<Match> match_;  ///< The last one stays until the next starts.
    std::optional<Rolling> rolling_;
    TurnClock clock_;

    std::uint64_t stream_;        ///< Of the sequence numbers; drawn anew with each start.
    std::uint64_t sequence_ = 0;  ///< Of the last event told to everyone here.
    EventLog log_;
    Gallery gallery_;
    std::optional<StoredTable> saved_;  ///< As last sent to the disk.

    Pending pending_;
    base::Instant submitted_{};  ///< When what is pending was.
    std::deque<Request> queue_;  ///< Empty unless a step is pending.

    std::optional<base::Instant> deserted_since_;  ///< No player has been connected since.
    std::optional<base::Instant> announce_spectators_at_;
    RateLimit aim_to_players_;
    RateLimit aim_to_spectators_;
    RateLimit placements_;
    RateLimit practice_shots_;
    RateLimit players_chat_;
    RateLimit stand_chat_;  ///< Of the spectators: however loud they are, the players can talk.
};

}  // namespace billiards::server
