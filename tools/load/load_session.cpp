// Takes messages from a link; records, and answers through the player it holds.
#include "tools/load/load_session.h"

#include "client/net/clock.h"

#include <utility>
#include <variant>

namespace billiards::tools {

namespace {

constexpr base::Duration kShortestAbsence = std::chrono::milliseconds(10);
constexpr base::Duration kLongestAbsence = std::chrono::milliseconds(500);

/// Within what a session may ask at once.
constexpr int kListsOfAStalledOne = 25;

base::Duration spread(base::Random& random, base::Duration from, base::Duration to) {
    return base::duration_of(random.uniform(base::seconds(from), base::seconds(to)));
}

}  // namespace

LoadSession::LoadSession(asio::io_context& io, LoadSessionOptions options, Recorder& recorder,
                         std::function<void(protocol::TableId)> in_place)
    : options_(std::move(options)),
      recorder_(recorder),
      in_place_(std::move(in_place)),
      reconnect_(options_.name, std::nullopt, options_.seed),
      random_(options_.seed),
      io_(io),
      retry_(io),
      drop_(io),
      act_(io) {
    if (options_.player) {
        player_.emplace(*options_.player, options_.events,
                        [this](protocol::ClientMessageBody body) { return send(std::move(body)); });
    }
    connect();
}

void LoadSession::connect() {
    client::Link::Callbacks callbacks;
    callbacks.connected = [this] {
        recorder_.connected(client::local_now());
        link_->send({.request_id = 0, .body = reconnect_.hello()});
    };
    callbacks.message = [this](protocol::ServerMessage&& message, std::size_t frame_bytes) {
        received(message, frame_bytes);
    };
    callbacks.lost = [this](const client::Lost& lost) { this->lost(lost); };
    link_.emplace(io_.get_executor(), options_.address, std::move(callbacks));
}

std::uint32_t LoadSession::send(protocol::ClientMessageBody body) {
    const protocol::ClientMessage message{++last_request_id_, std::move(body)};
    if (!reconnect_.sent(message) || !is_welcome_) return message.request_id;
    if (const auto* take = std::get_if<protocol::client::TakeShot>(&message.body)) {
        link_->send(message, [this, shot_id = take->shot_id] {
            recorder_.shot_sent(shot_id, client::local_now());
            if (options_.shot_sent) options_.shot_sent();
        });
    } else {
        link_->send(message);
    }
    return message.request_id;
}

void LoadSession::received(const protocol::ServerMessage& message, std::size_t frame_bytes) {
    const base::Instant now = client::local_now();
    reconnect_.received(message, now);
    if (const auto* shot = std::get_if<protocol::server::ShotPlayed>(&message)) {
        recorder_.shot_received(*shot, frame_bytes, now);
    } else if (const auto* welcome = std::get_if<protocol::server::Welcome>(&message)) {
        on_welcome(*welcome, now);
    } else if (const auto* snapshot = std::get_if<protocol::server::TableSnapshot>(&message)) {
        if (is_in_place_ && !is_here_) recorder_.resumed(Recorder::Way::Snapshot);
        on_place(snapshot->row.table, now);
    } else if (const auto* resumed = std::get_if<protocol::server::Resumed>(&message)) {
        recorder_.resumed(Recorder::Way::Ring);
        on_place(resumed->table, now);
    } else if (const auto* refused = std::get_if<protocol::server::Refused>(&message)) {
        recorder_.error("refused: " + refused->detail);
    }
    for (const auto& repeated : reconnect_.take_repeats()) link_->send(repeated);
    if (!player_ || player_->is_finished()) return;
    player_->received(message, now);
    player_->advance_time(now);
    if (!player_->failure().empty()) give_up(player_->failure());
    wait_for_player();
}

void LoadSession::on_welcome(const protocol::server::Welcome& welcome, base::Instant now) {
    if (gone_since_) recorder_.reconnected(now - *gone_since_);
    is_welcome_ = true;
    if (options_.stalls) return stall(now);
    link_->keep_alive();
    if (!player_ && !welcome.table) {
        send(protocol::client::Join{.table = options_.table, .role = protocol::Role::Spectator});
    }
    drop_later();
}

void LoadSession::stall(base::Instant now) {
    link_->pause_reading();
    for (int i = 0; i < kListsOfAStalledOne; ++i) send(protocol::client::ListTables{});
    send(protocol::client::Join{.table = options_.table, .role = protocol::Role::Spectator});
    on_place(options_.table, now);
}

void LoadSession::on_place(protocol::TableId table, base::Instant now) {
    if (options_.stops_reading_when_in_place) link_->pause_reading();
    if (gone_since_) recorder_.returned(now - *gone_since_, now);
    gone_since_.reset();
    is_here_ = true;
    if (is_in_place_) return;
    is_in_place_ = true;
    in_place_(table);
}

void LoadSession::lost(const client::Lost& lost) {
    gone();
    drop_.cancel();
    recorder_.error("link lost: " + lost.reason);
    const auto delay = reconnect_.lost(lost.code, client::local_now());
    if (delay) return connect_after(*delay);
    if (failure_.empty()) failure_ = lost.reason;
}

void LoadSession::give_up(const std::string& why) {
    failure_ = why;
    recorder_.error(why);
}

void LoadSession::gone() {
    if (is_here_) {
        gone_since_ = client::local_now();
        recorder_.lost_place(*gone_since_);
    }
    if (is_welcome_) ++links_lost_;
    is_welcome_ = false;
    is_here_ = false;
    if (player_) player_->link_lost();
}

void LoadSession::call_after(asio::steady_timer& timer, base::Duration delay,
                             void (LoadSession::*what)()) {
    timer.expires_after(delay);
    timer.async_wait([this, what, alive = std::weak_ptr(alive_)](const asio::error_code& error) {
        if (!error && !alive.expired()) (this->*what)();
    });
}

void LoadSession::connect_after(base::Duration delay) {
    call_after(retry_, delay, &LoadSession::connect);
}

void LoadSession::drop_later() {
    if (options_.drops_after == base::Duration::zero()) return;
    call_after(drop_, spread(random_, options_.drops_after / 4, options_.drops_after),
               &LoadSession::drop);
}

void LoadSession::drop() {
    link_.reset();
    gone();
    connect_after(spread(random_, kShortestAbsence, kLongestAbsence));
}

void LoadSession::wait_for_player() {
    const std::optional<base::Instant> next = player_->next_deadline();
    if (!next) {
        act_.cancel();
        return;
    }
    call_after(act_, *next - client::local_now(), &LoadSession::act);
}

void LoadSession::act() {
    player_->advance_time(client::local_now());
    wait_for_player();
}

}  // namespace billiards::tools
