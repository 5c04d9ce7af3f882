// Takes a broken CHECK; gives its place on standard error, and ends the program.
#include "common/base/check.h"

#include <cstdio>
#include <cstdlib>

namespace billiards::base {

void check_failed(const char* condition, const char* file, int line) noexcept {
    std::fprintf(stderr, "%s:%d: CHECK(%s) does not hold: a mistake in gl-billiards\n", file, line,
                 condition);
    std::abort();
}

}  // namespace billiards::base
