// Takes and gives settings, rulings and matches on the wire. For codec*.cpp only.
#pragma once

#include "common/match/match_state.h"
#include "common/model/seat.h"
#include "common/protocol/codec_enums.h"
#include "common/protocol/codec_message.h"
#include "common/rules/verdict.h"
#include "proto/match.capnp.h"

#include <cstdint>
#include <optional>

namespace billiards::protocol {

void write(wire::Settings::Builder out, const match::Settings& settings);
void write(wire::RackState::Builder out, const rules::RackState& rack);
void write(wire::Verdict::Builder out, const rules::Verdict& verdict);
/// Without the seed and the earlier positions of practice.
void write(wire::MatchState::Builder out, const match::MatchState& state);

/// Any number, also NaN: match::start refuses by name.
match::Settings read(wire::Settings::Reader in);
rules::RackState read(wire::RackState::Reader in);
rules::Verdict read(wire::Verdict::Reader in);
match::MatchState read(wire::MatchState::Reader in);

/// Settings that somebody has accepted: refused unless within their limits.
match::Settings accepted_settings(wire::Settings::Reader in);

// The idioms of the schemas, each under many names: a count a seat, and a seat or none.

template <class Group>
void write_counts(Group out, const model::PerSeat<int>& counts) {
    out.setFirst(to_count(counts[model::Seat::First]));
    out.setSecond(to_count(counts[model::Seat::Second]));
}

inline constexpr std::int32_t kMaxScore = 1'000'000;  ///< Above what any match can reach.

/// Scores may be below zero.
template <class Group>
void write_scores(Group out, const model::PerSeat<int>& scores) {
    out.setFirst(scores[model::Seat::First]);
    out.setSecond(scores[model::Seat::Second]);
}

template <class Group>
model::PerSeat<int> read_scores(Group in, std::string_view field) {
    for (const std::int32_t score : {in.getFirst(), in.getSecond()}) {
        require(score >= -kMaxScore && score <= kMaxScore, field);
    }
    return {{in.getFirst(), in.getSecond()}};
}

template <class Group>
model::PerSeat<int> read_counts(Group in, std::string_view field) {
    return {{count(in.getFirst(), field), count(in.getSecond(), field)}};
}

template <class Union>
void write_seat(Union out, std::optional<model::Seat> seat) {
    if (seat) out.setSeat(to_wire(*seat));
}

template <class Union>
std::optional<model::Seat> read_seat(Union in, std::string_view field) {
    switch (in.which()) {
        case Union::Reads::NONE:
            return std::nullopt;
        case Union::Reads::SEAT:
            return from_wire<model::Seat>(in.getSeat(), field);
    }
    fail(DecodeErrorCode::UnknownKind, field);
}

}  // namespace billiards::protocol
