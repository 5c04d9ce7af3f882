// Takes a seed; gives the same numbers on every machine (the standard distributions do not).
#pragma once

#include "common/base/check.h"

#include <cstdint>

namespace billiards::base {

/// SplitMix64: Steele, Lea, Flood, "Fast splittable pseudorandom number generators", OOPSLA 2014.
/// For racks, tests and load; never for secrets.
class Random {
  public:
    explicit Random(std::uint64_t seed) : state_(seed) {}

    std::uint64_t next() {
        state_ += 0x9e3779b97f4a7c15U;
        std::uint64_t mixed = state_;
        mixed = (mixed ^ (mixed >> 30U)) * 0xbf58476d1ce4e5b9U;
        mixed = (mixed ^ (mixed >> 27U)) * 0x94d049bb133111ebU;
        return mixed ^ (mixed >> 31U);
    }
    /// Uniform in [0, bound); the bias of the remainder is below 2^-32 for every bound used here.
    std::uint64_t below(std::uint64_t bound) {
        CHECK(bound > 0 && bound < (std::uint64_t{1} << 32U));
        return next() % bound;
    }
    /// Uniform in [low, high).
    double uniform(double low, double high) {
        return low + (high - low) * (static_cast<double>(next() >> 11U) * 0x1.0p-53);
    }

  private:
    std::uint64_t state_;
};

}  // namespace billiards::base
