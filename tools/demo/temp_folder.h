// Gives a fresh folder for as long as the object lives; then it is gone with all in it.
#pragma once

#include <filesystem>

namespace billiards::tools {

class TempFolder {
  public:
    /// Throws where the system gives none.
    TempFolder();
    ~TempFolder();
    TempFolder(const TempFolder&) = delete;
    TempFolder& operator=(const TempFolder&) = delete;

    const std::filesystem::path& path() const { return path_; }

  private:
    std::filesystem::path path_;
};

}  // namespace billiards::tools
