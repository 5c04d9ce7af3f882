// Takes a number of shots; gives one digest of all their hashes: what tests/hashes.sh compares.
#include "common/base/hash.h"
#include "tests/common/physics/numbered_case.h"

#include <cinttypes>
#include <cstdio>
#include <cstdlib>

int main(int argc, char** argv) {
    const std::uint64_t shots = argc > 1 ? std::strtoull(argv[1], nullptr, 10) : 400;
    billiards::base::Hasher digest;
    for (std::uint64_t number = 0; number < shots; ++number) {
        const auto made = billiards::physics::numbered_case(number);
        const auto record = billiards::physics::simulate(made.table, made.parameters, made.balls);
        digest.add(record.ok() ? record->hash : number);
    }
    std::printf("%016" PRIx64 "\n", digest.digest());
}
