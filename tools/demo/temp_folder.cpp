// Makes and removes a folder under the system's place for such.
#include "tools/demo/temp_folder.h"

#include <cerrno>
#include <cstdlib>
#include <string>
#include <system_error>

namespace billiards::tools {

TempFolder::TempFolder() {
    std::string pattern = (std::filesystem::temp_directory_path() / "billiards-XXXXXX").string();
    if (::mkdtemp(pattern.data()) == nullptr) {
        throw std::system_error(errno, std::generic_category(), "no temporary folder");
    }
    path_ = pattern;
}

TempFolder::~TempFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
}

}  // namespace billiards::tools
