// Keeps sessions in a folder; gives whether they come back whole, and from one window alone.
#include "client/local/profile.h"

#include "tests/support/temporary_folder.h"

#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>

namespace billiards::client {
namespace {

class ProfileTest : public testing::Test {
  protected:
    static KeptSession a_session() {
        KeptSession session;
        session.where = Whereabouts::Hosted;
        session.port = 4747;
        session.is_for_others = true;
        session.name = "Ada";
        session.token = {0, 1, 0xab, 0xff};
        session.has_seat = true;
        return session;
    }

    support::TemporaryFolder folder_;
    std::filesystem::path at_ = folder_.path() / "deep" / "profile";
};

TEST_F(ProfileTest, ASessionThatIsKeptComesBack) {
    Profile(at_).keep(a_session());
    EXPECT_EQ(Profile(at_).kept(), a_session());
}

TEST_F(ProfileTest, ASessionIsForItsUserAloneToRead) {
    Profile(at_).keep(a_session());
    const auto allowed = std::filesystem::status(at_ / "session.json").permissions();
    EXPECT_EQ(allowed, std::filesystem::perms::owner_read | std::filesystem::perms::owner_write);
}

TEST_F(ProfileTest, WhatIsForgottenIsGone) {
    Profile profile(at_);
    profile.keep(a_session());
    profile.forget();
    EXPECT_EQ(profile.kept(), std::nullopt);
}

TEST_F(ProfileTest, OneWindowAtATimeHasIt) {
    Profile first(at_);
    Profile second(at_);
    EXPECT_TRUE(first.is_ours());
    EXPECT_FALSE(second.is_ours());
    second.keep(a_session());
    EXPECT_EQ(first.kept(), std::nullopt) << "what is another's is not written";
}

TEST_F(ProfileTest, AWindowThatHasGoneLeavesItToTheNext) {
    EXPECT_TRUE(Profile(at_).is_ours());
    EXPECT_TRUE(Profile(at_).is_ours());
}

TEST_F(ProfileTest, AFileThatIsNoSessionIsAsIfThereWereNone) {
    std::filesystem::create_directories(at_);
    for (const char* text :
         {"", "{}", "[1]", R"({"token": 5})", R"({"token": "zz", "where": 0})",
          R"({"where": 9, "token": ")"
          "0000000000000000000000000000000000000000000000000000000000000000"
          R"(", "address": "", "port": 1, "for_others": false, "name": "", "has_seat": true})"}) {
        std::ofstream(at_ / "session.json") << text;
        EXPECT_EQ(Profile(at_).kept(), std::nullopt) << text;
    }
}

TEST_F(ProfileTest, AFolderThatCannotBeIsNobodysAndKeepsNothing) {
    std::ofstream(folder_.path() / "deep") << "no folder";
    Profile profile(at_);
    EXPECT_TRUE(profile.is_ours()) << "no other window is in the way";
    profile.keep(a_session());
    EXPECT_EQ(profile.kept(), std::nullopt);
}

}  // namespace
}  // namespace billiards::client
