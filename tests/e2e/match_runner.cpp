// Takes ports and seeds; runs billiards-server and billiards-demo, and reads their lines of JSON.
#include "tests/e2e/match_runner.h"

#include "common/base/hex.h"
#include "common/protocol/codec_journal.h"
#include "server/store/sqlite_store.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <stdexcept>

namespace billiards::e2e {

namespace {

using nlohmann::json;
using support::Process;

std::string address(std::uint16_t port) {
    return "127.0.0.1:" + std::to_string(port);
}

struct Seated {
    Process process;
    std::string table;
};

/// Starts a client and waits until it is at its table. One whose link is lost before its first
/// welcome gives up, as it should; a person would try again.
Seated start_seated(const std::vector<std::string>& command) {
    constexpr int kTries = 10;
    for (int i = 0; i < kTries; ++i) {
        Process process(command);
        const auto line = process.read_line_with("\"event\":\"seated\"");
        if (!line) continue;
        const int table = json::parse(*line)["table"];
        return {std::move(process), std::to_string(table)};
    }
    throw std::runtime_error("no seat for " + command[1]);
}

std::vector<std::string> player_command(std::uint16_t port, const std::string& name, int seed) {
    return {BILLIARDS_DEMO_PROGRAM, "play",   "--json", "--server",
            address(port),          "--name", name,     "--seed",
            std::to_string(seed)};
}

}  // namespace

std::vector<JournalledShot> journalled_shots(const Host& host) {
    const auto store = server::open_sqlite_store(host.database());
    if (!store) throw std::runtime_error(store.error().detail);
    const auto entries = whole_journal(**store, server::MatchId{1});
    if (!entries) throw std::runtime_error(entries.error().detail);
    std::vector<JournalledShot> shots;
    for (const server::StoredEntry& stored : *entries) {
        const auto entry = protocol::decode_entry(stored.entry);
        if (!entry) throw std::runtime_error(entry.error().detail);
        if (!entry->record) continue;
        shots.push_back({base::to_hex(entry->shot_id), base::to_hex(entry->record->hash)});
    }
    return shots;
}

Match::Match(std::uint16_t port, int race_to, int seed) {
    auto first = player_command(port, "Ada", 2 * seed);
    first.insert(first.end(), {"--race", std::to_string(race_to), "--shot-clock", "0"});
    Seated opened = start_seated(first);
    clients_.push_back(std::move(opened.process));

    const std::vector<std::string> spectator{BILLIARDS_DEMO_PROGRAM,
                                             "watch",
                                             "--json",
                                             "--server",
                                             address(port),
                                             "--name",
                                             "Grace",
                                             "--table",
                                             opened.table};
    clients_.push_back(start_seated(spectator).process);

    auto second = player_command(port, "Bob", 2 * seed + 1);
    second.insert(second.end(), {"--table", opened.table});
    clients_.push_back(start_seated(second).process);
}

void Match::note(Account& account, const std::string& line) {
    const json event = json::parse(line, nullptr, false);
    if (event.is_discarded()) return;
    const std::string kind = event.value("event", "");
    if (kind == "shot") {
        account.shots[event["shot"]] = event["digest"];
        account.told[event["shot"]] = {event["shot_id"], event["record_hash"]};
    }
    if (kind == "link-lost") ++account.links_lost;
    if (kind == "over") {
        account.result = event["winner"].get<std::string>() + " " +
                         std::to_string(event["winner_racks"].get<int>()) + "-" +
                         std::to_string(event["loser_racks"].get<int>()) + ", " +
                         std::to_string(event["shots"].get<int>()) + " shots";
    }
    if (kind == "result") {
        account.digest = event["digest"];
        account.missed = event["missed"];
        account.failure = event.value("failure", "");
    }
}

bool Match::watch_shots(int count) {
    while (count > 0) {
        const auto line = clients_[1].read_line();
        if (!line) return false;
        note(watched_, *line);
        if (line->find("\"event\":\"shot\"") != std::string::npos) --count;
        if (line->find("\"event\":\"over\"") != std::string::npos) return false;
    }
    return true;
}

std::vector<Account> Match::finish() {
    std::vector<Account> accounts{{}, watched_, {}};
    for (std::size_t i = 0; i < clients_.size(); ++i) {
        for (const std::string& line : clients_[i].read_lines()) note(accounts[i], line);
        EXPECT_EQ(clients_[i].exit_code(), 0) << "client " << i << ": " << accounts[i].failure;
    }
    return accounts;
}

void expect_one_match(const std::vector<Account>& accounts) {
    std::map<int, std::string> shots;
    for (const Account& account : accounts) {
        EXPECT_EQ(account.failure, "");
        EXPECT_EQ(account.result, accounts.front().result);
        for (const auto& [number, digest] : account.shots) {
            EXPECT_EQ(shots.try_emplace(number, digest).first->second, digest) << "shot " << number;
        }
    }
    ASSERT_FALSE(shots.empty());
    for (const Account& account : accounts) {
        EXPECT_EQ(account.shots.size() + static_cast<std::size_t>(account.missed), shots.size());
    }
    EXPECT_EQ(shots.begin()->first, 1);
    EXPECT_EQ(shots.rbegin()->first, static_cast<int>(shots.size()));
    EXPECT_NE(accounts.front().result.find(std::to_string(shots.size()) + " shots"),
              std::string::npos)
        << accounts.front().result;
}

}  // namespace billiards::e2e
