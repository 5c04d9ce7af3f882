// Takes numbers one after another; gives a 64-bit digest that is the same on every machine.
#pragma once

#include <bit>
#include <cstdint>

namespace billiards::base {

/// Not cryptographic: it tells accidents apart, not attackers. One multiplication a word (the
/// scheme of Knuth's multiplicative hashing, TAOCP 3, 6.4) and a final avalanche.
class Hasher {
  public:
    void add(std::uint64_t word) { state_ = (std::rotl(state_, 5) ^ word) * kFactor; }
    /// Hashes the bits: +0.0 and -0.0 differ.
    void add(double number) { add(std::bit_cast<std::uint64_t>(number)); }

    std::uint64_t digest() const {
        std::uint64_t mixed = state_;
        mixed = (mixed ^ (mixed >> 32U)) * kFactor;
        mixed = (mixed ^ (mixed >> 29U)) * kFactor;
        return mixed ^ (mixed >> 32U);
    }

  private:
    static constexpr std::uint64_t kFactor = 0x9e3779b97f4a7c15U;  // 2^64 / golden ratio, odd

    std::uint64_t state_ = 0x243f6a8885a308d3U;  // The first fraction bits of pi.
};

}  // namespace billiards::base
