// Holds exporting against a store that another process could be writing.
#include "server/export.h"

#include "common/replay/replay_file.h"
#include "common/replay/verify.h"
#include "server/store/data_folder.h"
#include "server/store/sqlite_store.h"
#include "tests/common/replay/bot_match.h"
#include "tests/support/temporary_folder.h"

#include <fstream>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <iterator>
#include <sstream>

namespace billiards::server {
namespace {

using testing::HasSubstr;

struct Ran {
    int exit_code = 0;
    std::string out;
    std::string err;
};

/// A folder in which match 1 has ended and match 2 has not; the store is still open.
class Export : public testing::Test {
  protected:
    Export() {
        commit({SavePlayer{{{7}, replay_.header.players[model::Seat::First], {}, {}}},
                SavePlayer{{{8}, replay_.header.players[model::Seat::Second], {}, {}}}});
        for (const std::uint64_t id : {1U, 2U}) save_match({id});
        commit({FinishMatch{.match = {1}, .result = {.shots = 1}}});
    }

    void save_match(MatchId id) {
        commit({SaveMatch{
            {.match = id,
             .table = {1},
             .table_name = replay_.header.table,
             .players = {{{{7}, {8}}}},
             .settings = protocol::encode_settings(replay_.header.settings, replay_.header.seed),
             .engine = replay_.header.engine}}});
        for (std::size_t i = 0; i < replay_.entries.size(); ++i) {
            commit({AppendEntry{id, {i + 1, protocol::encode_entry(replay_.entries[i])}}});
        }
    }
    void commit(const std::vector<Write>& writes) {
        const auto done = store_->commit(writes);
        ASSERT_TRUE(done.ok()) << done.error().detail;
    }
    Ran run(std::optional<MatchId> match) {
        std::ostringstream out;
        std::ostringstream err;
        const int exit_code =
            export_match({.data = folder_.path(), .match = match, .file = file_}, out, err);
        return {exit_code, out.str(), err.str()};
    }

    replay::Replay replay_ = replay::bot_match(replay::race_to(1), 4);
    support::TemporaryFolder folder_;
    std::filesystem::path file_ = folder_.path() / "exported.billiards";
    std::unique_ptr<MatchStore> store_ =
        open_sqlite_store(database_file_in(folder_.path())).value();
};

TEST_F(Export, ListsWhatHasEnded) {
    const Ran ran = run({});
    EXPECT_EQ(ran.exit_code, 0) << ran.err;
    EXPECT_THAT(ran.out, testing::MatchesRegex(
                             " +1  20[0-9: -]+ UTC  Ada#3f21 - Grace#84ac, table \"Friday\"\n"));
}

TEST_F(Export, WritesAMatchThatVerifies) {
    const Ran ran = run(MatchId{1});
    EXPECT_EQ(ran.exit_code, 0) << ran.err;
    EXPECT_THAT(ran.out, HasSubstr(file_.string()));
    std::ifstream in(file_, std::ios::binary);
    const std::string content{std::istreambuf_iterator<char>(in), {}};
    const auto opened = replay::from_bytes(std::as_bytes(std::span(content)));
    ASSERT_TRUE(opened.ok()) << opened.error().detail;
    replay::Replay expected = replay_;
    expected.header.started_s = opened->replay.header.started_s;
    EXPECT_EQ(opened->replay, expected);
    EXPECT_TRUE(replay::verify(opened->replay).ok());
}

TEST_F(Export, KeepsBackAMatchThatIsStillPlayed) {
    for (const std::uint64_t id : {2U, 99U}) {
        const Ran ran = run(MatchId{id});
        EXPECT_EQ(ran.exit_code, 1);
        EXPECT_THAT(ran.err, HasSubstr("is not there, or has not ended"));
    }
    EXPECT_FALSE(std::filesystem::exists(file_));
}

TEST_F(Export, SaysWhereNothingIsKeptAndWhatCannotBeWritten) {
    file_ = folder_.path() / "no" / "such.billiards";
    EXPECT_THAT(run(MatchId{1}).err, HasSubstr("such.billiards: No such file or directory"));
    std::ostringstream err;
    const auto nowhere = folder_.path() / "nowhere";
    EXPECT_EQ(export_match({.data = nowhere, .match = {}, .file = {}}, err, err), 1);
    EXPECT_THAT(err.str(), HasSubstr("nowhere"));
    EXPECT_FALSE(std::filesystem::exists(nowhere));
}

TEST_F(Export, ChangesNothingInTheStore) {
    const auto reader = open_sqlite_reader(database_file_in(folder_.path())).value();
    EXPECT_FALSE(reader->commit(std::vector<Write>{FinishMatch{{2}}}).ok());
    EXPECT_EQ(reader->live_matches()->size(), 1U);
}

}  // namespace
}  // namespace billiards::server
