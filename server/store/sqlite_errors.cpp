// Takes what SQLite throws; gives what the store says of it.
#include "server/store/sqlite_errors.h"

#include <fmt/format.h>
#include <sqlite3.h>

namespace billiards::server {
namespace {

StoreErrorCode code_of(const SQLite::Exception& error) {
    switch (error.getErrorCode() & 0xff) {  // The primary code is the lowest byte.
        case SQLITE_CANTOPEN:
        case SQLITE_PERM:
        case SQLITE_READONLY:
            return StoreErrorCode::CannotOpen;
        case SQLITE_CORRUPT:
        case SQLITE_NOTADB:
            return StoreErrorCode::Corrupt;
        case SQLITE_FULL:
            return StoreErrorCode::Full;
        case SQLITE_BUSY:
        case SQLITE_LOCKED:
            return StoreErrorCode::Busy;
        case SQLITE_IOERR:
            return StoreErrorCode::Disk;
        default:
            return StoreErrorCode::Failed;
    }
}

const char* advice_on(StoreErrorCode code) {
    if (code != StoreErrorCode::Corrupt) return "";
    return "; the file is damaged: put a backup in its place, or save what it still holds with "
           "`billiards-server export`";
}

}  // namespace

StoreError error_of(const std::filesystem::path& file, const SQLite::Exception& error) {
    const StoreErrorCode code = code_of(error);
    return {code, fmt::format("{}: {}{}", file.string(), error.what(), advice_on(code))};
}

StoreError error_of(const std::filesystem::path& file, const std::exception& error) {
    return {StoreErrorCode::Failed, fmt::format("{}: {}", file.string(), error.what())};
}

}  // namespace billiards::server
