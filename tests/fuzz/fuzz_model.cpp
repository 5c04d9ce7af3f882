// Takes what libFuzzer thinks of; gives it to the reader of .3ds files.
//   cmake --preset clang -B build-fuzz -DBILLIARDS_FUZZ=ON \
//     -DBILLIARDS_SANITIZE=address,undefined,fuzzer-no-link
//   ninja -C build-fuzz fuzz_model
//   mkdir models && cp assets/models/* models && build-fuzz/bin/fuzz_model models
#include "tests/fuzz/read_any_model.h"

#include <cstdint>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    billiards::fuzz::read_any_model(std::as_bytes(std::span(data, size)));
    return 0;
}
