// Takes the name of a kind of shot; gives such shots one after another, every one different, the
// same on every machine.
#pragma once

#include "common/base/random.h"
#include "common/model/layout.h"
#include "common/model/shot.h"
#include "common/model/table_spec.h"

#include <cstdint>

namespace billiards::tools {

enum class BenchCase : std::uint8_t {
    Break8,  ///< 8 ft, frozen triangle, power 0.7 - 1, angle +-1 degree, tip offset within 0.2.
    Break9,  ///< The same on 9 ft with a frozen diamond of nine.
    Mid,     ///< 8 ft, nine balls at random, the cue ball sent off at 3 m/s.
};

struct BenchShot {
    model::Layout layout;
    model::Shot shot;
};

/// By one fixed seed.
class BenchShots {
  public:
    explicit BenchShots(BenchCase bench_case) : case_(bench_case), random_(kSeed) {}

    const model::TableSpec& table() const;
    BenchShot next() { return case_ == BenchCase::Mid ? mid() : hard_break(); }

  private:
    BenchShot hard_break();
    model::Layout rack() const;
    BenchShot mid();

    static constexpr std::uint64_t kSeed = 20;

    BenchCase case_;
    base::Random random_;
};

}  // namespace billiards::tools
