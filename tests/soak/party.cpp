// Takes turns of an event loop; keeps three clients at their table.
#include "tests/soak/party.h"

#include "tools/player/simple_shot.h"

#include <algorithm>
#include <fmt/format.h>
#include <utility>

namespace billiards::soak {
namespace {

constexpr std::array<const char*, kClients> kNames{"Ada", "Grace", "Bob"};
constexpr std::size_t kSpectator = 1;

}  // namespace

Party::Party(asio::io_context& io, PartyOptions options, tools::Recorder& recorder)
    : io_(io), options_(std::move(options)), recorder_(recorder) {}

void Party::tend() {
    for (std::size_t client = 0; client < kClients; ++client) {
        const Guest& guest = guests_[client];
        const bool never_came =
            guest.session && !guest.session->is_in_place() && !guest.session->failure().empty();
        if (!guest.session || never_came) let_in(client);
        if (!guests_[client].session->is_in_place()) return;
    }
}

void Party::let_in(std::size_t client) {
    Guest& guest = guests_[client];
    tools::LoadSessionOptions session;
    session.address = options_.addresses.at(client);
    session.name = kNames.at(client);
    session.player = player(client);
    session.seed = session.player->seed;
    session.events = events(guest);
    if (options_.shot_sent) {
        session.shot_sent = [this, client] { options_.shot_sent(client); };
    }
    guest.session = std::make_unique<tools::LoadSession>(
        io_, std::move(session), recorder_, [this](protocol::TableId table) { table_ = table; });
}

tools::PlayerOptions Party::player(std::size_t client) const {
    tools::PlayerOptions player;
    player.role = client == kSpectator ? protocol::Role::Spectator : protocol::Role::Player;
    player.table = table_;
    player.settings.race_to = options_.race_to;
    player.seed = options_.seed * kClients + client;
    player.max_think = options_.max_think;
    player.choose = tools::simple_shot;
    return player;
}

tools::PlayerEvents Party::events(Guest& guest) const {
    using Table = client::TableView;
    namespace server = protocol::server;
    tools::PlayerEvents events;
    events.shot = [&guest](const Table&, const server::ShotPlayed& shot) {
        guest.shots.emplace(
            shot.after.shots_played,
            Shot{.shot_id = shot.shot_id, .record_hash = shot.record.hash, .after = shot.after});
    };
    events.over = [&guest](const Table&, const server::MatchOver& over) { guest.over = over; };
    return events;
}

bool Party::is_here() const {
    return std::all_of(guests_.begin(), guests_.end(), [](const Guest& guest) {
        return guest.session && (guest.session->is_here() || guest.session->is_finished());
    });
}

bool Party::is_over() const {
    return std::all_of(guests_.begin(), guests_.end(), [](const Guest& guest) {
        return guest.session && guest.session->is_in_place() && guest.session->is_finished();
    });
}

std::optional<std::string> Party::failure() const {
    for (std::size_t client = 0; client < kClients; ++client) {
        const auto& session = guests_[client].session;
        // Once the match is over nobody needs a link.
        if (!session || !session->is_in_place() || guests_[client].over) continue;
        if (!session->failure().empty()) {
            return fmt::format("{}: {}", kNames.at(client), session->failure());
        }
    }
    return std::nullopt;
}

std::array<Account, kClients> Party::accounts() const {
    std::array<Account, kClients> accounts;
    for (std::size_t client = 0; client < kClients; ++client) {
        const Guest& guest = guests_[client];
        accounts[client].shots = guest.shots;
        accounts[client].over = guest.over;
        if (!guest.session) continue;
        const client::ClientState& state = guest.session->player().state();
        const tools::MatchDigest& digest = guest.session->player().digest();
        accounts[client].known = digest.shots() + digest.missed();
        if (state.table && state.table->match) {
            accounts[client].known =
                std::max(accounts[client].known, state.table->match->shots_played);
        }
    }
    return accounts;
}

std::size_t Party::tellings() const {
    std::size_t tellings = 0;
    for (const Guest& guest : guests_) tellings += guest.shots.size();
    return tellings;
}

int Party::links_lost() const {
    int lost = 0;
    for (const Guest& guest : guests_) lost += guest.session ? guest.session->links_lost() : 0;
    return lost;
}

std::string Party::standing() const {
    std::string text = fmt::format("table {}:", table_ ? table_->value : 0);
    for (std::size_t client = 0; client < kClients; ++client) {
        const auto& session = guests_[client].session;
        if (!session) continue;
        const auto& table = session->player().state().table;
        text += fmt::format(" {} {}{}, turn {}, {} shots, {};", kNames.at(client),
                            session->is_here() ? "here" : "away",
                            session->is_finished() ? ", done" : "",
                            table && table->match ? table->match->turn.value : 0,
                            table && table->match ? table->match->shots_played : 0,
                            session->failure().empty() ? "can go on" : session->failure());
    }
    return text;
}

}  // namespace billiards::soak
