// Takes a kind of database; gives the tests that every MatchStore passes. Instantiate with
// INSTANTIATE_TYPED_TEST_SUITE_P(Name, MatchStoreContract, Database), where Database is default
// constructible (empty) and has `std::unique_ptr<MatchStore> open()`, which opens the same data
// every time.
#pragma once

#include "server/store/match_store.h"

#include <gtest/gtest.h>
#include <limits>
#include <memory>
#include <string_view>
#include <vector>

namespace billiards::server {

inline protocol::Bytes bytes_of(std::string_view text) {
    const auto* data = reinterpret_cast<const std::byte*>(text.data());
    return {data, data + text.size()};
}

inline StoredPlayer some_player(std::uint64_t id, std::string name = "Ada#3f21") {
    StoredPlayer player{{id}, std::move(name), {}};
    for (std::size_t i = 0; i < player.token_hash.size(); ++i) {
        player.token_hash[i] = static_cast<std::uint8_t>(id + 3 * i);
    }
    return player;
}

inline StoredMatch some_match(std::uint64_t id, std::uint32_t table = 1) {
    return {.match = {id},
            .table = {table},
            .table_name = "Friday",
            .players = {{{{1}, {2}}}},
            .settings = bytes_of(std::string_view("race\0to 5", 9)),
            .engine = "1"};
}

inline StoredEntry some_entry(std::uint64_t sequence, std::string_view record = "record") {
    return {sequence,
            {bytes_of("shot"), bytes_of("verdict"), bytes_of("layout"), bytes_of(record)}};
}

template <class Database>
class MatchStoreContract : public testing::Test {
  protected:
    void commit(const std::vector<Write>& writes) {
        const auto result = store->commit(writes);
        ASSERT_TRUE(result.ok()) << result.error().detail;
    }
    void reopen() {
        store.reset();
        store = database.open();
    }

