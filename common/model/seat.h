// Gives the two seats of a match, and the numbers that must not be mixed up.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace billiards::model {

enum class Seat : std::uint8_t { First = 0, Second = 1 };

inline constexpr std::array<Seat, 2> kSeats{Seat::First, Seat::Second};

inline Seat opponent_of(Seat seat) {
    return seat == Seat::First ? Seat::Second : Seat::First;
}

/// One value a seat.
template <class T>
struct PerSeat {
    std::array<T, 2> values{};

    T& operator[](Seat seat) { return values[static_cast<std::size_t>(seat)]; }
    const T& operator[](Seat seat) const { return values[static_cast<std::size_t>(seat)]; }
    friend bool operator==(const PerSeat&, const PerSeat&) = default;
};

/// Counts what players do in one match; each accepted command that ends a turn raises it by one.
struct TurnNumber {
    std::uint32_t value = 0;

    friend auto operator<=>(TurnNumber, TurnNumber) = default;
};

}  // namespace billiards::model
