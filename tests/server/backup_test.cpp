// Holds a backup against the store that it was made from, also while a server writes.
#include "server/backup.h"

#include "server/store/data_folder.h"
#include "tests/server/store/opened_store.h"

#include <SQLiteCpp/Database.h>
#include <atomic>
#include <fstream>
#include <gmock/gmock.h>
#include <sstream>
#include <thread>

namespace billiards::server {
namespace {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::HasSubstr;

class Backup : public StoreTest {
  protected:
    Backup() {
        open();
        commit({SavePlayer{some_player(1)}, SaveMatch{some_match(1)}});
    }

    int run(const fs::path& data) {
        out.str("");
        err.str("");
        return back_up({.data = data, .file = copy}, out, err);
    }
    int run() { return run(folder.path()); }

    fs::path copy = folder.path() / "copy.db";
    std::ostringstream out;
    std::ostringstream err;
};

TEST_F(Backup, IsWhatAServerStartsWith) {
    commit({AppendEntry{{1}, some_entry(1)}, SaveTable{some_table(4)}});
    ASSERT_EQ(run(), 0) << err.str();
    EXPECT_THAT(out.str(), HasSubstr(copy.string()));
    const auto restored = open_sqlite_store(copy).value();
    EXPECT_EQ(restored->players().value(), store->players().value());
    EXPECT_EQ(restored->tables().value(), store->tables().value());
    EXPECT_EQ(whole_journal(*restored, {1})->size(), 1U);
}

TEST_F(Backup, IsOneFileForItsOwnerAlone) {
    ASSERT_EQ(run(), 0) << err.str();
    EXPECT_EQ(fs::status(copy).permissions(), fs::perms::owner_read | fs::perms::owner_write);
    for (const auto& entry : fs::directory_iterator(folder.path())) {
        const std::string name = entry.path().filename();
        EXPECT_TRUE(name == "copy.db" || name.starts_with("billiards.db")) << name;
    }
}

TEST_F(Backup, HoldsOneMomentOfAStoreThatIsWritten) {
    std::atomic<bool> enough = false;
    std::atomic<std::uint64_t> written = 0;
    std::thread writer([&] {
        for (std::uint64_t entry = 1; !enough; entry += 2) {
            // Two at a time: a copy with one of them would be half a commit.
            commit({AppendEntry{{1}, some_entry(entry)}, AppendEntry{{1}, some_entry(entry + 1)}});
            written = entry + 1;
        }
    });
    for (int time = 0; time < 5; ++time) {
        const std::uint64_t before = written;
        EXPECT_EQ(run(), 0) << err.str();
        const auto restored = open_sqlite_store(copy);
        EXPECT_TRUE(restored.ok());
        const std::uint64_t found = whole_journal(**restored, {1})->size();
        EXPECT_GE(found, before);
        EXPECT_EQ(found % 2, 0U);
        for (const char* suffix : {"", "-wal", "-shm"}) fs::remove(copy.string() + suffix);
    }
    enough = true;
    writer.join();
}

TEST_F(Backup, NeverReplacesAFile) {
    std::ofstream(copy) << "something dear";
    EXPECT_EQ(run(), 1);
    EXPECT_THAT(err.str(), AllOf(HasSubstr(copy.string()), HasSubstr("is there already")));
    EXPECT_EQ(fs::file_size(copy), 14U);
}

TEST_F(Backup, SaysWhatIsNotThereAndWhereNothingCanBeWritten) {
    EXPECT_EQ(run(folder.path() / "nowhere"), 1);
    EXPECT_THAT(err.str(), HasSubstr("nowhere"));
    copy = folder.path() / "no" / "such.db";
    EXPECT_EQ(run(), 1);
    EXPECT_THAT(err.str(), HasSubstr("such.db.part: No such file or directory"));
}

TEST_F(Backup, KeepsNoCopyOfADamagedFile) {
    for (std::uint64_t i = 1; i <= 200; ++i) {
        commit({AppendEntry{{1}, some_entry(i, std::string(100, 'r'))}});
    }
    store.reset();
    std::fstream out_of_order(file, std::ios::in | std::ios::out | std::ios::binary);
    out_of_order.seekp(static_cast<std::streamoff>(fs::file_size(file) - 40'000));
    out_of_order << std::string(40'000, '\x5a');
    out_of_order.close();
    EXPECT_EQ(run(), 1);
    EXPECT_THAT(err.str(), HasSubstr("damaged"));
    EXPECT_FALSE(fs::exists(copy));
    EXPECT_FALSE(fs::exists(copy.string() + ".part"));
}

}  // namespace
}  // namespace billiards::server
