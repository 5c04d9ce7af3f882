// Takes a value or an error; gives one type that a caller cannot ignore.
#pragma once

#include "common/base/check.h"

#include <utility>
#include <variant>

namespace billiards::base {

/// Stands for "it worked, and there is nothing to say": `Result<Done, Error>`.
struct Done {
    friend bool operator==(Done, Done) = default;
};

/// A value of type T, or an error of type E when the world was wrong (bytes, user, file, other
/// player). T and E must differ. Reading the side that is not there is our mistake and ends the
/// program through CHECK.
template <class T, class E>
class [[nodiscard]] Result {
  public:
    using Value = T;
    using Error = E;

    Result(T value) : side_(std::in_place_index<0>, std::move(value)) {}
    Result(E error) : side_(std::in_place_index<1>, std::move(error)) {}

    bool ok() const { return side_.index() == 0; }
    explicit operator bool() const { return ok(); }

    const T& value() const& { return CHECK(ok()), *std::get_if<0>(&side_); }
    T& value() & { return CHECK(ok()), *std::get_if<0>(&side_); }
    T&& value() && { return CHECK(ok()), std::move(*std::get_if<0>(&side_)); }
    const E& error() const& { return CHECK(!ok()), *std::get_if<1>(&side_); }
    E&& error() && { return CHECK(!ok()), std::move(*std::get_if<1>(&side_)); }

    const T& operator*() const& { return value(); }
    T& operator*() & { return value(); }
    T&& operator*() && { return std::move(*this).value(); }
    const T* operator->() const { return &value(); }
    T* operator->() { return &value(); }

  private:
    std::variant<T, E> side_;
};

}  // namespace billiards::base
