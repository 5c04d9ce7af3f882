// Gives a test two windows at one real server, in which two play.
#pragma once

#include "tests/client/window/test_window.h"
#include "tests/tools/test_server.h"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <optional>
#include <string>
#include <vector>

namespace billiards::client {

inline bool is_at_table(const Json& shown) {
    return !shown.at("table").is_null();
}

inline bool is_playing(const Json& shown) {
    return is_at_table(shown) && !shown.at("table").at("match").is_null() &&
           shown.at("table").at("match").at("stage") != 2;
}

class TwoWindows : public testing::Test {
  protected:
    /// Claims are not waited for.
    static server::LobbyLimits limits() {
        server::LobbyLimits limits;
        limits.absence_grace = base::Duration::zero();
        return limits;
    }

    void open(std::optional<TestWindow>& window, const std::string& name,
              const std::string& to = "") {
        window.emplace(
            std::vector<std::string>{"--server", to.empty() ? address_ : to, "--name", name});
    }

    /// Ada opens a table, and Grace sits down there.
    void sit_down_together() {
        open(ada_, "Ada");
        open_table(*ada_);
        open(grace_, "Grace");
        grace_->click(row_of_table());
        grace_->until("comes to the table", is_at_table);
    }
    /// And both are ready.
    void start_match() {
        sit_down_together();
        start("Start");
    }
    void start(const std::string& button) {
        for (auto* window : {&ada_, &grace_}) {
            (*window)->until("knows that both are there", [](const Json& shown) {
                return shown.at("information").back() != "Waiting for a second player.";
            });
        }
        for (auto* window : {&ada_, &grace_}) (*window)->click(button);
        for (auto* window : {&ada_, &grace_}) (*window)->until("sees it begin", is_playing);
    }

    int table() const { return ada_->seen().at("table").at("id").get<int>(); }
    /// In the list of tables.
    std::string row_of_table() const { return fmt::format("Table {}", table()); }

    TestWindow& breaker() {
        const Json& table = ada_->seen().at("table");
        const bool is_ada = table.at("seats").at(0) == table.at("match").at("to_act");
        TestWindow& player = is_ada ? *ada_ : *grace_;
        player.until("may break", may_shoot);
        return player;
    }

    tools::TestServer server_{{}, limits()};
    std::string address_ = to_text(server_.address());
    std::optional<TestWindow> ada_;
    std::optional<TestWindow> grace_;
};

}  // namespace billiards::client
