// Holds the loading of models against files that are there, missing and damaged.
#include "client/scene/model.h"

#include "tests/support/temporary_folder.h"

#include <fstream>
#include <gtest/gtest.h>

namespace billiards::client {
namespace {

TEST(LoadModel, GivesTheMeshesOfTheFile) {
    const auto meshes = load_model(ASSETS_FOLDER, {"models/cue.3ds", "textures/cue.bmp"});
    ASSERT_TRUE(meshes.ok()) << in_words(meshes.error());
    EXPECT_EQ(meshes->front().name, "cue");
}

TEST(LoadModel, NamesTheFileThatIsMissingAndTheWayOut) {
    const auto meshes = load_model("/nowhere", {"models/cue.3ds", "textures/cue.bmp"});
    ASSERT_FALSE(meshes.ok());
    EXPECT_EQ(in_words(meshes.error()),
              "The model /nowhere/models/cue.3ds cannot be read. Put it back from the release, or "
              "run make_assets.");
}

TEST(LoadModel, RefusesAFolder) {
    EXPECT_FALSE(load_model(ASSETS_FOLDER, {"models", ""}).ok());
}

TEST(LoadModel, SaysWhatIsWrongAndWhere) {
    const support::TemporaryFolder folder;
    std::ofstream(folder.path() / "bad.3ds", std::ios::binary) << "MM\x06\0\0\0";
    const auto meshes = load_model(folder.path(), {"bad.3ds", ""});
    ASSERT_FALSE(meshes.ok());
    EXPECT_EQ(in_words(meshes.error()),
              "The model " + (folder.path() / "bad.3ds").string() +
                  " is cut short, or gives a length that goes beyond its part (at byte 0). Put it "
                  "back from the release, or run make_assets.");
}

}  // namespace
}  // namespace billiards::client