    Database database;
    std::unique_ptr<MatchStore> store = database.open();
};

TYPED_TEST_SUITE_P(MatchStoreContract);

TYPED_TEST_P(MatchStoreContract, IsEmptyAtFirst) {
    EXPECT_TRUE(this->store->players().value().empty());
    EXPECT_TRUE(this->store->live_matches().value().empty());
    EXPECT_TRUE(this->store->ended_matches().value().empty());
    EXPECT_TRUE(this->store->journal({1}).value().empty());
    const auto highest = this->store->highest_ids().value();
    EXPECT_EQ(highest.player, 0U);
    EXPECT_EQ(highest.match, 0U);
    EXPECT_EQ(highest.table, 0U);
}

TYPED_TEST_P(MatchStoreContract, KeepsPlayersOverAReopening) {
    const StoredPlayer ada = some_player(1);
    const StoredPlayer grace = some_player(2, "Gr\xc3\xa4\xc3\x9f' OR 1=1;--#0000");
    this->commit({SavePlayer{grace}, SavePlayer{ada}});
    this->reopen();
    EXPECT_EQ(this->store->players().value(), (std::vector{ada, grace}));
}

TYPED_TEST_P(MatchStoreContract, ReplacesAPlayersNameAndHash) {
    this->commit({SavePlayer{some_player(1)}});
    StoredPlayer renamed = some_player(1, "Countess#3f21");
    renamed.token_hash.fill(0xee);
    this->commit({SavePlayer{renamed}});
    EXPECT_EQ(this->store->players().value(), std::vector{renamed});
}

TYPED_TEST_P(MatchStoreContract, KeepsAndForgetsThePreviousHash) {
    StoredPlayer rotating = some_player(1);
    rotating.previous_token_hash = some_player(2).token_hash;
    this->commit({SavePlayer{rotating}});
    this->reopen();
    EXPECT_EQ(this->store->players().value(), std::vector{rotating});
    this->commit({SavePlayer{some_player(1)}});
    EXPECT_EQ(this->store->players().value(), std::vector{some_player(1)});
}

TYPED_TEST_P(MatchStoreContract, KeepsLiveMatchesInAscendingOrderOverAReopening) {
    this->commit({SaveMatch{some_match(7, 3)}, SaveMatch{some_match(2, 4)}});
    this->reopen();
    EXPECT_EQ(this->store->live_matches().value(),
              (std::vector{some_match(2, 4), some_match(7, 3)}));
}

TYPED_TEST_P(MatchStoreContract, ReplacesAMatchThatIsSavedAgain) {
    this->commit({SaveMatch{some_match(2)}, AppendEntry{{2}, some_entry(1)}});
    StoredMatch renamed = some_match(2);
    renamed.table_name = "Saturday";
    this->commit({SaveMatch{renamed}});
    EXPECT_EQ(this->store->live_matches().value(), std::vector{renamed});
    EXPECT_EQ(this->store->journal({2}).value().size(), 1U);
}

TYPED_TEST_P(MatchStoreContract, LeavesFinishedMatchesOutOfTheLiveOnesButKeepsTheirJournal) {
    this->commit({SaveMatch{some_match(1)}, SaveMatch{some_match(2)}});
    this->commit({AppendEntry{{1}, some_entry(1)}, FinishMatch{{1}}});
    this->reopen();
    EXPECT_EQ(this->store->live_matches().value(), std::vector{some_match(2)});
    EXPECT_EQ(this->store->journal({1}).value().size(), 1U);
}

TYPED_TEST_P(MatchStoreContract, GivesEndedMatchesWithTheTimeOfTheirFirstSaving) {
    this->commit({SaveMatch{some_match(3)}, SaveMatch{some_match(1)}, SaveMatch{some_match(2)},
                  FinishMatch{{3}}, FinishMatch{{1}}});
    const auto ended = this->store->ended_matches().value();
    ASSERT_EQ(ended.size(), 2U);
    EXPECT_EQ(ended[0].match, some_match(1));
    EXPECT_EQ(ended[1].match, some_match(3));
    constexpr std::int64_t kYear2026_s = 1'767'225'600;
    EXPECT_GT(ended[0].started_s, kYear2026_s);
    this->commit({SaveMatch{some_match(1)}});
    EXPECT_EQ(this->store->ended_matches().value(), ended);
}

TYPED_TEST_P(MatchStoreContract, GivesBackEveryColumnOfAJournalInAscendingSequence) {
    const StoredEntry choice{2, {bytes_of("choice"), {}, {}, {}}};
    const StoredEntry shot = some_entry(1, std::string_view("\0\xff\0", 3));
    this->commit({SaveMatch{some_match(5)}, SaveMatch{some_match(6)}});
    this->commit({AppendEntry{{5}, shot}, AppendEntry{{5}, choice}, AppendEntry{{6}, shot}});
    this->reopen();
    const auto journal = this->store->journal({5}).value();
    ASSERT_EQ(journal.size(), 2U);
    EXPECT_EQ(journal[0].sequence, 1U);
    EXPECT_EQ(journal[0].entry.command, shot.entry.command);
    EXPECT_EQ(journal[0].entry.verdict, shot.entry.verdict);
    EXPECT_EQ(journal[0].entry.final_layout, shot.entry.final_layout);
    EXPECT_EQ(journal[0].entry.record, shot.entry.record);
    EXPECT_EQ(journal[1].sequence, 2U);
    EXPECT_TRUE(journal[1].entry.record.empty());
}

TYPED_TEST_P(MatchStoreContract, KeepsAMegabyteOfRecord) {
    const std::string record(1'000'000, 'r');
    this->commit({SaveMatch{some_match(1)}, AppendEntry{{1}, some_entry(1, record)}});
    EXPECT_EQ(this->store->journal({1}).value().at(0).entry.record, bytes_of(record));
}

TYPED_TEST_P(MatchStoreContract, KeepsNothingOfACommitThatFails) {
    this->commit({SaveMatch{some_match(1)}, AppendEntry{{1}, some_entry(1)}});
    const auto twice = this->store->commit(
        std::vector<Write>{SavePlayer{some_player(9)}, AppendEntry{{1}, some_entry(2)},
                           FinishMatch{{1}}, AppendEntry{{1}, some_entry(1)}});
    EXPECT_FALSE(twice.ok());
    EXPECT_TRUE(this->store->players().value().empty());
    EXPECT_EQ(this->store->live_matches().value().size(), 1U);
    EXPECT_EQ(this->store->journal({1}).value().size(), 1U);
}

TYPED_TEST_P(MatchStoreContract, GoesOnAfterACommitThatFailed) {
    this->commit({SaveMatch{some_match(1)}, AppendEntry{{1}, some_entry(1)}});
    EXPECT_FALSE(this->store->commit(std::vector<Write>{AppendEntry{{1}, some_entry(1)}}).ok());
    this->commit({AppendEntry{{1}, some_entry(2)}});
    EXPECT_EQ(this->store->journal({1}).value().size(), 2U);
}

TYPED_TEST_P(MatchStoreContract, RefusesAnEntryOfAnUnknownMatch) {
    const auto result = this->store->commit(std::vector<Write>{AppendEntry{{404}, some_entry(1)}});
    ASSERT_FALSE(result.ok());
    EXPECT_EQ(result.error().code, StoreErrorCode::Failed);
}

TYPED_TEST_P(MatchStoreContract, FinishingAnUnknownMatchChangesNothing) {
    this->commit({SaveMatch{some_match(1)}});
    this->commit({FinishMatch{{404}}});
    EXPECT_EQ(this->store->live_matches().value().size(), 1U);
}

TYPED_TEST_P(MatchStoreContract, RemembersTheHighestIdentitiesEvenOfFinishedMatches) {
    this->commit({SavePlayer{some_player(12)}, SaveMatch{some_match(40, 9)},
                  SaveMatch{some_match(41, 8)}, FinishMatch{{40}}, FinishMatch{{41}}});
    this->reopen();
    const auto highest = this->store->highest_ids().value();
    EXPECT_EQ(highest.player, 12U);
    EXPECT_EQ(highest.match, 41U);
    EXPECT_EQ(highest.table, 9U);
}

TYPED_TEST_P(MatchStoreContract, TakesTheLargestTableIdentity) {
    const std::uint32_t largest = std::numeric_limits<std::uint32_t>::max();
    this->commit({SaveMatch{some_match(1, largest)}});
    EXPECT_EQ(this->store->live_matches().value().at(0).table.value, largest);
}

REGISTER_TYPED_TEST_SUITE_P(
    MatchStoreContract, IsEmptyAtFirst, KeepsPlayersOverAReopening, ReplacesAPlayersNameAndHash,
    KeepsAndForgetsThePreviousHash, KeepsLiveMatchesInAscendingOrderOverAReopening,
    ReplacesAMatchThatIsSavedAgain, LeavesFinishedMatchesOutOfTheLiveOnesButKeepsTheirJournal,
    GivesEndedMatchesWithTheTimeOfTheirFirstSaving,
    GivesBackEveryColumnOfAJournalInAscendingSequence, KeepsAMegabyteOfRecord,
    KeepsNothingOfACommitThatFails, GoesOnAfterACommitThatFailed, RefusesAnEntryOfAnUnknownMatch,
    FinishingAnUnknownMatchChangesNothing, RemembersTheHighestIdentitiesEvenOfFinishedMatches,
    TakesTheLargestTableIdentity);

}  // namespace billiards::server
