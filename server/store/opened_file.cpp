// Takes the path of a database that is open; gives whether it still is the file at that path.
#include "server/store/opened_file.h"

#include <sys/stat.h>

namespace billiards::server {

OpenedFile::OpenedFile(const std::filesystem::path& file)
    : file_(file),
      log_(file.string() + "-wal"),
      file_identity_(identity_of(file_)),
      log_identity_(identity_of(log_)) {}

bool OpenedFile::is_still_there() const {
    return file_identity_ && identity_of(file_) == file_identity_ &&
           identity_of(log_) == log_identity_;
}

std::optional<OpenedFile::Identity> OpenedFile::identity_of(const std::filesystem::path& file) {
    struct stat found {};
    if (::stat(file.c_str(), &found) != 0) return std::nullopt;
    return Identity{found.st_dev, found.st_ino};
}

}  // namespace billiards::server
