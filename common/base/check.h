// Takes a condition that must hold if we are right; gives a line on standard error and an abort
// where it does not.
#pragma once

namespace billiards::base {

[[noreturn]] void check_failed(const char* condition, const char* file, int line) noexcept;

}  // namespace billiards::base

/// "We are wrong" ends the program, in every build. Never on a value from outside: that is a
/// Result. An expression, so that it can stand before a comma.
#define CHECK(condition)                \
    ((condition) ? static_cast<void>(0) \
                 : ::billiards::base::check_failed(#condition, __FILE__, __LINE__))
