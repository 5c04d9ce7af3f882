// Takes an enum of ours; gives the words by which `billiards-sim` reads and writes it. One list an
// enum, in its order.
#pragma once

#include "common/base/check.h"
#include "common/model/ball.h"
#include "common/model/shot_event.h"
#include "common/physics/parameters.h"
#include "common/rules/verdict.h"
#include "tools/sim/json_node.h"

#include <array>
#include <cstddef>

namespace billiards::tools {

constexpr auto words_of(model::EventKind) {
    return std::to_array<const char*>({"ball-ball", "cushion", "jaw", "pocketed", "motion",
                                       "head-string", "landing", "off-table"});
}
constexpr auto words_of(model::Motion) {
    return std::to_array<const char*>(
        {"resting", "spinning", "rolling", "sliding", "airborne", "pocketed", "off-table"});
}
constexpr auto words_of(physics::BallBallModel) {
    return std::to_array<const char*>({"frictional", "elastic"});
}
constexpr auto words_of(physics::CushionModel) {
    return std::to_array<const char*>({"han2005", "mathavan2010", "stronge", "mirror"});
}
constexpr auto words_of(rules::Game) {
    return std::to_array<const char*>(
        {"eight-ball", "nine-ball", "ten-ball", "straight-pool", "practice"});
}
constexpr auto words_of(rules::Group) {
    return std::to_array<const char*>({"solids", "stripes"});
}
constexpr auto words_of(rules::Phase) {
    return std::to_array<const char*>({"break", "open", "groups", "after-break"});
}
constexpr auto words_of(rules::Zone) {
    return std::to_array<const char*>({"none", "anywhere", "behind-head-string"});
}
constexpr auto words_of(rules::Foul) {
    return std::to_array<const char*>({"scratch", "no-ball-hit", "wrong-ball-first",
                                       "no-cushion-after-contact", "ball-off-table",
                                       "illegal-break", "head-string", "clock", "bad-placement",
                                       "wrong-ball-struck", "breaking-foul"});
}
constexpr auto words_of(rules::Choice) {
    return std::to_array<const char*>({"accept", "rebreak-self", "rebreak-opponent", "spot-eight",
                                       "ball-in-hand-behind-head-string", "play", "pass-back"});
}
constexpr auto words_of(rules::Rerack) {
    return std::to_array<const char*>({"none", "fourteen", "fifteen"});
}
constexpr auto words_of(rules::Reason) {
    return std::to_array<const char*>({"legal-pot",
                                       "break-pot",
                                       "legal-break",
                                       "nothing-potted",
                                       "not-called",
                                       "safety",
                                       "foul",
                                       "illegal-break",
                                       "break-foul",
                                       "eight-on-break",
                                       "eight-on-foul-break",
                                       "eight-won",
                                       "eight-with-foul",
                                       "eight-early",
                                       "eight-uncalled",
                                       "eight-off-table",
                                       "clock-ran-out",
                                       "three-fouls",
                                       "push-out",
                                       "nine-won",
                                       "ten-won",
                                       "ten-early",
                                       "uncalled-pot",
                                       "breaking-foul",
                                       "target-reached",
                                       "practice"});
}

template <class Enum>
const char* word_of(Enum value) {
    static constexpr auto words = words_of(Enum{});
    const auto index = static_cast<std::size_t>(value);
    CHECK(index < words.size());
    return words[index];
}

/// The value whose word stands here; the first, with a fault, where none does.
template <class Enum>
Enum read_word(const JsonNode& node) {
    static constexpr auto words = words_of(Enum{});
    return static_cast<Enum>(node.one_of(words));
}

template <class Enum>
Enum read_word_or(const JsonNode& node, Enum fallback) {
    return node.is_present() ? read_word<Enum>(node) : fallback;
}

}  // namespace billiards::tools
