// Takes balls; gives their shot and what tests ask of it.
#pragma once

#include "common/physics/simulate.h"
#include "common/timeline/evaluate.h"
#include "tests/common/physics/layouts.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <iterator>
#include <ostream>
#include <stdexcept>
#include <vector>

namespace billiards::physics {

using model::EventKind;
using model::Motion;

inline void PrintTo(const Error& error, std::ostream* out) {
    *out << "error " << static_cast<int>(error.code) << " '" << error.detail << "'";
}

inline timeline::ShotRecord solved(const model::TableSpec& table, const Parameters& parameters,
                                   const std::vector<BallStart>& balls,
                                   Diagnostics* diagnostics = nullptr) {
    auto record = simulate(table, parameters, balls, diagnostics);
    EXPECT_TRUE(record.ok()) << (record.ok() ? "" : record.error().detail);
    return record.ok() ? *std::move(record) : timeline::ShotRecord{};
}

inline const timeline::BallTrack& track_of(const timeline::ShotRecord& record, int number) {
    for (const timeline::BallTrack& track : record.timeline.tracks) {
        if (track.ball.number == number) return track;
    }
    throw std::out_of_range("no such ball");
}

inline model::BallState state_of(const timeline::ShotRecord& record, int number, double time_s) {
    return timeline::evaluate(track_of(record, number), time_s);
}

inline std::vector<model::ShotEvent> events_of(const timeline::ShotRecord& record, EventKind kind) {
    std::vector<model::ShotEvent> events;
    std::copy_if(record.events.begin(), record.events.end(), std::back_inserter(events),
                 [&](const model::ShotEvent& event) { return event.kind == kind; });
    return events;
}

}  // namespace billiards::physics
