// Takes what a player asks about matches that were played; asks the archive, and hands its answers
// on.
#include "server/lobby/world.h"

#include <optional>
#include <utility>

namespace billiards::server {

namespace client = protocol::client;
using protocol::RefusedCode;

void Lobby::World::on(const Heard& heard, const client::AskHistory& message) {
    inquire(heard, AskHistory{.asker = *heard.session.player,
                              .player = message.player,
                              .before = message.before});
}

void Lobby::World::on(const Heard& heard, const client::AskRecord& message) {
    const std::string& own = player_at(heard).stored.name;
    inquire(heard, AskRecord{.asker = *heard.session.player,
                             .player = message.player.empty() ? own : message.player});
}

/// The match at one's table is shown as far as one has seen it, ended or not.
void Lobby::World::on(const Heard& heard, const client::AskReplay& message) {
    const Table* table = heard.session.table ? table_of(*heard.session.table) : nullptr;
    const auto here = table != nullptr ? table->match_shown_to(heard.session.id) : std::nullopt;
    AskReplay question{
        .asker = *heard.session.player, .match = {message.match}, .first = message.first};
    if (message.match == 0) {
        if (!here) {
            refuse(around, heard.asker(), RefusedCode::UnknownMatch,
                   "no match has been played at your table");
            return;
        }
        question.match = here->match;
    }
    if (here && here->match == question.match) question.steps = here->steps;
    inquire(heard, std::move(question));
}

void Lobby::World::inquire(const Heard& heard, Question question) {
    if (!may_ask_lobby(heard)) return;
    if (heard.session.questions >= around.limits.questions_waiting) {
        refuse(around, heard.asker(), RefusedCode::Busy, "your last question is not answered yet");
        return;
    }
    ++heard.session.questions;
    archive.ask(std::move(question), [this, asker = heard.asker()](const ArchiveAnswer& answer) {
        hand_on(asker, answer);
    });
}

/// The session may be gone by now.
void Lobby::World::hand_on(const Asker& asker, const ArchiveAnswer& answer) {
    Session* session = session_of(asker.session);
    if (session == nullptr) return;
    --session->questions;
    if (answer) {
        around.outbox.deliver(asker.session, *answer, Delivery::Ordered);
    } else {
        refuse(around, asker, answer.error().code, answer.error().detail);
    }
}

}  // namespace billiards::server
