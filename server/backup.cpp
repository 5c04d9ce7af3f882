// Takes a data folder; gives a copy of everything in it that must survive, as one file.
#include "server/backup.h"

#include "server/store/data_folder.h"
#include "server/store/sqlite_backup.h"

#include <fmt/ostream.h>
#include <ostream>
#include <system_error>

namespace billiards::server {
namespace {

/// The error is a sentence for whoever typed the command.
base::Result<base::Done, std::string> carry_out(const BackupOrder& order) {
    const std::filesystem::path database = database_file_in(order.data);
    std::error_code error;
    if (!std::filesystem::exists(database, error)) return database.string() + ": is not there";
    if (std::filesystem::exists(order.file, error)) {
        return order.file.string() + ": is there already, and is left as it is";
    }
    auto copied = copy_database(database, order.file);
    if (!copied) return copied.error().detail;
    return base::Done{};
}

}  // namespace

int back_up(const BackupOrder& order, std::ostream& out, std::ostream& err) {
    const auto done = carry_out(order);
    if (!done) {
        fmt::print(err, "{}\n", done.error());
        return 1;
    }
    std::error_code ignored;
    fmt::print(out, "{}: {} bytes\n", order.file.string(),
               std::filesystem::file_size(order.file, ignored));
    return 0;
}

}  // namespace billiards::server
