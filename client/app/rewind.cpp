// Takes chunks of a match; keeps their steps, and folds those that a moment needs.
#include "client/app/rewind.h"

#include "client/app/reduce.h"
#include "common/base/check.h"
#include "common/protocol/codec.h"

#include <type_traits>
#include <utility>
#include <variant>

namespace billiards::client {

namespace {

namespace server = protocol::server;

/// The step's own number, where the message is one that a match is told with.
std::optional<std::uint64_t> step_number(const protocol::ServerMessage& message) {
    return std::visit(
        []<class Message>(const Message& body) -> std::optional<std::uint64_t> {
            if constexpr (std::is_same_v<Message, server::MatchStarted> ||
                          std::is_same_v<Message, server::CueBallPlaced> ||
                          std::is_same_v<Message, server::ShotPlayed> ||
                          std::is_same_v<Message, server::MatchMoved>) {
                return body.sequence;
            }
            return std::nullopt;
        },
        message);
}

ClientState without_match(const ClientState& live) {
    ClientState state;
    state.link = live.link;
    state.name = live.name;
    if (!live.table) {
        state.table.emplace();
        return state;
    }
    state.table.emplace().row = live.table->row;
    state.table->row.racks_won = {};
    state.table->my_seats = live.table->my_seats;
    return state;
}

}  // namespace

Rewind::Rewind(const ClientState& live, std::uint64_t match)
    : before_(without_match(live)), asked_match_(match) {}

std::optional<protocol::client::AskReplay> Rewind::question() const {
    if (is_complete_ || has_failed_) return std::nullopt;
    return protocol::client::AskReplay{.match = asked_match_, .first = steps_.size()};
}

base::Result<base::Done, std::string> Rewind::take(const server::ReplayChunk& chunk) {
    auto steps = steps_of(chunk);
    if (!steps) {
        has_failed_ = true;
        return std::move(steps).error();
    }
    match_ = chunk.match;
    for (Step& step : *steps) {
        bytes_ += step.message.size();
        steps_.push_back(std::move(step));
    }
    is_complete_ = steps_.size() >= chunk.total;
    return base::Done{};
}

base::Result<std::vector<Rewind::Step>, std::string> Rewind::steps_of(
    const server::ReplayChunk& chunk) const {
    if (match_ && *match_ != chunk.match) return std::string("another match has begun");
    if (chunk.first != steps_.size()) return std::string("the server told other steps than asked");
    if (chunk.messages.empty() && chunk.total > steps_.size()) {
        return std::string("the server told no steps");
    }
    std::vector<Step> steps;
    std::size_t bytes = bytes_;
    std::size_t told_by = steps_.empty() ? 0 : steps_.back().told_by;
    for (const std::vector<std::byte>& encoded : chunk.messages) {
        const std::size_t number = steps_.size() + steps.size();
        bytes += encoded.size();
        if (number >= kMaxRewoundSteps || bytes > kMaxRewoundBytes) {
            return std::string("the match is too long to be rewound");
        }
        const auto message = protocol::decode_server(encoded);
        const bool begins = message && std::holds_alternative<server::MatchStarted>(*message);
        if (!message || step_number(*message) != number || begins != (number == 0)) {
            return std::string("the server told what is no step of a match");
        }
        const bool is_shot = std::holds_alternative<server::ShotPlayed>(*message);
        if (is_shot) told_by = number;
        steps.push_back({.message = encoded, .told_by = told_by, .is_shot = is_shot});
    }
    return steps;
}

protocol::ServerMessage Rewind::message(std::size_t step) const {
    CHECK(step < steps_.size());
    return protocol::decode_server(steps_[step].message).value();  // It was tried when it came.
}

/// From the last shot on, with the start of the match before it.
ClientState Rewind::at(std::size_t step) const {
    CHECK(step < steps_.size());
    ClientState state = reduce(before_, message(0), base::Instant());
    for (std::size_t next = steps_[step].told_by; next <= step; ++next) {
        if (next > 0) state = reduce(std::move(state), message(next), base::Instant());
    }
    return state;
}

std::size_t Rewind::next_shot(std::size_t step) const {
    CHECK(step < steps_.size());
    while (++step < steps_.size()) {
        if (steps_[step].is_shot) return step;
    }
    return steps_.size() - 1;
}

std::size_t Rewind::previous_shot(std::size_t step) const {
    CHECK(step < steps_.size());
    while (step > 0) {
        if (steps_[--step].is_shot) return step;
    }
    return 0;
}

}  // namespace billiards::client
