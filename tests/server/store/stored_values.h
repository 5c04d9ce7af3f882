// Gives values for a store to keep, each as plain as can be.
#pragma once

#include "server/store/match_store.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

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

inline FinishMatch finished(std::uint64_t id,
                            std::optional<model::Seat> winner = model::Seat::First) {
    return {.match = {id}, .result = {.winner = winner, .racks_won = {{{3, 1}}}, .shots = 40}};
}

inline StoredTable some_table(std::uint32_t id) {
    StoredTable table;
    table.table = {id};
    table.name = "Friday";
    table.settings = bytes_of("race to 5");
    table.owner = {1};
    return table;
}

}  // namespace billiards::server
