// Takes a database file, also one that a server is writing; gives a copy of it as it is at one
// moment.
#include "server/store/sqlite_backup.h"

#include "server/store/sqlite_errors.h"
#include "server/store/sqlite_schema.h"

#include <SQLiteCpp/Backup.h>
#include <SQLiteCpp/Database.h>
#include <cerrno>
#include <fcntl.h>
#include <fmt/format.h>
#include <string>
#include <sys/stat.h>
#include <system_error>
#include <unistd.h>
#include <utility>

namespace billiards::server {
namespace {

namespace fs = std::filesystem;

constexpr int kBusyTimeout_ms = 5000;

StoreError cannot_write(const fs::path& file, int error_number) {
    return {StoreErrorCode::CannotOpen,
            fmt::format("{}: {}", file.string(), std::generic_category().message(error_number))};
}

/// A new file that is gone again unless it is kept: what lies in it is secret (hashes of tokens).
class NewFile {
  public:
    explicit NewFile(fs::path path)
        : path_(std::move(path)),
          descriptor_(
              ::open(path_.c_str(), O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC, S_IRUSR | S_IWUSR)),
          error_number_(descriptor_ < 0 ? errno : 0) {}
    ~NewFile() {
        if (descriptor_ < 0) return;
        ::close(descriptor_);
        ::unlink(path_.c_str());
    }
    NewFile(const NewFile&) = delete;
    NewFile& operator=(const NewFile&) = delete;

    /// 0: it is there.
    int error_number() const { return error_number_; }
    const fs::path& path() const { return path_; }

    /// Under its final name too, once its bytes are on the disk; refused where that is taken.
    StoreResult<base::Done> keep_as(const fs::path& name) const {
        if (::fsync(descriptor_) != 0) return cannot_write(path_, errno);
        if (::link(path_.c_str(), name.c_str()) != 0) return cannot_write(name, errno);
        const fs::path folder = name.has_parent_path() ? name.parent_path() : fs::path(".");
        const int opened = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
        if (opened < 0) return cannot_write(folder, errno);
        ::fsync(opened);
        ::close(opened);
        return base::Done{};
    }

  private:
    fs::path path_;
    int descriptor_;
    int error_number_;
};

/// All pages in one step, within one reader's transaction: nothing that the server writes
/// meanwhile makes it begin again.
void copy_pages(SQLite::Database& source, SQLite::Database& copy) {
    SQLite::Backup backup(copy, source);
    backup.executeStep(-1);
}

StoreResult<base::Done> check(SQLite::Database& copy, const fs::path& source) {
    const std::string found = copy.execAndGet("PRAGMA integrity_check(1)").getString();
    if (found == "ok") return base::Done{};
    return StoreError{StoreErrorCode::Corrupt, fmt::format("{}: is damaged, so no copy is kept: {}",
                                                           source.string(), found)};
}

}  // namespace

StoreResult<base::Done> copy_database(const fs::path& from, const fs::path& to) {
    const NewFile part(to.string() + ".part");
    if (part.error_number() != 0) return cannot_write(part.path(), part.error_number());
    auto copied = guarded(from, [&]() -> StoreResult<base::Done> {
        SQLite::Database source(from.string(), SQLite::OPEN_READONLY, kBusyTimeout_ms);
        auto known = check_version(source, from);
        if (!known) return known;
        return guarded(to, [&] {
            SQLite::Database copy(part.path().string(), SQLite::OPEN_READWRITE);
            copy_pages(source, copy);
            // One file by itself, without a log beside it.
            copy.exec("PRAGMA journal_mode = DELETE");
            return check(copy, from);
        });
    });
    if (!copied) return copied;
    return part.keep_as(to);
}

}  // namespace billiards::server
