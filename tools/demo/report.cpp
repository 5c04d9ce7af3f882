// Takes events; writes them, each line at once.
#include "tools/demo/report.h"

#include "client/app/narrate.h"
#include "common/base/hex.h"
#include "tools/player/match_digest.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <ostream>

namespace billiards::tools {

namespace {

using nlohmann::ordered_json;

/// Names and details come from elsewhere: bytes that are no UTF-8 are replaced, never thrown at.
std::string line_of(const ordered_json& json) {
    return json.dump(-1, ' ', false, ordered_json::error_handler_t::replace);
}

void write(std::ostream& out, bool as_json, const ordered_json& json) {
    if (as_json) {
        out << line_of(json) << std::endl;
    } else if (json.contains("text")) {
        out << json["text"].get<std::string>() << std::endl;
    }
}

}  // namespace

PlayerEvents Report::events() {
    using Table = client::TableView;
    namespace server = protocol::server;
    return {.welcome = nullptr,
            .seated = [this](const Table& table) { seated(table); },
            .shot = [this](const Table& before, const server::ShotPlayed& m) { shot(before, m); },
            .moved = [this](const Table& before, const server::MatchMoved& m) { moved(before, m); },
            .over = [this](const Table& before, const server::MatchOver& m) { over(before, m); },
            .refused = [this](const server::Refused& m) { refused(m); }};
}

void Report::seated(const client::TableView& table) {
    ordered_json seats = ordered_json::array();
    for (const model::Seat seat : table.my_seats) seats.push_back(static_cast<int>(seat));
    const std::string doing = table.my_seats.empty() ? "watching" : "seated";
    write(out_, json_,
          {{"event", "seated"},
           {"text",
            fmt::format("{} at table {}, \"{}\"", doing, table.row.table.value, table.row.name)},
           {"table", table.row.table.value},
           {"seats", seats},
           {"shots", table.match ? table.match->shots_played : 0}});
}

void Report::shot(const client::TableView& before, const protocol::server::ShotPlayed& shot) {
    write(out_, json_,
          {{"event", "shot"},
           {"text", client::narrate(before, shot)},
           {"sequence", shot.sequence},
           {"shot", shot.after.shots_played},
           {"shot_id", base::to_hex(shot.shot_id)},
           {"seat", static_cast<int>(shot.seat)},
           {"record_hash", base::to_hex(shot.record.hash)},
           {"digest", base::to_hex(digest_of(shot))}});
}

void Report::moved(const client::TableView& before, const protocol::server::MatchMoved& moved) {
    write(out_, json_,
          {{"event", "moved"},
           {"text", client::narrate(before, moved)},
           {"sequence", moved.sequence}});
}

void Report::over(const client::TableView& before, const protocol::server::MatchOver& over) {
    const model::Seat winner = over.winner.value_or(model::Seat::First);
    write(out_, json_,
          {{"event", "over"},
           {"text", client::narrate(before, over)},
           {"winner", over.winner ? client::short_name(before, winner) : ""},
           {"winner_racks", over.racks_won[winner]},
           {"loser_racks", over.racks_won[model::opponent_of(winner)]},
           {"shots", over.shots},
           {"conceded", over.ending == protocol::server::Ending::Conceded}});
}

void Report::refused(const protocol::server::Refused& refused) {
    write(out_, json_,
          {{"event", "refused"},
           {"text", "refused: " + refused.detail},
           {"code", static_cast<int>(refused.code)}});
}

void Report::link_lost(const client::LinkLost& lost) {
    const std::string next = lost.retry_after ? "; trying again" : "";
    write(out_, json_, {{"event", "link-lost"}, {"text", lost.lost.reason + next}});
}

void Report::result(const PlayedOut& played) {
    ordered_json json{{"event", "result"},
                      {"name", played.name},
                      {"digest", base::to_hex(played.digest.value())},
                      {"shots", played.digest.shots()},
                      {"missed", played.digest.missed()}};
    if (!played.failure.empty()) json["failure"] = played.failure;
    json["text"] = played.failure.empty()
                       ? fmt::format("{} saw {} shots, and missed {}", played.name,
                                     played.digest.shots(), played.digest.missed())
                       : "could not go on: " + played.failure;
    write(out_, json_, json);
}

}  // namespace billiards::tools
