// Takes a .billiards file; gives its match as text, or whether this engine plays it again.
#pragma once

#include <filesystem>
#include <iosfwd>

namespace billiards::tools {

struct ReplayOptions {
    std::filesystem::path file;
    bool is_printed = false;  ///< Also where neither is asked for.
    bool is_verified = false;
};

/// `billiards-sim replay`: 0; 1 where the match is not verified, with the first difference on
/// `err`; 2 where the file is refused, with the reason. A file with a damaged tail is printed up
/// to the damage, and is refused all the same.
int replay_file(const ReplayOptions& options, std::ostream& out, std::ostream& err);

}  // namespace billiards::tools
