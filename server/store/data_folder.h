// Takes the path of the data folder; gives the folder itself, there and locked for this process.
#pragma once

#include <filesystem>

namespace billiards::server {

inline std::filesystem::path database_file_in(const std::filesystem::path& data_folder) {
    return data_folder / "billiards.db";
}

/// Held for as long as the server writes into the folder, so that two servers never share one.
class DataFolder {
  public:
    /// Creates the folder, for its owner alone, where it is missing. Throws std::runtime_error
    /// with a sentence that names the folder where it cannot be made, written to or locked.
    explicit DataFolder(std::filesystem::path path);
    ~DataFolder();
    DataFolder(const DataFolder&) = delete;
    DataFolder& operator=(const DataFolder&) = delete;

    const std::filesystem::path& path() const { return path_; }
    std::filesystem::path database_file() const { return database_file_in(path_); }

  private:
    std::filesystem::path path_;
    int lock_descriptor_ = -1;
};

}  // namespace billiards::server
