// Takes frames as the network would; gives what each session was told, decoded.
#pragma once

#include "common/protocol/codec.h"
#include "common/protocol/limits.h"
#include "common/protocol/messages.h"
#include "server/table/outbox.h"

#include <cstddef>
#include <gtest/gtest.h>
#include <map>
#include <set>
#include <span>
#include <variant>
#include <vector>

namespace billiards::server {

struct Told {
    protocol::ServerMessage message;
    protocol::SharedFrame frame;
    Delivery delivery = Delivery::Ordered;
};

class RecordingOutbox final : public Outbox {
  public:
    void deliver(SessionId to, const protocol::SharedFrame& frame, Delivery delivery) override {
        ASSERT_FALSE(closed_.contains(to)) << "told something after it was closed";
        ASSERT_GT(frame->size(), protocol::kFrameHeaderBytes);
        const auto body = std::span<const std::byte>(*frame).subspan(protocol::kFrameHeaderBytes);
        auto message = protocol::decode_server(body);
        ASSERT_TRUE(message.ok()) << message.error().detail;
        told_[to].push_back({std::move(message).value(), frame, delivery});
    }
    void close(SessionId session) override { closed_.insert(session); }

    bool is_closed(SessionId session) const { return closed_.contains(session); }
    const std::vector<Told>& told(SessionId session) { return told_[session]; }
    /// Calls visit(const std::vector<Told>&) once a session.
    template <class Visit>
    void for_each_session(Visit visit) const {
        for (const auto& [session, all_told] : told_) visit(all_told);
    }
    /// Forgets what was told so far.
    void clear() { told_.clear(); }

    template <class Message>
    std::vector<Message> all(SessionId session) {
        std::vector<Message> found;
        for (const Told& told : told_[session]) {
            if (const auto* message = std::get_if<Message>(&told.message)) {
                found.push_back(*message);
            }
        }
        return found;
    }
    template <class Message>
    std::vector<protocol::SharedFrame> frames(SessionId session) {
        std::vector<protocol::SharedFrame> found;
        for (const Told& told : told_[session]) {
            if (std::holds_alternative<Message>(told.message)) found.push_back(told.frame);
        }
        return found;
    }

  private:
    std::map<SessionId, std::vector<Told>> told_;
    std::set<SessionId> closed_;
};

}  // namespace billiards::server
