// Takes the events of a shot; gives the facts. Two passes: what counts as "after the first contact"
// is known only once that contact is.
#include "common/rules/facts.h"

namespace billiards::rules {

namespace {

using model::BallId;
using model::BallSet;
using model::EventKind;
using model::kCueBall;
using model::ShotEvent;

/// Contacts this near to each other are one instant: above what the engine's contact times are
/// good to (1e-12 s + 1e-10 t), and far below what anyone could see.
constexpr double kSameInstant_s = 1e-9;

struct FirstContact {
    std::optional<double> time_s;
    BallSet balls;
};

/// The object ball that the cue ball meets in this event, if it is such a meeting.
std::optional<BallId> met_by_cue_ball(const ShotEvent& event) {
    if (event.kind != EventKind::BallBall) return std::nullopt;
    if (event.ball == kCueBall) return event.other;
    if (event.other == kCueBall) return event.ball;
    return std::nullopt;
}

FirstContact first_contact_of(std::span<const ShotEvent> events) {
    FirstContact first;
    for (const ShotEvent& event : events) {
        const std::optional<BallId> met = met_by_cue_ball(event);
        if (!met) continue;
        if (!first.time_s) first.time_s = event.time_s;
        if (event.time_s - *first.time_s > kSameInstant_s) break;
        first.balls.insert(*met);
    }
    return first;
}

/// Whether the event says that its ball was driven to a cushion. A jaw is a cushion; falling into
/// a pocket or off the table counts as well; a held contact is no new one.
bool is_driven_to_cushion(const ShotEvent& event) {
    switch (event.kind) {
        case EventKind::Cushion:
        case EventKind::Jaw:
            return !event.held;
        case EventKind::Pocketed:
        case EventKind::OffTable:
            return true;
        case EventKind::BallBall:
        case EventKind::Motion:
        case EventKind::HeadString:
        case EventKind::Landing:
            return false;
    }
    CHECK(false);
}

void note_fall(const ShotEvent& event, Facts& facts) {
    const bool fell = event.kind == EventKind::Pocketed;
    const bool left = event.kind == EventKind::OffTable;
    if (!fell && !left) return;
    if (event.ball == kCueBall) {
        facts.cue_ball_lost = true;
    } else if (fell) {
        const model::PocketId pocket{static_cast<std::uint8_t>(event.index)};
        facts.pocketed.push_back({event.ball, pocket});
    } else {
        facts.off_table.insert(event.ball);
    }
}

void note_cushion(const ShotEvent& event, const FirstContact& first, Facts& facts) {
    if (!is_driven_to_cushion(event)) return;
    if (event.ball != kCueBall) facts.driven_to_cushion.insert(event.ball);
    if (first.time_s && event.time_s >= *first.time_s)
        facts.driven_after_contact.insert(event.ball);
}

void note_head_string(const ShotEvent& event, const FirstContact& first, Facts& facts) {
    if (event.kind != EventKind::HeadString || event.direction <= 0) return;
    if (!first.time_s || event.time_s < *first.time_s) facts.crossed_head_string = true;
}

}  // namespace

Facts facts_of(std::span<const ShotEvent> events) {
    const FirstContact first = first_contact_of(events);
    Facts facts;
    facts.first_contacts = first.balls;
    for (const ShotEvent& event : events) {
        note_fall(event, facts);
        note_cushion(event, first, facts);
        note_head_string(event, first, facts);
    }
    return facts;
}

BallSet fallen_balls(const Facts& facts) {
    BallSet fallen;
    for (const PocketedBall& pocketed : facts.pocketed) fallen.insert(pocketed.ball);
    return fallen;
}

}  // namespace billiards::rules
