// Takes a data folder; gives a copy of everything in it that must survive, as one file.
#pragma once

#include <filesystem>
#include <iosfwd>

namespace billiards::server {

struct BackupOrder {
    std::filesystem::path data;  ///< A server may be using it meanwhile.
    std::filesystem::path file;  ///< Not there yet.
};

/// Gives the program's exit code: 0, or 1 after one line to `err`; then no file has been made.
int back_up(const BackupOrder& order, std::ostream& out, std::ostream& err);

}  // namespace billiards::server
