// Takes losses and messages; gives delays with jitter, the newest greeting and what
// to say again.
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

/// Of an event at the table; none of what is for one session alone.
std::optional<std::uint64_t> sequence_of(const protocol::ServerMessage& message) {
    return std::visit(
        []<class Message>(const Message& body) -> std::optional<std::uint64_t> {
            if constexpr (requires { body.sequence; }) return body.sequence;
            return std::nullopt;
        },
        message);
}

}  // namespace

Reconnect::Reconnect(std::string name, std::optional<protocol::ResumeToken> token,
                     std::uint64_t seed, const ReconnectLimits& limits)
    : name_(std::move(name)), token_(token), random_(seed), limits_(limits) {}

protocol::client::Hello Reconnect::hello() const {
    return {.name = name_,
            .token = token_,
            .followed = token_ ? followed_ : std::optional<protocol::client::Followed>()};
}

bool Reconnect::sent(const protocol::ClientMessage& message) {
    return !unanswered_.sent(message) || !is_table_due_;
}

void Reconnect::received(const protocol::ServerMessage& message, base::Instant now) {
    if (const auto* welcome = std::get_if<protocol::server::Welcome>(&message)) {
        token_ = welcome->token;
        welcomed_ = now;
        was_ever_welcomed_ = true;
        is_table_due_ = welcome->table.has_value();
        if (!welcome->table) followed_.reset();
    } else if (const auto* refused = std::get_if<protocol::server::Refused>(&message)) {
        if (refused->code == protocol::RefusedCode::UnknownToken) is_over_ = true;
    } else if (const auto* notice = std::get_if<protocol::server::Notice>(&message)) {
        if (notice->code == protocol::server::NoticeCode::ReplacedByNewConnection) is_over_ = true;
    }
    follow(message);
    unanswered_.received(message);
}

/// After Resumed the table is as it was followed, and events go on from there.
void Reconnect::follow(const protocol::ServerMessage& message) {
    const auto* snapshot = std::get_if<protocol::server::TableSnapshot>(&message);
    if (snapshot != nullptr) {
        followed_ = {.table = snapshot->row.table,
                     .stream = snapshot->stream,
                     .sequence = snapshot->sequence};
    } else if (const auto sequence = sequence_of(message); sequence && followed_) {
        followed_->sequence = std::max(followed_->sequence, *sequence);
    }
    const bool shows_table =
        snapshot != nullptr || std::holds_alternative<protocol::server::Resumed>(message);
    if (shows_table && std::exchange(is_table_due_, false)) is_repeat_due_ = true;
}

std::vector<protocol::ClientMessage> Reconnect::take_repeats() {
    if (!std::exchange(is_repeat_due_, false)) return {};
    return unanswered_.all();
}

std::optional<base::Duration> Reconnect::lost(LostCode code, base::Instant now) {
    if (!was_ever_welcomed_ || is_over_ || is_final(code)) return std::nullopt;
    if (welcomed_) attempts_ = 0;
    if (welcomed_ && now - *welcomed_ >= limits_.stood) delays_ = 0;
    welcomed_.reset();
    if (attempts_ >= limits_.max_attempts) return std::nullopt;
    base::Duration delay = limits_.first_delay;
    for (int i = 0; i < delays_ && delay < limits_.max_delay; ++i) delay *= 2;
    delay = std::min(delay, limits_.max_delay);
    ++attempts_;
    if (delay < limits_.max_delay) ++delays_;
    return base::duration_of(base::seconds(delay) * random_.uniform(0.5, 1.0));
}

}  // namespace billiards::client
