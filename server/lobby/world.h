// Gives the inside of the lobby: every session, player and table, and what each message does.
#pragma once

#include "server/lobby/lobby.h"
#include "server/lobby/table_feed.h"
#include "server/session/deadlines.h"
#include "server/session/opened_tables.h"
#include "server/session/players.h"
#include "server/session/session.h"
#include "server/table/refuse.h"
#include "server/table/surroundings.h"
#include "server/table/table.h"

#include <cstdint>
#include <map>
#include <optional>
#include <string>

namespace billiards::server {

/// One message, as its handler sees it.
struct Heard {
    base::Instant now;
    Session& session;  ///< Gone once it is closed: nothing may follow that.
    std::uint32_t request_id = 0;

    Asker asker() const { return {session.id, request_id}; }
};

/// A player whose row is on its way to the disk.
struct Entering {
    Asker asker{};
    PlayerId player{};
    protocol::ResumeToken token{};
    std::optional<protocol::client::Followed> followed{};
    bool is_new = false;
};

struct Lobby::World {
    World(const LobbyLimits& limits, Outbox& outbox, Committer& committer, Archive& archive,
          RandomBytes random);

    // world.cpp: sessions, tables and time
    void connect(base::Instant now, SessionId id, AddressKey from);
    void receive(base::Instant now, Session& session, const protocol::ClientMessage& message);
    /// Counts, and closes the session at LobbyLimits::illegal_messages.
    void refuse_illegal(base::Instant now, Session& session, std::uint32_t request_id,
                        protocol::RefusedCode code, const std::string& detail);
    void close(base::Instant now, Session& session);
    /// The connection is gone: its player is away from the table.
    void forget(base::Instant now, Session& session);
    void expire(base::Instant now, Session& session);
    void advance(base::Instant now, Table& table, protocol::TableId id);
    void close_table(protocol::TableId id);
    void refresh_deadline(protocol::TableId id);
    void count_unsolvable(SessionId id);
    /// Tables whose rows a disk did not take that works again.
    bool are_saves_due() const { return !around.stats.storage_failing && !around.unsaved.empty(); }
    void save_what_failed();
    Session* session_of(SessionId id);
    Table* table_of(protocol::TableId id);
    void tell(SessionId to, const protocol::ServerMessage& message);
    void announce(const protocol::server::Notice& notice);
    /// When the next thing is to be done that no session or table waits for.
    std::optional<base::Instant> next_errand() const;
    void run_errands(base::Instant now);
    std::optional<base::Instant> probe_due() const;
    void probe_storage(base::Instant now);

    // restore.cpp: what was durable when the server started; the error says why it stays away
    base::Result<base::Done, std::string> restore(base::Instant now, const StoredWorld& world,
                                                  const StoredTable& stored);
    base::Result<Table::Sitters, std::string> sitters_of(
        const StoredTable& stored, const std::optional<Table::Played>& played);

    // greeting.cpp: who a session is
    void on(const Heard& heard, const protocol::client::Hello& hello);
    void enrol(const Heard& heard, const std::string& name);
    void resume(const Heard& heard, const protocol::ResumeToken& used,
                const std::optional<protocol::client::Followed>& followed);
    void enter(const Heard& heard, Player& player, Entering entering);
    void settle(base::Instant now, const Entering& entering, bool durable);
    void welcome(base::Instant now, Session& session, Player& player, const Entering& entering);
    void confirm_token(Session& session);

    // play.cpp: what a player asks of the match
    void on(const Heard& heard, const protocol::client::Ready& message);
    void on(const Heard& heard, const protocol::client::Rematch& message);
    /// Every message that is a command of the match as it stands.
    void on(const Heard& heard, const match::Command& command);
    void on(const Heard& heard, const protocol::client::PlaceCueBall& message);
    void on(const Heard& heard, const protocol::client::Aim& message);
    void on(const Heard& heard, const protocol::client::TakeShot& message);
    void on(const Heard& heard, const protocol::client::Seen& message);
    void on(const Heard& heard, const protocol::client::ClaimMatch& message);
    void ask(const Heard& heard, Table::Command command);

    // ownership.cpp: what the owner of a table may do
    void on(const Heard& heard, const protocol::client::ChangeTable& message);
    void on(const Heard& heard, const protocol::client::MakeInvite& message);
    void on(const Heard& heard, const protocol::client::RevokeInvites& message);
    void on(const Heard& heard, const protocol::client::Kick& message);
    Table* owned_table(const Heard& heard, const char* otherwise);
    bool is_at(const Player& player, protocol::TableId id);
    void send_away(const Heard& heard, Table& table, Player& guest);
    void pass_on(base::Instant now, Table& table);

    // places.cpp: who sits or stands where
    void on(const Heard& heard, const protocol::client::CreateTable& message);
    void on(const Heard& heard, const protocol::client::Join& message);
    void on(const Heard& heard, const protocol::client::QuickMatch& message);
    void on(const Heard& heard, const protocol::client::Leave& message);
    void open_table(const Heard& heard, const std::string& name, const match::Settings& settings,
                    Access access, protocol::Role role);
    std::optional<protocol::TableId> waiting_table(const match::Settings& settings,
                                                   PlayerId asker) const;
    void take_place(const Heard& heard, protocol::TableId id, protocol::Role role,
                    const Shown& shown);
    void return_to_lobby(base::Instant now, Session& session);
    void close_idle_table_of(Player& player);

    // following.cpp: which tables there are
    void on(const Heard& heard, const protocol::client::ListTables& message);
    void on(const Heard& heard, const protocol::client::FollowTables& message);
    void tell_followers(base::Instant now);
    void send_tables(base::Instant now, SessionId to);
    /// None where the table is not in the list.
    std::optional<protocol::server::TableRow> public_row(protocol::TableId id);

    // questions.cpp: what has been played
    void on(const Heard& heard, const protocol::client::AskHistory& message);
    void on(const Heard& heard, const protocol::client::AskRecord& message);
    void on(const Heard& heard, const protocol::client::AskReplay& message);
    void inquire(const Heard& heard, Question question);
    void hand_on(const Asker& asker, const ArchiveAnswer& answer);

    // requests.cpp: the rest, and what all requests need
    void on(const Heard& heard, const protocol::client::Chat& message);
    void on(const Heard& heard, const protocol::client::Ping& message);
    bool may_ask_lobby(const Heard& heard);
    bool refuse_while_closing(const Heard& heard);
    Table& table_at(const Heard& heard);
    Player& player_at(const Heard& heard);

    Surroundings around;
    Archive& archive;
    std::map<SessionId, Session> sessions;
    Players players;
    std::map<protocol::TableId, Table> tables;
    OpenedTables opened_tables;
    Deadlines<SessionId> session_deadlines;
    Deadlines<protocol::TableId> table_deadlines;

    /// One frame for all who ask within LobbyLimits::table_list_kept, unless a seat was taken or
    /// left.
    struct TableListFrame {
        protocol::SharedFrame frame;
        base::Instant made;
    };
    std::optional<TableListFrame> table_list;
    TableFeed feed;

    bool is_probing = false;  ///< A probe of the disk is on its way.
    base::Instant probed{};   ///< When it was last tried so, or did not fail yet.

    std::uint64_t last_player = 0;
    std::uint32_t last_table = 0;
    bool is_closing = false;
};

}  // namespace billiards::server
