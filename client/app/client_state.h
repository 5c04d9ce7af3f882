// Gives everything a client knows at one moment: what is drawn, said and allowed comes from here.
#pragma once

#include "common/base/time.h"
#include "common/match/match_state.h"
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

/// A table as this client sees it.
struct TableView {
    protocol::server::TableRow row;
    std::uint64_t sequence = 0;
    std::vector<model::Seat> my_seats;  ///< Empty: a spectator.
    std::optional<match::MatchState> match;
    std::optional<protocol::server::ShotPlayed> last_shot;
    protocol::server::Turn turn;
    std::optional<protocol::server::AimShown> aim;  ///< Of whoever is to shoot.
    std::optional<protocol::server::MatchOver> over;

    friend bool operator==(const TableView&, const TableView&) = default;
};

struct ClientState {
    LinkState link = LinkState::Connecting;
    std::string name;
    std::optional<protocol::ResumeToken> token;
    std::vector<protocol::server::TableRow> tables;
    std::optional<TableView> table;
    std::vector<ChatLine> chat;  ///< The newest kChatKept lines.
    std::optional<protocol::server::Refused> last_refusal;
    std::optional<protocol::server::Notice> last_notice;
    /// Server time minus local time, from the fastest of the last pings.
    std::optional<base::Duration> clock_offset;

    friend bool operator==(const ClientState&, const ClientState&) = default;
};

inline constexpr std::size_t kChatKept = 200;

/// The seat among mine that is to act now, if the match waits for me.
std::optional<model::Seat> my_turn(const ClientState& state);

}  // namespace billiards::client
