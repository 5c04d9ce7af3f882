// Gives everything a client knows at one moment: what is drawn, said and allowed comes from here.
#pragma once

#include "common/base/time.h"
#include "common/match/match_state.h"
#include "common/protocol/limits.h"
#include "common/protocol/messages.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace billiards::client {

enum class LinkState : std::uint8_t { Connecting, Greeting, Ready, Lost };

struct ChatLine {
    std::string name;
    std::string text;
    friend bool operator==(const ChatLine&, const ChatLine&) = default;
};

/// What one ping said of the server's clock.
struct ClockSample {
    base::Duration round_trip{};
    base::Duration offset{};  ///< Server time minus local time, taken half way.
    friend bool operator==(const ClockSample&, const ClockSample&) = default;
};

/// A table as this client sees it.
struct TableView {
    protocol::server::TableRow row;
    std::uint64_t stream = 0;
    std::uint64_t sequence = 0;
    std::vector<model::Seat> my_seats;  ///< Empty: a spectator.
    std::optional<match::MatchState> match;
    std::optional<protocol::server::ShotPlayed> last_shot;
    protocol::server::Turn turn;
    std::optional<protocol::server::AimShown> aim;  ///< Of whoever is to shoot.
    std::optional<protocol::server::MatchOver> over;
    /// Of the match that is over: whether the same two sit there still.
    std::optional<model::PerSeat<std::string>> players_of_match{};

    friend bool operator==(const TableView&, const TableView&) = default;
};

struct ClientState {
    LinkState link = LinkState::Connecting;
    std::string name;
    std::optional<protocol::ResumeToken> token;
    std::vector<protocol::server::TableRow> tables;
    std::optional<TableView> table;
    /// The link was lost, and nothing has said yet that the table is as it was, or how it is now.
    bool is_table_stale = false;
    std::vector<ChatLine> chat;  ///< The newest kChatKept lines, of those who are not muted.
    /// As shown; the newest kMutedKept. They stay muted over every link, at every table.
    std::vector<std::string> muted;
    std::optional<protocol::server::Refused> last_refusal;
    std::optional<protocol::server::Notice> last_notice;
    std::optional<protocol::server::InviteMade> last_invite;
    std::optional<protocol::server::HistoryPage> last_history;
    std::optional<protocol::server::PlayerRecord> last_record;
    std::vector<ClockSample> clock_samples;  ///< The newest kClockSamplesKept.
    /// Server time minus local time, from the fastest of the last pings; before the first pong a
    /// first guess from Welcome, late by the way it took.
    std::optional<base::Duration> clock_offset;

    friend bool operator==(const ClientState&, const ClientState&) = default;
};

inline constexpr std::size_t kChatKept = 200;
inline constexpr std::size_t kMutedKept = 200;
inline constexpr std::size_t kClockSamplesKept = 8;
/// Rows of the list; what changes beyond them is not shown.
inline constexpr std::size_t kTablesKept = protocol::kMaxTableRows;

/// The link is gone; everything that was known stays, as what it was.
ClientState with_link_lost(ClientState state);

/// Without a line of theirs, from now on and of before. Nobody is called "".
ClientState with_muted(ClientState state, const std::string& name);
/// What was said meanwhile does not come back.
ClientState with_unmuted(ClientState state, const std::string& name);
bool is_muted(const ClientState& state, const std::string& name);

/// The seat among mine that is to act now, if the match waits for me and the table is not stale.
/// Whether the turn is open yet
/// is for local_time_of(turn.opens_us) to say.
std::optional<model::Seat> my_turn(const ClientState& state);

/// When, on the local clock, the server's clock shows `server_time_us`; none before any word from
/// the server.
std::optional<base::Instant> local_time_of(const ClientState& state, std::int64_t server_time_us);

}  // namespace billiards::client
