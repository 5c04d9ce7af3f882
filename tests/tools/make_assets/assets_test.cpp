// Holds the files under assets/ against what make_assets makes, byte for byte, and both against
// what the client takes.
#include "tools/make_assets/assets.h"

#include "client/scene/bitmap_limits.h"
#include "client/scene/model.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <iterator>
#include <set>

namespace billiards::make_assets {
namespace {

namespace fs = std::filesystem;

const std::vector<Asset>& assets() {
    static const std::vector<Asset> assets = all_assets();
    return assets;
}

Bytes committed(const std::string& path) {
    std::ifstream file(fs::path(ASSETS_FOLDER) / path, std::ios::binary);
    const std::string text((std::istreambuf_iterator<char>(file)), {});
    Bytes bytes(text.size());
    std::transform(text.begin(), text.end(), bytes.begin(),
                   [](char c) { return static_cast<std::byte>(c); });
    return bytes;
}

TEST(Assets, AreTheCommittedFilesByteForByte) {
    for (const Asset& asset : assets()) {
        // Not EXPECT_EQ: it would print megabytes.
        EXPECT_TRUE(committed(asset.path) == asset.bytes)
            << asset.path << " differs: run make_assets assets";
    }
}

TEST(Assets, AreAllTheModelsAndTexturesThereAre) {
    std::set<std::string> made;
    for (const Asset& asset : assets()) made.insert(asset.path);
    std::set<std::string> found;
    for (const char* folder : {"models", "textures"}) {
        for (const auto& entry : fs::directory_iterator(fs::path(ASSETS_FOLDER) / folder)) {
            found.insert((fs::path(folder) / entry.path().filename()).string());
        }
    }
    EXPECT_EQ(found, made);
}

TEST(Assets, TakeLessThanTheirBudgetOf25Megabytes) {
    std::size_t bytes = 0;
    for (const Asset& asset : assets()) bytes += asset.bytes.size();
    EXPECT_LT(bytes, 25'000'000U);
}

TEST(Assets, EveryModelCanBeLoadedAndHasFaces) {
    for (const Asset& asset : assets()) {
        if (!asset.path.ends_with(".3ds")) continue;
        const auto meshes = client::read_3ds(asset.bytes);
        ASSERT_TRUE(meshes.ok()) << asset.path;
        for (const client::Mesh& mesh : *meshes) EXPECT_FALSE(mesh.indices.empty()) << mesh.name;
    }
}

TEST(Assets, EveryTextureIsABitmapWithinTheLimits) {
    for (const Asset& asset : assets()) {
        if (!asset.path.ends_with(".bmp")) continue;
        const auto number = [&](std::size_t at) {
            int value = 0;
            for (std::size_t i = 4; i-- > 0;)
                value = value << 8 | static_cast<int>(asset.bytes[at + i]);
            return value;
        };
        EXPECT_EQ(asset.bytes[0], std::byte{'B'}) << asset.path;
        EXPECT_EQ(client::bitmap_fault(number(18), number(22)), std::nullopt) << asset.path;
        EXPECT_EQ(static_cast<std::size_t>(number(2)), asset.bytes.size()) << asset.path;
    }
}

}  // namespace
}  // namespace billiards::make_assets
