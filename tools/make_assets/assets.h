// Gives every model and texture of the game as a file's name and bytes, from the physics' tables.
#pragma once

#include "tools/make_assets/byte_writer.h"

#include <string>
#include <vector>

namespace billiards::make_assets {

struct Asset {
    std::string path;  ///< Under assets/.
    Bytes bytes;
};

/// The same bytes on every machine and with every compiler.
std::vector<Asset> all_assets();

}  // namespace billiards::make_assets
