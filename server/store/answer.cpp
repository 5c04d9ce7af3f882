// Takes a store and a question about what has been played; gives the answer, ready to be sent.
#include "server/store/answer.h"

#include "common/protocol/limits.h"
#include "server/table/refold.h"

#include <algorithm>
#include <utility>

namespace billiards::server {
namespace {

namespace say = protocol::server;
using protocol::RefusedCode;

say::Refused refused(RefusedCode code, std::string detail) {
    return {.code = code, .match_code = {}, .detail = std::move(detail)};
}

/// What the disk says is for the log, not for whoever asks.
say::Refused cannot_read() {
    return busy("what has been played cannot be read now");
}

ArchiveAnswer sent(protocol::ServerMessage message) {
    return protocol::encode(message);
}

base::Result<PlayerId, say::Refused> find_player(MatchStore& store, const std::string& name) {
    const auto found = store.player_named(name);
    if (!found) return cannot_read();
    if (!*found) return refused(RefusedCode::UnknownPlayer, "nobody here is called that");
    return **found;
}

say::HistoryRow row_of(const StoredResult& stored) {
    return {.match = stored.match.value,
            .ended_s = stored.ended_s,
            .game = stored.result.game,
            .names = stored.names,
            .racks_won = stored.result.racks_won,
            .winner = stored.result.winner,
            .shots = stored.result.shots,
            .ending = stored.result.ending};
}

ArchiveAnswer answer(MatchStore& store, const AskHistory& asked) {
    HistoryQuery query{.asker = asked.asker,
                       .player = {},
                       .before = asked.before,
                       .at_most = protocol::kMaxHistoryRows + 1};
    if (!asked.player.empty()) {
        const auto player = find_player(store, asked.player);
        if (!player) return player.error();
        query.player = *player;
    }
    auto results = store.history(query);
    if (!results) return cannot_read();
    say::HistoryPage page;
    page.has_more = results->size() > protocol::kMaxHistoryRows;
    if (page.has_more) results->pop_back();
    for (const StoredResult& result : *results) page.rows.push_back(row_of(result));
    return sent(std::move(page));
}

ArchiveAnswer answer(MatchStore& store, const AskRecord& asked) {
    const auto player = find_player(store, asked.player);
    if (!player) return player.error();
    const auto standing = store.standing(*player, asked.asker);
    if (!standing) return cannot_read();
    return sent(say::PlayerRecord{.name = asked.player,
                                  .games = standing->games,
                                  .wins = standing->wins,
                                  .draws = standing->draws,
                                  .rating = standing->rating.rating,
                                  .deviation = standing->rating.deviation});
}

/// The match, if the asker may see any of it.
base::Result<KnownMatch, say::Refused> find_match(MatchStore& store, const AskReplay& asked) {
    const auto unknown = refused(RefusedCode::UnknownMatch, "no such match is kept");
    const auto known = store.find_match(asked.match);
    if (!known) return cannot_read();
    if (!*known) return unknown;
    if (asked.steps) return **known;
    const auto may_see = store.may_see(asked.match, asked.asker);
    if (!may_see) return cannot_read();
    if (!*may_see) return unknown;
    return **known;
}

/// Steps of a match from one on, as many as a chunk holds.
class Chunk {
  public:
    Chunk(MatchId match, std::uint64_t first, std::uint64_t total) {
        chunk_.match = match.value;
        chunk_.first = first;
        chunk_.total = total;
    }

    bool is_full() const {
        return chunk_.messages.size() == protocol::kMaxReplaySteps ||
               chunk_.first + chunk_.messages.size() >= chunk_.total;
    }
    /// The next step; whether it was taken.
    bool add(const protocol::ServerMessage& message) {
        const protocol::SharedFrame frame = protocol::encode(message);
        const auto begin = frame->begin() + protocol::kFrameHeaderBytes;
        const auto size = static_cast<std::size_t>(frame->end() - begin);
        if (!chunk_.messages.empty() && bytes_ + size > protocol::kMaxReplayBytes) return false;
        bytes_ += size;
        chunk_.messages.emplace_back(begin, frame->end());
        return true;
    }
    say::ReplayChunk take() { return std::move(chunk_); }

  private:
    say::ReplayChunk chunk_;
    std::size_t bytes_ = 0;
};

/// The error says what is wrong with the journal.
base::Result<base::Done, std::string> fill(Chunk& chunk, MatchStore& store,
                                           const StoredMatch& match, std::uint64_t first) {
    auto fold = JournalFold::begin(match);
    if (!fold) return fold.error();
    if (first == 0 && !chunk.is_full())
        chunk.add(say::MatchStarted{.sequence = 0, .state = fold->state(), .turn = {}});
    std::string wrong;
    const auto add = [&](const StoredEntry& stored) {
        if (chunk.is_full()) return false;
        const auto folded = fold->add(stored);
        if (!folded) return wrong = folded.error(), false;
        if (stored.sequence < first) return true;
        const auto told = told_of(stored, fold->state());
        if (!told) return wrong = told.error(), false;
        return chunk.add(*told);
    };
    const auto read = store.journal(match.match, add, first);
    if (!read) return read.error().detail;
    if (!wrong.empty()) return wrong;
    return base::Done{};
}

ArchiveAnswer answer(MatchStore& store, const AskReplay& asked) {
    const auto known = find_match(store, asked);
    if (!known) return known.error();
    const std::uint64_t steps = known->entries + 1;
    Chunk chunk(asked.match, asked.first, std::min(steps, asked.steps.value_or(steps)));
    const auto filled = fill(chunk, store, known->match, asked.first);
    if (!filled) return refused(RefusedCode::UnknownMatch, "this match cannot be read any more");
    return sent(chunk.take());
}

}  // namespace

ArchiveAnswer answer_to(MatchStore& store, const Question& question) {
    return std::visit([&store](const auto& asked) { return answer(store, asked); }, question);
}

protocol::server::Refused busy(std::string detail) {
    return refused(RefusedCode::Busy, std::move(detail));
}

}  // namespace billiards::server
