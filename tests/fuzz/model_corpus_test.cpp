// Shows, with any compiler and in a second, what the fuzzer looks for: models that were damaged on
// purpose, by a seed, break no reader.
#include "client/scene/mesh.h"
#include "common/base/random.h"
#include "tests/fuzz/read_any_model.h"
#include "tools/make_assets/ball_mesh.h"
#include "tools/make_assets/surface.h"
#include "tools/make_assets/write_3ds.h"

#include <gtest/gtest.h>
#include <vector>

namespace billiards::fuzz {
namespace {

using make_assets::Bytes;

/// Two small meshes: every kind of chunk, and few enough bytes to damage each.
const Bytes& seed() {
    static const Bytes bytes = [] {
        client::Mesh plate{.name = "plate", .vertices = {}, .indices = {}};
        make_assets::add_plate(
            plate,
            {{{0, 0, 0}, {0, 0}}, {{1, 0, 0}, {1, 0}}, {{1, 1, 0}, {1, 1}}, {{0, 1, 0}, {0, 1}}});
        return make_assets::write_3ds(std::vector{make_assets::ball_mesh(4, 3), plate}, "a.bmp");
    }();
    return bytes;
}

TEST(DamagedModels, CutShortAnywhereBreakNothing) {
    for (std::size_t size = 0; size <= seed().size(); ++size) {
        read_any_model(std::span(seed()).first(size));
    }
}

TEST(DamagedModels, WithAnyByteSetToAnythingBreakNothing) {
    for (std::size_t at = 0; at < seed().size(); ++at) {
        Bytes bytes = seed();
        for (int value = 0; value < 256; ++value) {
            bytes[at] = static_cast<std::byte>(value);
            read_any_model(bytes);
        }
    }
}

TEST(DamagedModels, WithManyBytesChangedOrMovedBreakNothing) {
    base::Random random(2026);
    for (int i = 0; i < 20'000; ++i) {
        Bytes bytes = seed();
        for (std::uint64_t changes = 1 + random.below(8); changes > 0; --changes) {
            const std::size_t at = random.below(bytes.size());
            bytes[at] = random.below(2) == 0 ? static_cast<std::byte>(random.below(256))
                                             : bytes[random.below(bytes.size())];
        }
        read_any_model(bytes);
    }
}

}  // namespace
}  // namespace billiards::fuzz
