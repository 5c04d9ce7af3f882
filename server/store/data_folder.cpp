// Takes the path of the data folder; gives the folder itself, there and locked for this process.
#include "server/store/data_folder.h"

#include <cerrno>
#include <fcntl.h>
#include <fmt/format.h>
#include <stdexcept>
#include <string>
#include <sys/file.h>
#include <sys/stat.h>
#include <system_error>
#include <unistd.h>
#include <utility>

namespace billiards::server {
namespace {

std::runtime_error cannot_use(const std::filesystem::path& folder, const std::string& reason) {
    return std::runtime_error(fmt::format("data folder {} {}", folder.string(), reason));
}

std::string reason_of(int error_number) {
    return std::generic_category().message(error_number);
}

/// What lies in it is secret (hashes of tokens), so a new folder is for its owner alone.
void create(const std::filesystem::path& folder) {
    std::error_code error;
    if (!std::filesystem::create_directories(folder, error) && error) {
        throw cannot_use(folder, "cannot be created: " + error.message());
    }
    if (!std::filesystem::is_directory(folder, error)) throw cannot_use(folder, "is not a folder");
}

bool is_new(const std::filesystem::path& folder) {
    std::error_code error;
    return !std::filesystem::exists(folder, error);
}

}  // namespace

DataFolder::DataFolder(std::filesystem::path path) : path_(std::move(path)) {
    const bool created_here = is_new(path_);
    create(path_);
    if (created_here) ::chmod(path_.c_str(), S_IRWXU);
    const std::filesystem::path lock_file = path_ / "lock";
    lock_descriptor_ = ::open(lock_file.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, S_IRUSR | S_IWUSR);
    if (lock_descriptor_ < 0) throw cannot_use(path_, "cannot be written to: " + reason_of(errno));
    if (::flock(lock_descriptor_, LOCK_EX | LOCK_NB) == 0) return;
    const int error_number = errno;
    ::close(lock_descriptor_);
    if (error_number == EWOULDBLOCK) throw cannot_use(path_, "is in use by another server");
    throw cannot_use(path_, "cannot be locked: " + reason_of(error_number));
}

DataFolder::~DataFolder() {
    ::close(lock_descriptor_);
}

}  // namespace billiards::server
