// Takes options; runs the event loop that all clients share, and looks after them.
#include "tests/soak/hall.h"

#include "client/net/clock.h"

#include <algorithm>
#include <asio/ip/address_v4.hpp>
#include <fmt/format.h>

namespace billiards::soak {
namespace {

constexpr std::chrono::milliseconds kTurn{5};  ///< Of the event loop, between two looks at it all.
constexpr std::uint64_t kPartiesOfASeed = 1'000'000;

std::size_t shots_told(const std::array<Account, kClients>& accounts) {
    std::map<int, const Shot*> told;
    for (const Account& account : accounts) {
        for (const auto& [number, shot] : account.shots) told.emplace(number, &shot);
    }
    return told.size();
}

}  // namespace

Hall::Hall(const HallOptions& options)
    : options_(options),
      started_(client::local_now()),
      random_(options.seed),
      proxy_({asio::ip::address_v4::loopback(), host_.port()}, *support::chaos_preset("worst"),
             options.seed) {}

client::ServerAddress Hall::address() {
    const bool is_bad = random_.uniform(0, 1) < options_.bad_share;
    return {.host = "127.0.0.1", .port = is_bad ? proxy_.port() : host_.port()};
}

void Hall::open_party() {
    PartyOptions party;
    party.seed = options_.seed * kPartiesOfASeed + ++parties_opened_;
    for (auto& address : party.addresses) address = this->address();
    party.max_think = options_.max_think;
    party.shot_sent = [this, addresses = party.addresses](std::size_t client) {
        if (shot_sent && addresses.at(client).port == host_.port()) shot_sent();
    };
    parties_.push_back(std::make_unique<Party>(io_, std::move(party), recorder_));
}

void Hall::tend() {
    for (const auto& party : parties_) {
        party->tend();
        if (const auto why = party->failure()) {
            throw BrokenPromise(fmt::format("{} ({})", *why, party->standing()));
        }
    }
}

bool Hall::play_until(const std::function<bool()>& is_enough, base::Duration limit) {
    const base::Instant deadline = client::local_now() + limit;
    while (true) {
        if (is_enough()) return true;
        const base::Instant now = client::local_now();
        if (now >= deadline) return false;
        if (now >= started_ + options_.limit) {
            std::string who = "the time is over";
            for (const auto& party : parties_) who += "\n  " + party->standing();
            throw BrokenPromise(who);
        }
        tend();
        io_.restart();
        io_.run_for(kTurn);
    }
}

void Hall::play_for(base::Duration duration) {
    play_until([] { return false; }, duration);
}

std::size_t Hall::retire() {
    std::size_t retired = 0;
    for (auto& party : parties_) {
        if (!party->is_over()) continue;
        finished_.push_back({.table = party->table()->value,
                             .accounts = party->accounts(),
                             .links_lost = party->links_lost()});
        tellings_of_finished_ += party->tellings();
        party.reset();
        ++retired;
    }
    std::erase(parties_, nullptr);
    return retired;
}

std::size_t Hall::tellings() const {
    std::size_t tellings = tellings_of_finished_;
    for (const auto& party : parties_) tellings += party->tellings();
    return tellings;
}

bool Hall::all_here() const {
    return std::all_of(parties_.begin(), parties_.end(),
                       [](const auto& party) { return party->is_here(); });
}

bool Hall::all_over() const {
    return std::all_of(parties_.begin(), parties_.end(),
                       [](const auto& party) { return party->is_over(); });
}

void Hall::check_table(const std::map<std::uint32_t, Journal>& journals, std::uint32_t table,
                       const std::array<Account, kClients>& accounts, bool complete) const {
    const auto found = journals.find(table);
    const Journal nothing;
    const Journal& journal = found == journals.end() ? nothing : found->second;
    if (const auto what = broken_promise(journal, accounts, complete)) {
        throw BrokenPromise(fmt::format("table {}, match {}: {}", table, journal.match, *what));
    }
}

void Hall::check(bool is_the_end) {
    const auto journals = read_journals(host_.data());
    if (!journals) throw BrokenPromise(journals.error());
    shots_journalled_ = 0;
    for (const auto& [table, journal] : *journals) shots_journalled_ += journal.shots.size();
    for (const auto& party : parties_) {
        if (!party->table()) continue;
        check_table(*journals, party->table()->value, party->accounts(), false);
    }
    for (const Finished& party : finished_) {
        check_table(*journals, party.table, party.accounts, is_the_end);
    }
}

Hall::Figures Hall::figures() const {
    Figures figures{.shots_told = 0,
                    .shots_journalled = shots_journalled_,
                    .links_lost = 0,
                    .resumed_by_ring = recorder_.resumed_by_ring(),
                    .resumed_by_snapshot = recorder_.resumed_by_snapshot(),
                    .network = proxy_.counts(),
                    .seconds = base::seconds(client::local_now() - started_)};
    for (const auto& party : parties_) {
        figures.shots_told += shots_told(party->accounts());
        figures.links_lost += party->links_lost();
    }
    for (const Finished& party : finished_) {
        figures.shots_told += shots_told(party.accounts);
        figures.links_lost += party.links_lost;
    }
    return figures;
}

}  // namespace billiards::soak
