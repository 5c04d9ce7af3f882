// Takes events; holds them back until their time has come.
#include "server/table/gallery.h"

#include <algorithm>
#include <utility>

namespace billiards::server {

Gallery::Gallery(const LobbyLimits& limits)
    : most_events_(limits.delayed_events),
      most_bytes_(limits.delayed_bytes),
      log_({.events = limits.kept_events, .bytes = limits.kept_event_bytes}) {}

void Gallery::set_delay(base::Duration delay, const Picture& shown, std::uint64_t stream) {
    delay_ = delay;
    if (is_delayed_ || delay == base::Duration::zero()) return;
    is_delayed_ = true;
    shown_ = shown;
    late_ = {};
    stream_ = stream;
    log_.skip_to(shown.sequence);
}

void Gallery::add(base::Instant now, protocol::SharedFrame event, Picture after) {
    const std::size_t bytes = event->size() + kWaitingEventBytes;
    if (is_full(bytes)) return jump(now, std::move(after));
    push(now, {.due = {},
               .frame = std::move(event),
               .bytes = bytes,
               .delivery = Delivery::Sheddable,
               .after = std::move(after)});
}

void Gallery::add(base::Instant now, protocol::SharedFrame remark, Delivery delivery) {
    const std::size_t bytes = remark->size() + kWaitingRemarkBytes;
    if (is_full(bytes)) return;
    push(
        now,
        {.due = {}, .frame = std::move(remark), .bytes = bytes, .delivery = delivery, .after = {}});
}

/// A jump that waits already is shown in its time: else a queue that fills up again and again
/// within the delay would never show anything.
void Gallery::jump(base::Instant now, Picture to) {
    std::optional<Item> earlier;
    if (!queue_.empty() && !queue_.front().frame) earlier = std::move(queue_.front());
    queue_.clear();
    bytes_ = 0;
    if (earlier) queue_.push_back(std::move(*earlier));
    push(now, {.due = {},
               .frame = nullptr,
               .bytes = 0,
               .delivery = Delivery::Fresh,
               .after = std::move(to)});
}

bool Gallery::is_full(std::size_t more_bytes) const {
    return queue_.size() >= most_events_ || bytes_ + more_bytes > most_bytes_;
}

/// A shorter delay never lets an event overtake those before it.
void Gallery::push(base::Instant now, Item item) {
    last_due_ = std::max(now + delay_, last_due_);
    item.due = last_due_;
    item.late = last_due_ - now;
    bytes_ += item.bytes;
    queue_.push_back(std::move(item));
}

std::optional<base::Instant> Gallery::next_deadline() const {
    if (queue_.empty()) return std::nullopt;
    return queue_.front().due;
}

std::vector<Gallery::News> Gallery::take_due(base::Instant now) {
    std::vector<News> due;
    while (!queue_.empty() && queue_.front().due <= now) {
        Item item = std::move(queue_.front());
        queue_.pop_front();
        bytes_ -= item.bytes;
        due.push_back(show(now, std::move(item)));
    }
    if (queue_.empty() && delay_ == base::Duration::zero()) is_delayed_ = false;
    return due;
}

Gallery::News Gallery::show(base::Instant now, Item item) {
    if (item.after) {
        shown_ = std::move(*item.after);
        late_ = item.late;
    }
    if (item.frame == nullptr) {
        log_.skip_to(shown_.sequence);
        return {protocol::encode(snapshot(now)), item.delivery};
    }
    News news{protocol::encode(told_later(message_in(item.frame), item.late)), item.delivery};
    if (item.after) log_.append(news.frame);
    return news;
}

protocol::server::TableRow Gallery::row() const {
    protocol::server::TableChanged told{.sequence = shown_.sequence, .row = shown_.row};
    return std::get<protocol::server::TableChanged>(told_later(std::move(told), late_)).row;
}

protocol::server::TableSnapshot Gallery::snapshot(base::Instant now) const {
    auto told = told_later(snapshot_of(shown_, now - late_), late_);
    auto snapshot = std::get<protocol::server::TableSnapshot>(std::move(told));
    snapshot.stream = stream_;
    return snapshot;
}

}  // namespace billiards::server
