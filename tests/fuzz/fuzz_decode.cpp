// Takes what libFuzzer thinks of; gives it to every decoder.
//   cmake --preset clang -B build-fuzz -DBILLIARDS_FUZZ=ON \
//     -DBILLIARDS_SANITIZE=address,undefined,fuzzer-no-link
//   ninja -C build-fuzz fuzz_decode write_corpus
//   build-fuzz/bin/write_corpus corpus && build-fuzz/bin/fuzz_decode corpus -max_len=16384
#include "tests/fuzz/decode_anything.h"

#include <cstdint>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    billiards::fuzz::decode_anything(std::as_bytes(std::span(data, size)));
    return 0;
}
