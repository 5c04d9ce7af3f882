// Gives tests a network that runs on a thread of its own, and clients that are past their greeting.
#pragma once

#include "server/net/network.h"
#include "tests/server/net/raw_client.h"
#include "tests/server/net/recorded_events.h"

#include <asio/post.hpp>
#include <chrono>
#include <functional>
#include <future>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <memory>
#include <optional>
#include <spdlog/sinks/ostream_sink.h>
#include <sstream>
#include <string>
#include <thread>
#include <utility>
#include <vector>

namespace billiards::server {

inline protocol::ClientMessage ping(std::uint32_t number) {
    return {number, protocol::client::Ping{.client_time_us = number}};
}

inline protocol::SharedFrame frame_of(std::size_t bytes) {
    return std::make_shared<const std::vector<std::byte>>(bytes, std::byte{0x5a});
}

/// A network with its thread, on a free port of this machine.
class Running {
  public:
    explicit Running(const NetLimits& limits = {}) : network_(context_, limits, events, log_) {
        port = network_.listen(*parse_endpoint("127.0.0.1:0")).port();
        network_.start();
        thread_ = std::thread([this] { context_.run(); });
    }
    ~Running() {
        context_.stop();
        thread_.join();
    }

    void carry_out(std::vector<Outgoing> batch) {
        asio::post(context_, [this, batch = std::move(batch)] { network_.carry_out(batch); });
    }
    NetStats stats() {
        return ask<NetStats>([this] { return network_.stats(); });
    }
    std::future<void> stop() {
        auto stopped = std::make_shared<std::promise<void>>();
        asio::post(context_,
                   [this, stopped] { network_.stop([stopped] { stopped->set_value(); }); });
        return stopped->get_future();
    }
    std::string log_text() {
        return ask<std::string>([this] { return log_out_.str(); });
    }

    RecordedEvents events;
    std::uint16_t port = 0;

  private:
    /// On the network's thread.
    template <class Answer>
    Answer ask(std::function<Answer()> question) {
        auto answer = std::make_shared<std::promise<Answer>>();
        asio::post(context_, [answer, question] { answer->set_value(question()); });
        return answer->get_future().get();
    }

    std::ostringstream log_out_;
    spdlog::logger log_{"test", std::make_shared<spdlog::sinks::ostream_sink_st>(log_out_)};
    asio::io_context context_{1};
    Network network_;
    std::thread thread_;
};

/// Timeouts that a test can wait for.
inline NetLimits impatient() {
    NetLimits limits;
    limits.greeting_timeout = std::chrono::milliseconds(60);
    limits.frame_timeout = std::chrono::milliseconds(60);
    limits.closing_timeout = std::chrono::milliseconds(60);
    limits.tick = std::chrono::milliseconds(10);
    return limits;
}

/// A client past its preamble and its first message, and the session that it is.
struct Greeted {
    explicit Greeted(Running& running, std::optional<int> receive_buffer_bytes = {})
        : client(running.port, receive_buffer_bytes) {
        const std::size_t before = running.events.count(RecordedEvent::Kind::Received);
        client.send_preamble();
        client.send(ping(0));
        EXPECT_TRUE(client.receive_preamble());
        const auto first = running.events.wait_for(RecordedEvent::Kind::Received, before + 1);
        EXPECT_TRUE(first);
        if (first) session = first->session;
        running.carry_out({{session, Outgoing::Kind::Handled, nullptr}});
    }

    RawClient client;
    SessionId session;
};

inline void expect_refused(RawClient& client, protocol::RefusedCode code,
                           const std::string& detail) {
    const auto refused = client.receive_next<protocol::server::Refused>();
    ASSERT_TRUE(refused);
    EXPECT_EQ(refused->code, code);
    EXPECT_THAT(refused->detail, testing::HasSubstr(detail));
    EXPECT_TRUE(client.is_closed_by_other_side());
}

}  // namespace billiards::server
