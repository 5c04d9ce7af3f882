// Takes a kind of database; gives the tests that every MatchStore passes. Instantiate with
// INSTANTIATE_TYPED_TEST_SUITE_P(Name, MatchStoreContract, Database), where Database is default
// constructible (empty) and has `std::unique_ptr<MatchStore> open()`, which opens the same data
// every time.
#pragma once

#include "tests/server/store/stored_values.h"

#include <gtest/gtest.h>
#include <limits>
#include <memory>
#include <string_view>
#include <vector>

namespace billiards::server {

template <class Database>
class MatchStoreContract : public testing::Test {
  protected:
    void commit(const std::vector<Write>& writes) {
        const auto result = store->commit(writes);
        ASSERT_TRUE(result.ok()) << result.error().detail;
    }
    std::vector<StoredEntry> journal(MatchId match) { return whole_journal(*store, match).value(); }
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
    EXPECT_TRUE(this->journal({1}).empty());
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
    EXPECT_EQ(this->journal({2}).size(), 1U);
}

TYPED_TEST_P(MatchStoreContract, LeavesFinishedMatchesOutOfTheLiveOnesButKeepsTheirJournal) {
    this->commit({SaveMatch{some_match(1)}, SaveMatch{some_match(2)}});
    this->commit({AppendEntry{{1}, some_entry(1)}, finished(1)});
    this->reopen();
    EXPECT_EQ(this->store->live_matches().value(), std::vector{some_match(2)});
    EXPECT_EQ(this->journal({1}).size(), 1U);
}

TYPED_TEST_P(MatchStoreContract, GivesEndedMatchesWithTheTimeOfTheirFirstSaving) {
    this->commit({SaveMatch{some_match(3)}, SaveMatch{some_match(1)}, SaveMatch{some_match(2)},
                  finished(3), finished(1)});
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
    const auto journal = this->journal({5});
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
    EXPECT_EQ(this->journal({1}).at(0).entry.record, bytes_of(record));
}

TYPED_TEST_P(MatchStoreContract, KeepsNothingOfACommitThatFails) {
    this->commit({SaveMatch{some_match(1)}, AppendEntry{{1}, some_entry(1)}});
    const auto twice = this->store->commit(
        std::vector<Write>{SavePlayer{some_player(9)}, AppendEntry{{1}, some_entry(2)}, finished(1),
                           AppendEntry{{1}, some_entry(1)}});
    EXPECT_FALSE(twice.ok());
    EXPECT_TRUE(this->store->players().value().empty());
    EXPECT_EQ(this->store->live_matches().value().size(), 1U);
    EXPECT_EQ(this->journal({1}).size(), 1U);
}

TYPED_TEST_P(MatchStoreContract, GoesOnAfterACommitThatFailed) {
    this->commit({SaveMatch{some_match(1)}, AppendEntry{{1}, some_entry(1)}});
    EXPECT_FALSE(this->store->commit(std::vector<Write>{AppendEntry{{1}, some_entry(1)}}).ok());
    this->commit({AppendEntry{{1}, some_entry(2)}});
    EXPECT_EQ(this->journal({1}).size(), 2U);
}

TYPED_TEST_P(MatchStoreContract, RefusesAnEntryOfAnUnknownMatch) {
    const auto result = this->store->commit(std::vector<Write>{AppendEntry{{404}, some_entry(1)}});
    ASSERT_FALSE(result.ok());
    EXPECT_EQ(result.error().code, StoreErrorCode::Failed);
}

TYPED_TEST_P(MatchStoreContract, FinishingAnUnknownMatchChangesNothing) {
    this->commit({SaveMatch{some_match(1)}});
    this->commit({finished(404)});
    EXPECT_EQ(this->store->live_matches().value().size(), 1U);
}

TYPED_TEST_P(MatchStoreContract, RemembersTheHighestIdentitiesEvenOfFinishedMatches) {
    this->commit({SavePlayer{some_player(12)}, SaveMatch{some_match(40, 9)},
                  SaveMatch{some_match(41, 8)}, finished(40), finished(41)});
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

TYPED_TEST_P(MatchStoreContract, NeverGivesTheNumbersOfWhatIsGoneAgain) {
    this->commit({SaveTable{some_table(17)}, RemoveTable{{17}}, SaveMatch{some_match(5, 3)},
                  FinishMatch{{5}}});
    this->reopen();
    const auto highest = this->store->highest_ids().value();
    EXPECT_EQ(highest.table, 17U);
    EXPECT_EQ(highest.match, 5U);
}

TYPED_TEST_P(MatchStoreContract, KeepsTablesWithTheirListsInAscendingOrderOverAReopening) {
    StoredTable full = some_table(9);
    full.is_private = true;
    full.passcode_hash = SecretHash{1, 2, 3};
    full.passcode_salt = {4, 5, 6};
    full.invites = {{SecretHash{7}, true}, {SecretHash{6}, false}};
    full.kicked = {{12}, {11}};
    full.seats = {{{PlayerId{3}, std::nullopt}}};
    StoredTable plain = some_table(4);
    plain.seats[model::Seat::Second] = PlayerId{0x8000'0000'0000'0001};
    this->commit({SaveTable{full}, SaveTable{plain}});
    this->reopen();
    EXPECT_EQ(this->store->tables().value(), (std::vector{plain, full}));
}

TYPED_TEST_P(MatchStoreContract, ReplacesATableAsAWholeAndRemovesIt) {
    StoredTable table = some_table(4);
    table.invites = {{SecretHash{7}, true}};
    table.kicked = {{12}};
    table.passcode_hash = SecretHash{1};
    this->commit({SaveTable{table}, SaveTable{some_table(5)}});
    this->commit({SaveTable{some_table(4)}});
    EXPECT_EQ(this->store->tables().value(), (std::vector{some_table(4), some_table(5)}));
    this->commit({SaveTable{table}});
    this->commit({RemoveTable{{4}}});
    EXPECT_EQ(this->store->tables().value(), std::vector{some_table(5)});
    this->commit({RemoveTable{{404}}});
    EXPECT_EQ(this->store->tables().value().size(), 1U);
}

TYPED_TEST_P(MatchStoreContract, GivesATablesNewestMatchAndWhetherItIsOver) {
    EXPECT_EQ(this->store->last_match({3}).value(), std::nullopt);
    this->commit({SaveMatch{some_match(1, 3)}, SaveMatch{some_match(2, 4)}, finished(1)});
    EXPECT_EQ(this->store->last_match({3}).value(), (KnownMatch{some_match(1, 3), true, 0}));
    this->commit({SaveMatch{some_match(7, 3)}});
    EXPECT_EQ(this->store->last_match({3}).value(), (KnownMatch{some_match(7, 3), false, 0}));
    this->commit({FinishMatch{{7}}});
    EXPECT_EQ(this->store->last_match({3}).value(), (KnownMatch{some_match(1, 3), true, 0}));
}

TYPED_TEST_P(MatchStoreContract, FindsAMatchByItsNumber) {
    this->commit({SaveMatch{some_match(1)}, SaveMatch{some_match(2)}, finished(1)});
    this->commit({AppendEntry{{2}, some_entry(1)}, AppendEntry{{2}, some_entry(2)}});
    EXPECT_EQ(this->store->find_match({1}).value(), (KnownMatch{some_match(1), true, 0}));
    EXPECT_EQ(this->store->find_match({2}).value(), (KnownMatch{some_match(2), false, 2}));
    EXPECT_EQ(this->store->find_match({3}).value(), std::nullopt);
}

TYPED_TEST_P(MatchStoreContract, DoesNotKeepAMatchWithoutAShot) {
    this->commit({SaveMatch{some_match(1)}, AppendEntry{{1}, some_entry(1)}});
    this->commit({FinishMatch{{1}}});
    EXPECT_TRUE(this->store->live_matches().value().empty());
    EXPECT_TRUE(this->store->ended_matches().value().empty());
    EXPECT_TRUE(this->journal({1}).empty());
    EXPECT_TRUE(this->store->history({.asker = {1}, .at_most = 9}).value().empty());
}

TYPED_TEST_P(MatchStoreContract, VisitsOneEntryAfterAnotherUntilTheVisitorHasEnough) {
    this->commit({SaveMatch{some_match(1)}, AppendEntry{{1}, some_entry(1)},
                  AppendEntry{{1}, some_entry(2)}, AppendEntry{{1}, some_entry(3)}});
    std::vector<std::uint64_t> seen;
    const auto visit = [&](const StoredEntry& entry) {
        seen.push_back(entry.sequence);
        return entry.sequence < 2;
    };
    ASSERT_TRUE(this->store->journal({1}, visit, 0).ok());
    EXPECT_EQ(seen, (std::vector<std::uint64_t>{1, 2}));
}

TYPED_TEST_P(MatchStoreContract, LeavesTheRecordsOutUpToWhereTheyAreAskedFor) {
    this->commit({SaveMatch{some_match(1)}, AppendEntry{{1}, some_entry(1)},
                  AppendEntry{{1}, some_entry(2)}});
    const auto visit = [&](const StoredEntry& entry) {
        EXPECT_EQ(entry.entry.record.empty(), entry.sequence < 2);
        EXPECT_EQ(entry.entry.final_layout, some_entry(1).entry.final_layout);
        return true;
    };
    ASSERT_TRUE(this->store->journal({1}, visit, 2).ok());
}

TYPED_TEST_P(MatchStoreContract, FindsAPlayerByTheShownName) {
    this->commit({SavePlayer{some_player(4, "Ada#0001")}, SavePlayer{some_player(5, "Ada#0002")}});
    EXPECT_EQ(this->store->player_named("Ada#0002").value(), PlayerId{5});
    EXPECT_EQ(this->store->player_named("Ada").value(), std::nullopt);
}

TYPED_TEST_P(MatchStoreContract, KeepsHowAMatchEnded) {
    this->commit({SavePlayer{some_player(1, "Ada#0001")}, SavePlayer{some_player(2, "Grace#0002")},
                  SaveMatch{some_match(6)}});
    FinishMatch finish = finished(6, model::Seat::Second);
    finish.result.racks_won = {{{2, 5}}};
    finish.result.ending = protocol::server::Ending::Claimed;
    finish.result.game = rules::Game::StraightPool;
    this->commit({finish});
    this->reopen();
    const auto rows = this->store->history({.asker = {99}, .at_most = 9}).value();
    ASSERT_EQ(rows.size(), 1U);
    EXPECT_EQ(rows[0].match, MatchId{6});
    EXPECT_EQ(rows[0].result, finish.result);
    EXPECT_EQ(rows[0].players, some_match(6).players);
    EXPECT_EQ(rows[0].names, (model::PerSeat<std::string>{{{"Ada#0001", "Grace#0002"}}}));
    constexpr std::int64_t kYear2026_s = 1'767'225'600;
    EXPECT_GT(rows[0].ended_s, kYear2026_s);
}

TYPED_TEST_P(MatchStoreContract, CountsWinsLossesAndDrawsAndRatesThem) {
    this->commit({SaveMatch{some_match(1)}, finished(1, model::Seat::First)});
    this->commit({SaveMatch{some_match(2)}, finished(2, std::nullopt)});
    const Standing winner = this->store->standing({1}, {99}).value();
    EXPECT_EQ(winner.games, 2U);
    EXPECT_EQ(winner.wins, 1U);
    EXPECT_EQ(winner.draws, 1U);
    EXPECT_GT(winner.rating.rating, kFirstRating);
    EXPECT_LT(winner.rating.deviation, kMostDeviation);
    const Standing loser = this->store->standing({2}, {2}).value();
    EXPECT_EQ(loser.wins, 0U);
    EXPECT_LT(loser.rating.rating, kFirstRating);
    EXPECT_EQ(this->store->standing({3}, {3}).value(), Standing{});
}

TYPED_TEST_P(MatchStoreContract, FinishesAMatchOnlyOnce) {
    this->commit({SaveMatch{some_match(1)}, finished(1)});
    this->commit({finished(1), FinishMatch{{1}}});
    EXPECT_EQ(this->store->standing({1}, {1}).value().games, 1U);
    EXPECT_EQ(this->store->ended_matches().value().size(), 1U);
}

REGISTER_TYPED_TEST_SUITE_P(
    MatchStoreContract, IsEmptyAtFirst, KeepsPlayersOverAReopening, ReplacesAPlayersNameAndHash,
    KeepsAndForgetsThePreviousHash, KeepsLiveMatchesInAscendingOrderOverAReopening,
    ReplacesAMatchThatIsSavedAgain, LeavesFinishedMatchesOutOfTheLiveOnesButKeepsTheirJournal,
    GivesEndedMatchesWithTheTimeOfTheirFirstSaving,
    GivesBackEveryColumnOfAJournalInAscendingSequence, KeepsAMegabyteOfRecord,
    KeepsNothingOfACommitThatFails, GoesOnAfterACommitThatFailed, RefusesAnEntryOfAnUnknownMatch,
    FinishingAnUnknownMatchChangesNothing, RemembersTheHighestIdentitiesEvenOfFinishedMatches,
    TakesTheLargestTableIdentity, NeverGivesTheNumbersOfWhatIsGoneAgain,
    KeepsTablesWithTheirListsInAscendingOrderOverAReopening, ReplacesATableAsAWholeAndRemovesIt,
    GivesATablesNewestMatchAndWhetherItIsOver, FindsAMatchByItsNumber,
    DoesNotKeepAMatchWithoutAShot, VisitsOneEntryAfterAnotherUntilTheVisitorHasEnough,
    LeavesTheRecordsOutUpToWhereTheyAreAskedFor, FindsAPlayerByTheShownName, KeepsHowAMatchEnded,
    CountsWinsLossesAndDrawsAndRatesThem, FinishesAMatchOnlyOnce);

}  // namespace billiards::server
