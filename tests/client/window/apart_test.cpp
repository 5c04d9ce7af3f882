// Plays in two windows at one server, where things go wrong or are agreed upon; gives whether both
// go on without help from outside.
#include "tests/client/window/two_windows.h"

#include <chrono>
#include <csignal>
#include <optional>
#include <string>
#include <vector>

namespace billiards::client {
namespace {

using WindowsApart = TwoWindows;

TEST_F(WindowsApart, AQuickMatchBringsTwoToOneTable) {
    for (auto* window : {&ada_, &grace_}) {
        open(*window, window == &ada_ ? "Ada" : "Grace");
        (*window)->click("Back");
        (*window)->click("Quick match");
        (*window)->click("Find a match");
        (*window)->until("comes to a table", is_at_table);
    }
    EXPECT_EQ(ada_->seen().at("table").at("id"), grace_->seen().at("table").at("id"));
    start("Start");
}

TEST_F(WindowsApart, APrivateTableIsFoundByItsInviteAlone) {
    open(ada_, "Ada");
    ada_->click("Open a new table");
    ada_->click("Private");
    ada_->until_there("Passcode");
    ada_->click("Open the table");
    ada_->until("sits at the private table", is_at_table);
    ada_->click("Copy an invite");
    ada_->until("has an invite", [](const Json& shown) { return shown.at("copied") != ""; });
    open(grace_, "Grace");
    grace_->until_there("A private table");
    EXPECT_FALSE(grace_->seen().at("controls").contains(row_of_table()));
    open(grace_, "Grace", ada_->seen().at("copied"));
    grace_->until("comes by the invite", is_at_table);
    start("Start");
}

TEST_F(WindowsApart, TheListOfTablesFollowsItsChanges) {
    open(grace_, "Grace");
    grace_->until_there("A private table");
    open(ada_, "Ada");
    open_table(*ada_);
    grace_->until_there(row_of_table());
}

TEST_F(WindowsApart, TheMatchOfAnOpponentWhoHasGoneIsClaimed) {
    start_match();
    grace_->program().signal(SIGKILL);
    ada_->click("Claim the match");
    ada_->until("has won",
                [](const Json& shown) { return shown.at("table").at("match").at("stage") == 2; });
}

TEST_F(WindowsApart, AnExtensionAddsItsTime) {
    start_match();
    TestWindow& player = breaker();
    const auto before_us = player.seen().at("table").at("deadline_us").get<std::int64_t>();
    player.click("Extension");
    player.until("has its extension",
                 [](const Json& shown) { return !shown.at("controls").contains("Extension"); });
    EXPECT_EQ(player.seen().at("table").at("deadline_us").get<std::int64_t>() - before_us,
              30'000'000);
}

TEST_F(WindowsApart, ADrawIsOfferedAcceptedAndFollowedByARematch) {
    start_match();
    ada_->tap("Escape");
    ada_->click("Offer a draw");
    grace_->until_there("Accept");
    EXPECT_EQ(grace_->seen().at("notes").back(), "Ada offers a draw.");
    grace_->click("Accept");
    for (auto* window : {&ada_, &grace_}) (*window)->until_there("Rematch");
    ada_->click("Rematch");
    grace_->until("hears of it", [](const Json& shown) {
        return !shown.at("notes").empty() && shown.at("notes").back() == "Ada wants a rematch.";
    });
    grace_->click("Rematch");
    for (auto* window : {&ada_, &grace_}) (*window)->until("sees it begin", is_playing);
}

TEST_F(WindowsApart, WhatIsSaidIsReadUntilItsSpeakerIsMuted) {
    start_match();
    ada_->click("Chat");
    ada_->until("lets one type", [](const Json& shown) { return shown.at("typing") == true; });
    ada_->fill("Say", "good luck");
    ada_->tap("Return");
    grace_->until("reads it", [](const Json& shown) {
        return shown.at("chat").size() == 1 && shown.at("chat").at(0).at(1) == "good luck";
    });
    grace_->click("Mute " + grace_->seen().at("chat").at(0).at(0).get<std::string>());
    grace_->until("has muted her", [](const Json& shown) { return shown.at("chat").empty(); });
}

TEST_F(WindowsApart, AWatcherGoesBackToTheStartAndToTheLiveMatchAgain) {
    start_match();
    std::optional<TestWindow> mary;
    mary.emplace(std::vector<std::string>{"--server", address_, "--name", "Mary", "--watch"});
    mary->click(row_of_table());
    mary->until("watches", is_playing);
    mary->click("From the start");
    mary->until("is at the start",
                [](const Json& shown) { return shown.at("rewatching").is_array(); });
    mary->click("Live");
    mary->until("is live again",
                [](const Json& shown) { return shown.at("rewatching").is_null(); });
}

}  // namespace
}  // namespace billiards::client
