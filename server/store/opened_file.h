// Takes the path of a database that is open; gives whether it still is the file at that path.
#pragma once

#include <filesystem>
#include <optional>
#include <sys/types.h>

namespace billiards::server {

/// A file that was deleted or replaced takes writes as before, and they are gone with it: the
/// system says nothing, so one has to look. Costs two calls of stat.
class OpenedFile {
  public:
    /// The database and its write-ahead log stand.
    explicit OpenedFile(const std::filesystem::path& file);

    bool is_still_there() const;

  private:
    struct Identity {
        dev_t device = 0;
        ino_t number = 0;
        friend bool operator==(const Identity&, const Identity&) = default;
    };
    static std::optional<Identity> identity_of(const std::filesystem::path& file);

    std::filesystem::path file_;
    std::filesystem::path log_;
    std::optional<Identity> file_identity_;
    std::optional<Identity> log_identity_;
};

}  // namespace billiards::server
