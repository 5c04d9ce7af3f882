// Takes writes as the store would; makes them durable, or fails, when the test says so.
#pragma once

#include "server/lobby/lobby.h"
#include "server/store/committer.h"

#include <algorithm>
#include <cstddef>
#include <deque>
#include <gtest/gtest.h>
#include <iterator>
#include <map>
#include <optional>
#include <set>
#include <utility>
#include <variant>
#include <vector>

namespace billiards::server {

struct DurableMatch {
    StoredMatch match;
    std::vector<StoredEntry> entries;
};

/// What is durable, as values that a test may spoil.
struct DurableWorld {
    std::vector<StoredPlayer> players;
    std::vector<StoredTable> tables;
    std::vector<DurableMatch> matches;  ///< Those that are live.
    std::vector<DurableMatch> ended;
    MatchStore::HighestIds highest;

    /// As a server reads it; only as long as this lives.
    StoredWorld stored() const {
        return {.players = players,
                .tables = tables,
                .highest = highest,
                .last_match = [this](protocol::TableId table) { return last_match(table); },
                .refold =
                    [this](const StoredMatch& match) {
                        for (const auto* kept : {&matches, &ended}) {
                            for (const DurableMatch& one : *kept) {
                                if (one.match.match == match.match) {
                                    return refold_journal(one.match, one.entries);
                                }
                            }
                        }
                        return base::Result<Refolded, std::string>(std::string("no such match"));
                    }};
    }

  private:
    StoreResult<std::optional<KnownMatch>> last_match(protocol::TableId table) const {
        std::optional<KnownMatch> last;
        for (const bool is_over : {false, true}) {
            for (const DurableMatch& one : is_over ? ended : matches) {
                if (one.match.table != table) continue;
                if (last && one.match.match < last->match.match) continue;
                last.emplace();
                last->match = one.match;
                last->is_over = is_over;
            }
        }
        return last;
    }
};

class ManualCommitter final : public Committer {
  public:
    /// How long each commit says that it took.
    base::Duration takes = std::chrono::milliseconds(3);

    void submit(std::vector<Write> writes, Done done) override {
        waiting_.push_back({std::move(writes), std::move(done)});
    }

    std::size_t waiting() const { return waiting_.size(); }
    /// The writes that have waited longest.
    const std::vector<Write>& next() const { return waiting_.front().writes; }

    void complete() {
        Submission submission = take();
        for (const Write& write : submission.writes) {
            std::visit([this](const auto& one) { keep(one); }, write);
        }
        submission.done({.result = base::Done{}, .took = takes});
    }
    void fail() {
        take().done({.result = StoreError{StoreErrorCode::Full, "disk full"}, .took = takes});
    }
    void complete_all() {
        while (!waiting_.empty()) complete();
    }
    /// The server is killed: nobody waits for the answers any more.
    void kill() { waiting_.clear(); }

    /// What a server that starts now would find.
    DurableWorld durable() const {
        DurableWorld world;
        world.highest.table = highest_table_;
        for (const auto& [id, player] : players_) {
            world.players.push_back(player);
            world.highest.player = std::max(world.highest.player, id.value);
        }
        for (const auto& [id, table] : tables_) world.tables.push_back(table);
        for (const auto& [id, match] : matches_) {
            world.highest.match = std::max(world.highest.match, id.value);
            auto& kept = match.result ? world.ended : world.matches;
            if (!match.result || match.result->shots > 0) {
                kept.push_back({match.stored, match.entries});
            }
        }
        return world;
    }
    std::vector<StoredEntry> journal(MatchId match) const { return matches_.at(match).entries; }
    std::optional<StoredTable> table(protocol::TableId id) const {
        const auto found = tables_.find(id);
        return found == tables_.end() ? std::nullopt : std::optional(found->second);
    }
    /// How a match ended; none while it is live.
    std::optional<MatchResult> result(MatchId match) const { return matches_.at(match).result; }

  private:
    struct Submission {
        std::vector<Write> writes;
        Done done;
    };
    struct Match {
        StoredMatch stored;
        std::vector<StoredEntry> entries;
        std::optional<MatchResult> result{};
    };

    Submission take() {
        CHECK(!waiting_.empty());
        Submission submission = std::move(waiting_.front());
        waiting_.pop_front();
        return submission;
    }
    void keep(const SavePlayer& write) { players_[write.player.player] = write.player; }
    void keep(const SaveMatch& write) {
        EXPECT_TRUE(tables_.contains(write.match.table)) << "a match without its table";
        matches_[write.match.match].stored = write.match;
    }
    void keep(const AppendEntry& write) {
        Match& match = matches_.at(write.match);
        EXPECT_EQ(write.entry.sequence, match.entries.size() + 1);
        EXPECT_FALSE(match.result.has_value());
        match.entries.push_back(write.entry);
    }
    void keep(const FinishMatch& write) { matches_.at(write.match).result = write.result; }
    void keep(const SaveTable& write) {
        const protocol::TableId id = write.table.table;
        EXPECT_FALSE(removed_.contains(id)) << "a number given twice";
        highest_table_ = std::max(highest_table_, id.value);
        tables_[id] = write.table;
    }
    void keep(const RemoveTable& write) {
        tables_.erase(write.table);
        removed_.insert(write.table);
    }

    std::deque<Submission> waiting_;
    std::map<PlayerId, StoredPlayer> players_;
    std::map<MatchId, Match> matches_;
    std::map<protocol::TableId, StoredTable> tables_;
    std::set<protocol::TableId> removed_;
    std::uint32_t highest_table_ = 0;
};

}  // namespace billiards::server
