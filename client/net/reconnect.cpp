// Takes losses and messages; gives delays with jitter, the newest token and the unanswered shot.
#include "client/net/reconnect.h"

#include <algorithm>
#include <utility>
#include <variant>

namespace billiards::client {

namespace {

/// What no waiting mends.
bool is_final(LostCode code) {
    return code == LostCode::OtherVersion || code == LostCode::NotAServer;
}

bool ends_the_match(const protocol::ServerMessage& message) {
    const auto* notice = std::get_if<protocol::server::Notice>(&message);
    return std::holds_alternative<protocol::server::MatchStarted>(message) ||
           std::holds_alternative<protocol::server::MatchOver>(message) ||
           (notice != nullptr && notice->code == protocol::server::NoticeCode::TableClosed);
}

}  // namespace

Reconnect::Reconnect(std::string name, std::optional<protocol::ResumeToken> token,
                     std::uint64_t seed, const ReconnectLimits& limits)
    : name_(std::move(name)), token_(token), random_(seed), limits_(limits) {}

protocol::client::Hello Reconnect::hello() const {
    return {.name = name_, .token = token_};
}

void Reconnect::sent(const protocol::ClientMessage& message) {
    if (std::holds_alternative<protocol::client::TakeShot>(message.body)) shot_ = message;
    if (std::holds_alternative<protocol::client::Leave>(message.body)) shot_.reset();
}

void Reconnect::received(const protocol::ServerMessage& message, base::Instant now) {
    if (const auto* welcome = std::get_if<protocol::server::Welcome>(&message)) {
        token_ = welcome->token;
        welcomed_ = now;
        was_ever_welcomed_ = true;
        if (!welcome->table) shot_.reset();
    } else if (const auto* refused = std::get_if<protocol::server::Refused>(&message)) {
        if (refused->code == protocol::RefusedCode::UnknownToken) is_over_ = true;
    } else if (const auto* notice = std::get_if<protocol::server::Notice>(&message)) {
        if (notice->code == protocol::server::NoticeCode::ReplacedByNewConnection) is_over_ = true;
    }
    if (shot_ && (is_answered_by(message) || ends_the_match(message))) shot_.reset();
}

bool Reconnect::is_answered_by(const protocol::ServerMessage& message) const {
    const std::uint64_t shot_id = std::get<protocol::client::TakeShot>(shot_->body).shot_id;
    if (const auto* played = std::get_if<protocol::server::ShotPlayed>(&message)) {
        return played->shot_id == shot_id;
    }
    if (const auto* snapshot = std::get_if<protocol::server::TableSnapshot>(&message)) {
        return snapshot->rolling && snapshot->rolling->shot_id == shot_id;
    }
    const auto* refused = std::get_if<protocol::server::Refused>(&message);
    return refused != nullptr && refused->in_reply_to == shot_->request_id;
}

std::optional<base::Duration> Reconnect::lost(LostCode code, base::Instant now) {
    if (!was_ever_welcomed_ || is_over_ || is_final(code)) return std::nullopt;
    if (welcomed_ && now - *welcomed_ >= limits_.stood) attempts_ = 0;
    welcomed_.reset();
    if (attempts_ >= limits_.max_attempts) return std::nullopt;
    base::Duration delay = limits_.first_delay;
    for (int i = 0; i < attempts_ && delay < limits_.max_delay; ++i) delay *= 2;
    delay = std::min(delay, limits_.max_delay);
    ++attempts_;
    return base::duration_of(base::seconds(delay) * random_.uniform(0.5, 1.0));
}

}  // namespace billiards::client
