// Draws single values for properties: numbers, and what messages and journals are made of. May only
// run inside rc::gen::exec.
#pragma once

#include "common/protocol/codec_segment.h"
#include "common/protocol/messages.h"

#include <cstdint>
#include <optional>
#include <rapidcheck.h>
#include <vector>

namespace billiards::protocol {

template <class T>
T within(T low, T high) {
    return *rc::gen::inRange<T>(low, high);
}
inline bool coin() {
    return *rc::gen::arbitrary<bool>();
}
template <class Enum>
Enum up_to(Enum last) {
    return static_cast<Enum>(within(0, static_cast<int>(last) + 1));
}
inline std::uint32_t any32() {
    return *rc::gen::arbitrary<std::uint32_t>();
}
inline std::uint64_t any64() {
    return *rc::gen::arbitrary<std::uint64_t>();
}
inline std::int64_t any_time_us() {
    return *rc::gen::arbitrary<std::int64_t>();
}
/// Exact in 32 bits, as segments are.
inline double coarse(double size) {
    return as_sent(size * within(-1'000'000, 1'000'001) / 1e6);
}
/// As fine as a double can be.
inline double fine(double size) {
    return size * (static_cast<double>(within<std::int64_t>(-(1LL << 52), 1LL << 52)) * 0x1p-52);
}

template <class Draw>
auto maybe(Draw draw) {
    return coin() ? std::optional(draw()) : std::nullopt;
}
template <class Draw>
auto some(std::size_t max_size, Draw draw) {
    std::vector<decltype(draw())> values;
    const std::size_t size = within<std::size_t>(0, max_size + 1);
    for (std::size_t i = 0; i < size; ++i) values.push_back(draw());
    return values;
}

model::Seat seat();
model::BallId ball();
std::vector<model::BallId> balls();
model::PerSeat<int> counts();
ResumeToken token();
model::Shot shot();
model::Call call();
base::Vec2 position();
match::Settings settings();
model::Layout layout();
rules::RackState rack();
rules::Verdict verdict();
match::MatchState state();
timeline::ShotRecord record();

}  // namespace billiards::protocol
