// Holds the SQLite store against disks that are full, files that others hold, damage, and folders
// that go away: what was committed stays, and it goes on by itself.
#include "tests/server/store/opened_store.h"

#include <SQLiteCpp/Database.h>
#include <SQLiteCpp/Transaction.h>
#include <csignal>
#include <fstream>
#include <gmock/gmock.h>
#include <sys/resource.h>

namespace billiards::server {
namespace {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::HasSubstr;

class FailingStore : public StoreTest {
  protected:
    FailingStore() { open(); }

    void expect_it_goes_on() {
        commit({SavePlayer{some_player(200)}});
        EXPECT_EQ(store->player_named(some_player(200).name).value(), PlayerId{200});
    }
};

TEST_F(FailingStore, KeepsWhatIsCommittedWhenTheDiskIsFullAndGoesOnWhenThereIsRoom) {
    commit({SaveMatch{some_match(1)}});
    store.reset();
    const std::int64_t pages =
        SQLite::Database(file.string()).execAndGet("PRAGMA page_count").getInt64();
    options.most_pages = pages + 8;
    open();
    std::uint64_t entries = 0;
    std::string record(9000, 'r');
    for (std::size_t at = 0; at < record.size(); ++at) {
        record[at] = static_cast<char>((at * at * 31 + at / 7) % 251);
    }
    const auto append = [&] {
        return store->commit(std::vector<Write>{AppendEntry{{1}, some_entry(entries + 1, record)}});
    };
    auto appended = append();
    for (; appended.ok() && entries < 1000; appended = append()) ++entries;
    ASSERT_FALSE(appended.ok());
    EXPECT_EQ(appended.error().code, StoreErrorCode::Full);
    EXPECT_EQ(whole_journal(*store, {1})->size(), entries);
    EXPECT_FALSE(append().ok());
    options.most_pages = 1'000'000;
    open();
    EXPECT_EQ(whole_journal(*store, {1})->size(), entries);
    EXPECT_TRUE(append().ok());
    EXPECT_EQ(whole_journal(*store, {1})->size(), entries + 1);
}

/// No file can grow while it lives.
class NoRoom {
  public:
    NoRoom() : handler_(std::signal(SIGXFSZ, SIG_IGN)) {
        ::getrlimit(RLIMIT_FSIZE, &before_);
        rlimit none = before_;
        none.rlim_cur = 0;
        ::setrlimit(RLIMIT_FSIZE, &none);
    }
    ~NoRoom() {
        ::setrlimit(RLIMIT_FSIZE, &before_);
        std::signal(SIGXFSZ, handler_);
    }
    NoRoom(const NoRoom&) = delete;
    NoRoom& operator=(const NoRoom&) = delete;

  private:
    void (*handler_)(int);
    rlimit before_{};
};

TEST_F(FailingStore, GoesOnByItselfOnceTheSystemTakesWritesAgain) {
    commit({SavePlayer{some_player(1)}});
    {
        const NoRoom no_room;
        EXPECT_EQ(failure({SavePlayer{some_player(2)}}), StoreErrorCode::Disk);
        EXPECT_EQ(failure({SavePlayer{some_player(3)}}), StoreErrorCode::Disk);
    }
    EXPECT_EQ(store->players()->size(), 1U);
    expect_it_goes_on();
}

TEST_F(FailingStore, IsBusyWhileAnotherProcessHoldsTheFileAndGoesOnAfterwards) {
    options.busy_timeout = std::chrono::milliseconds(1);
    open();
    {
        SQLite::Database other(file.string(), SQLite::OPEN_READWRITE);
        const SQLite::Transaction holds(other, SQLite::TransactionBehavior::IMMEDIATE);
        EXPECT_EQ(failure({SavePlayer{some_player(1)}}), StoreErrorCode::Busy);
        EXPECT_TRUE(store->players().ok());
    }
    expect_it_goes_on();
}

TEST_F(FailingStore, TakesNoWritesIntoAFolderThatWasDeleted) {
    fs::remove_all(folder.path());
    EXPECT_EQ(failure({SavePlayer{some_player(1)}}), StoreErrorCode::Gone);
}

TEST_F(FailingStore, TakesNoWritesBesideALogThatWasDeleted) {
    fs::remove(file.string() + "-wal");
    EXPECT_EQ(failure({SavePlayer{some_player(1)}}), StoreErrorCode::Gone);
}

TEST_F(FailingStore, NamesAReplacedFileAndGoesOnOnceTheRightOneIsBack) {
    const fs::path away = folder.path() / "away";
    fs::rename(file, away);
    std::ofstream(file) << "another one";
    const auto done = store->commit(std::vector<Write>{SavePlayer{some_player(1)}});
    ASSERT_FALSE(done.ok());
    EXPECT_EQ(done.error().code, StoreErrorCode::Gone);
    EXPECT_THAT(done.error().detail, AllOf(HasSubstr(file.string()), HasSubstr("put it back")));
    fs::rename(away, file);
    expect_it_goes_on();
    EXPECT_EQ(store->players()->size(), 1U);
}

/// Overwrites from there to the end.
void damage(const fs::path& file, std::uintmax_t from) {
    std::fstream out(file, std::ios::in | std::ios::out | std::ios::binary);
    out.seekp(static_cast<std::streamoff>(from));
    out << std::string(fs::file_size(file) - from, '\x5a');
}

TEST_F(FailingStore, SaysOfADamagedFileWhichItIsAndWhatToDo) {
    commit({SavePlayer{some_player(1)}});
    store.reset();
    damage(file, 100);
    const auto opened = open_sqlite_store(file);
    ASSERT_FALSE(opened.ok());
    EXPECT_EQ(opened.error().code, StoreErrorCode::Corrupt);
    EXPECT_THAT(opened.error().detail,
                AllOf(HasSubstr(file.string()), HasSubstr("backup"), HasSubstr("export")));
}

TEST_F(FailingStore, SaysCorruptWhereDamageIsFoundWhileItRuns) {
    commit({SaveMatch{some_match(1)}});
    for (std::uint64_t i = 1; i <= 200; ++i) {
        commit({AppendEntry{{1}, some_entry(i, std::string(100, 'r'))}});
    }
    store.reset();
    damage(file, 8192);
    const auto opened = open_sqlite_store(file);
    if (opened.ok()) {  // The damage may lie where opening does not look.
        const auto journal = whole_journal(**opened, {1});
        ASSERT_FALSE(journal.ok());
        EXPECT_EQ(journal.error().code, StoreErrorCode::Corrupt);
    } else {
        EXPECT_EQ(opened.error().code, StoreErrorCode::Corrupt);
    }
}

TEST_F(FailingStore, LosesOnlyTheMatchWhoseEntryIsDamaged) {
    commit({SaveMatch{some_match(1)}, AppendEntry{{1}, some_entry(1)}, SaveMatch{some_match(2)},
            AppendEntry{{2}, some_entry(1)}});
    SQLite::Database(file.string(), SQLite::OPEN_READWRITE)
        .exec("UPDATE entries SET record = x'28b52ffd00' WHERE match_id = 1");
    EXPECT_FALSE(whole_journal(*store, {1}).ok());
    EXPECT_EQ(store->live_matches()->size(), 2U);
    EXPECT_EQ(whole_journal(*store, {2})->size(), 1U);
}

}  // namespace
}  // namespace billiards::server
