// Takes balls that were planned anew; gives the next event, from a table of meetings.
#include "common/physics/agenda.h"

#include <algorithm>

namespace billiards::physics {

namespace {

bool comes_before(const Next& a, const Next& b) {
    if (a.time_s != b.time_s) return a.time_s < b.time_s;
    return a.cause == Cause::MotionEnd && b.cause != Cause::MotionEnd;
}

bool is_changed(std::span<const int> changed, int ball) {
    return std::find(changed.begin(), changed.end(), ball) != changed.end();
}

std::size_t at(int ball) {
    return static_cast<std::size_t>(ball);
}

}  // namespace

void Agenda::update(std::span<const Mover> movers, std::span<const int> changed, double now_s) {
    PerBall<bool> must_choose{};
    for (const int ball : changed) must_choose[at(ball)] = true;
    for (std::size_t ball = 0; ball < movers.size(); ++ball) {
        const Next& next = next_[ball];
        if (next.cause == Cause::Ball && is_changed(changed, next.index)) must_choose[ball] = true;
    }
    PerBall<bool> is_done{};
    for (const int ball : changed) {
        is_done[at(ball)] = true;
        for (int other = 0; other < static_cast<int>(movers.size()); ++other) {
            if (is_done[at(other)]) continue;
            const double time = meet(movers, ball, other, now_s);
            Next& next = next_[at(other)];
            if (!must_choose[at(other)] && time < next.time_s) {
                next = {.time_s = time, .cause = Cause::Ball, .index = ball};
            }
        }
    }
    for (int ball = 0; ball < static_cast<int>(movers.size()); ++ball) {
        if (must_choose[at(ball)]) choose(movers, ball);
    }
}

double Agenda::meet(std::span<const Mover> movers, int ball, int other, double now_s) {
    const Mover& a = movers[at(ball)];
    const Mover& b = movers[at(other)];
    const bool are_in_play = a.is_in_play() && b.is_in_play();
    const double time = are_in_play ? meeting_time_s(a, b, now_s) : kNever_s;
    meetings_s_[at(ball)][at(other)] = time;
    meetings_s_[at(other)][at(ball)] = time;
    return time;
}

void Agenda::choose(std::span<const Mover> movers, int ball) {
    Next& next = next_[at(ball)];
    next = movers[at(ball)].alone;
    for (int other = 0; other < static_cast<int>(movers.size()); ++other) {
        const double time = meetings_s_[at(ball)][at(other)];
        if (other != ball && time < next.time_s) {
            next = {.time_s = time, .cause = Cause::Ball, .index = other};
        }
    }
}

Agenda::Entry Agenda::first(std::span<const Mover> movers) const {
    Entry entry;
    for (int ball = 0; ball < static_cast<int>(movers.size()); ++ball) {
        if (comes_before(next_[at(ball)], entry.next)) entry = {ball, next_[at(ball)]};
    }
    return entry;
}

}  // namespace billiards::physics
