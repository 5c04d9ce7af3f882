// Takes a folder; writes every model and texture of the game into it: make_assets assets
#include "tools/make_assets/assets.h"

#include <filesystem>
#include <fstream>
#include <iostream>

namespace fs = std::filesystem;

int main(int argc, char** argv) try {
    if (argc != 2) {
        std::cerr << "make_assets FOLDER: writes models/ and textures/ into it\n";
        return 2;
    }
    const fs::path folder(argv[1]);
    for (const auto& asset : billiards::make_assets::all_assets()) {
        const fs::path path = folder / asset.path;
        fs::create_directories(path.parent_path());
        std::ofstream file(path, std::ios::binary);
        file.exceptions(std::ios::failbit | std::ios::badbit);
        file.write(reinterpret_cast<const char*>(asset.bytes.data()),
                   static_cast<std::streamsize>(asset.bytes.size()));
    }
    return 0;
} catch (const std::exception& error) {
    std::cerr << "make_assets: " << error.what() << '\n';
    return 1;
}
