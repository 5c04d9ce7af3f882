// Holds the data folder against folders that are missing, shared, or cannot be used.
#include "server/store/data_folder.h"

#include "tests/support/temporary_folder.h"

#include <fstream>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <optional>

namespace billiards::server {
namespace {

namespace fs = std::filesystem;
using support::TemporaryFolder;
using testing::HasSubstr;

/// The sentence that opening the folder ends with; empty where it opens.
std::string complaint_about(const fs::path& path) {
    try {
        const DataFolder folder(path);
        return {};
    } catch (const std::runtime_error& error) {
        return error.what();
    }
}

TEST(DataFolder, IsCreatedForItsOwnerAlone) {
    const TemporaryFolder parent;
    const DataFolder folder(parent.path() / "a" / "b");
    EXPECT_TRUE(fs::is_directory(folder.path()));
    EXPECT_EQ(fs::status(folder.path()).permissions(), fs::perms::owner_all);
}

TEST(DataFolder, KeepsThePermissionsOfAFolderThatWasThere) {
    const TemporaryFolder parent;
    fs::permissions(parent.path(), fs::perms(0750));
    const DataFolder folder(parent.path());
    EXPECT_EQ(fs::status(parent.path()).permissions(), fs::perms(0750));
}

TEST(DataFolder, IsRefusedToASecondServerAndNamed) {
    const TemporaryFolder parent;
    const DataFolder first(parent.path());
    EXPECT_THAT(complaint_about(parent.path()), HasSubstr(parent.path().string()));
    EXPECT_THAT(complaint_about(parent.path()), HasSubstr("in use by another server"));
}

TEST(DataFolder, IsFreeAgainOnceTheFirstServerIsGone) {
    const TemporaryFolder parent;
    std::optional<DataFolder> first(parent.path());
    first.reset();
    EXPECT_EQ(complaint_about(parent.path()), "");
}

TEST(DataFolder, NamesAFolderThatCannotBeCreated) {
    const TemporaryFolder parent;
    const fs::path file = parent.path() / "file";
    std::ofstream(file) << "in the way";
    EXPECT_THAT(complaint_about(file / "data"), HasSubstr((file / "data").string()));
    EXPECT_THAT(complaint_about(file / "data"), HasSubstr("cannot be created: Not a directory"));
    EXPECT_THAT(complaint_about(file), HasSubstr(file.string()));
}

TEST(DataFolder, NamesAFolderThatCannotBeWrittenTo) {
    const TemporaryFolder parent;
    fs::create_directory(parent.path() / "lock");  // Stops even root, whom permissions do not.
    EXPECT_THAT(complaint_about(parent.path()), HasSubstr("cannot be written to: Is a directory"));
}

}  // namespace
}  // namespace billiards::server
