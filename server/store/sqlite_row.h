// Takes values and SQLite's statements; gives what is bound to the one and read from the other.
#pragma once

#include "common/protocol/codec_journal.h"

#include <SQLiteCpp/Column.h>
#include <SQLiteCpp/Statement.h>
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

namespace billiards::server {

// SQLite's integers are signed; every identity and sequence number keeps its 64 bits.
inline std::int64_t stored(std::uint64_t number) {
    return static_cast<std::int64_t>(number);
}
inline std::uint64_t read_number(const SQLite::Column& column) {
    return static_cast<std::uint64_t>(column.getInt64());
}

/// The bytes must live until the statement has run.
template <class Container>
void bind_bytes(SQLite::Statement& statement, int index, const Container& bytes) {
    // A null pointer would bind NULL instead of no bytes.
    const void* data = bytes.empty() ? static_cast<const void*>("") : bytes.data();
    statement.bindNoCopy(index, data, static_cast<int>(bytes.size()));
}
template <class Container>
void bind_bytes(SQLite::Statement& statement, int index, const std::optional<Container>& bytes) {
    if (bytes) {
        bind_bytes(statement, index, *bytes);
    } else {
        statement.bind(index);  // NULL
    }
}

inline protocol::Bytes read_bytes(const SQLite::Column& column) {
    const auto* data = static_cast<const std::byte*>(column.getBlob());
    return {data, data + column.getBytes()};
}

/// None where the column is NULL or has another length.
template <std::size_t size>
std::optional<std::array<std::uint8_t, size>> read_array(const SQLite::Column& column) {
    std::array<std::uint8_t, size> bytes{};
    if (column.getBytes() != static_cast<int>(size)) return std::nullopt;
    std::copy_n(static_cast<const std::uint8_t*>(column.getBlob()), size, bytes.begin());
    return bytes;
}

/// A prepared statement in use; ready to be used again once this is gone, whatever happened.
class Use {
  public:
    explicit Use(SQLite::Statement& statement) : statement_(statement) {}
    ~Use() { statement_.tryReset(); }
    Use(const Use&) = delete;
    Use& operator=(const Use&) = delete;

    SQLite::Statement* operator->() const { return &statement_; }
    SQLite::Statement& operator*() const { return statement_; }

  private:
    SQLite::Statement& statement_;
};

}  // namespace billiards::server
