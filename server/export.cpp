// Takes a data folder; gives the matches in it that have ended, or one of them as a file.
#include "server/export.h"

#include "common/replay/replay_file.h"
#include "server/store/data_folder.h"
#include "server/store/sqlite_store.h"

#include <algorithm>
#include <cerrno>
#include <ctime>
#include <fmt/chrono.h>
#include <fmt/ostream.h>
#include <fstream>
#include <ostream>
#include <string>
#include <system_error>
#include <utility>

namespace billiards::server {
namespace {

/// The error is a sentence for whoever typed the command.
template <class T>
using Answer = base::Result<T, std::string>;

std::string name_of(const std::vector<StoredPlayer>& players, PlayerId id) {
    const auto found = std::ranges::find(players, id, &StoredPlayer::player);
    return found == players.end() ? "?" : found->name;
}

Answer<replay::Replay> replay_of(MatchStore& store, const EndedMatch& ended) {
    const StoredMatch& match = ended.match;
    const auto players = store.players();
    if (!players) return players.error().detail;
    const auto journal = whole_journal(store, match.match);
    if (!journal) return journal.error().detail;
    const auto settings = protocol::decode_settings(match.settings);
    if (!settings) return "settings: " + settings.error().detail;
    replay::Replay replay;
    replay.header = {.engine = match.engine,
                     .settings = settings->settings,
                     .seed = settings->seed,
                     .players = {},
                     .table = match.table_name,
                     .started_s = ended.started_s};
    for (const model::Seat seat : model::kSeats) {
        replay.header.players[seat] = name_of(*players, match.players[seat]);
    }
    for (const StoredEntry& stored : *journal) {
        auto entry = protocol::decode_entry(stored.entry);
        if (!entry) return fmt::format("entry {}: {}", stored.sequence, entry.error().detail);
        replay.entries.push_back(std::move(entry).value());
    }
    return replay;
}

Answer<base::Done> write_file(const std::filesystem::path& file, const protocol::Bytes& bytes) {
    errno = 0;
    std::ofstream out(file, std::ios::binary | std::ios::trunc);
    out.write(reinterpret_cast<const char*>(bytes.data()),
              static_cast<std::streamsize>(bytes.size()));
    out.close();
    if (out) return base::Done{};
    return fmt::format("{}: {}", file.string(), std::generic_category().message(errno));
}

Answer<base::Done> list(MatchStore& store, const std::vector<EndedMatch>& matches,
                        std::ostream& out) {
    const auto players = store.players();
    if (!players) return players.error().detail;
    if (matches.empty()) fmt::print(out, "no match has ended yet\n");
    for (const EndedMatch& ended : matches) {
        const auto name = [&](model::Seat seat) {
            return name_of(*players, ended.match.players[seat]);
        };
        fmt::print(out, "{:6}  {:%Y-%m-%d %H:%M} UTC  {} - {}, table \"{}\"\n",
                   ended.match.match.value, fmt::gmtime(std::time_t{ended.started_s}),
                   name(model::Seat::First), name(model::Seat::Second), ended.match.table_name);
    }
    return base::Done{};
}

Answer<base::Done> write_match(MatchStore& store, const std::vector<EndedMatch>& matches,
                               MatchId id, std::filesystem::path file, std::ostream& out) {
    const auto ended =
        std::ranges::find(matches, id, [](const EndedMatch& each) { return each.match.match; });
    if (ended == matches.end()) {
        return fmt::format(
            "match {} is not there, or has not ended: without --match they are "
            "listed",
            id.value);
    }
    const auto replay = replay_of(store, *ended);
    if (!replay) return fmt::format("match {}: {}", id.value, replay.error());
    const auto bytes = replay::to_bytes(*replay);
    if (!bytes) return fmt::format("match {}: {}", id.value, bytes.error().detail);
    if (file.empty()) file = fmt::format("match-{}.billiards", id.value);
    auto written = write_file(file, *bytes);
    if (!written) return written;
    fmt::print(out, "{}: {} bytes\n", file.string(), bytes->size());
    return base::Done{};
}

Answer<base::Done> carry_out(const ExportOrder& order, std::ostream& out) {
    const std::filesystem::path database = database_file_in(order.data);
    std::error_code error;
    if (!std::filesystem::exists(database, error)) return database.string() + ": is not there";
    const auto store = open_sqlite_reader(database);
    if (!store) return store.error().detail;
    const auto matches = (*store)->ended_matches();
    if (!matches) return matches.error().detail;
    return order.match ? write_match(**store, *matches, *order.match, order.file, out)
                       : list(**store, *matches, out);
}

}  // namespace

int export_match(const ExportOrder& order, std::ostream& out, std::ostream& err) {
    const auto done = carry_out(order, out);
    if (done) return 0;
    fmt::print(err, "{}\n", done.error());
    return 1;
}

}  // namespace billiards::server
