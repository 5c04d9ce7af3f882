// Takes a call that may throw what SQLite throws; gives its result, or what the store says of it.
#pragma once

#include "server/store/match_store.h"

#include <SQLiteCpp/Exception.h>
#include <exception>
#include <filesystem>

namespace billiards::server {

StoreError error_of(const std::filesystem::path& file, const SQLite::Exception& error);
StoreError error_of(const std::filesystem::path& file, const std::exception& error);

template <class Call>
auto guarded(const std::filesystem::path& file, const Call& call) -> decltype(call()) {
    try {
        return call();
    } catch (const SQLite::Exception& error) {
        return error_of(file, error);
    } catch (const std::exception& error) {
        return error_of(file, error);
    }
}

}  // namespace billiards::server
