// Takes rows of a list and points of a rack; gives whether their words say what they are.
#include "client/play/information.h"
#include "client/play/player_name.h"

#include <gtest/gtest.h>
#include <string>

namespace billiards::client {
namespace {

using model::Seat;

protocol::server::TableRow row(const std::string& first, const std::string& second) {
    protocol::server::TableRow row;
    row.seats[Seat::First] = {.taken = !first.empty(), .connected = true, .name = first};
    row.seats[Seat::Second] = {.taken = !second.empty(), .connected = true, .name = second};
    row.settings.race_to = 5;
    return row;
}

TEST(TableText, ARowNamesItsGamePlayersScoreAndSpectators) {
    auto shown = row("Ada#1", "Grace#2");
    shown.settings.game = rules::Game::NineBall;
    shown.racks_won[Seat::First] = 2;
    shown.playing = true;
    shown.spectators = 3;
    EXPECT_EQ(text_of(shown), (RowText{.game = "9-ball",
                                       .players = "Ada#1 2 - 0 Grace#2",
                                       .race = "race to 5",
                                       .state = "playing, 3 watching"}));
}

TEST(TableText, ATableWithAFreeSeatIsOpen) {
    EXPECT_EQ(text_of(row("Ada#1", "")).players, "Ada#1 0 - 0 free seat");
    EXPECT_EQ(text_of(row("Ada#1", "")).state, "open");
    EXPECT_TRUE(has_room(row("Ada#1", "")));
}

TEST(TableText, APlayerWithBothSeatsIsNamedOnce) {
    EXPECT_EQ(text_of(row("Ada#1", "Ada#1")).players, "Ada#1, both sides, 0 - 0");
    EXPECT_FALSE(has_room(row("Ada#1", "Ada#1")));
    EXPECT_EQ(text_of(row("Ada#1", "Ada#1")).state, "getting ready");
}

TEST(TableText, PracticeHasNeitherScoreNorRace) {
    auto shown = row("Ada#1", "Ada#1");
    shown.settings.game = rules::Game::Practice;
    EXPECT_EQ(text_of(shown).players, "Ada#1");
    EXPECT_EQ(text_of(shown).race, "");
}

TEST(TableText, TheScoreOfStraightPoolIsItsPoints) {
    TableView table;
    table.row = row("Ada#1", "Grace#2");
    EXPECT_EQ(score_of(table), "0 : 0");
    table.match.emplace();
    table.match->racks_won[Seat::Second] = 1;
    EXPECT_EQ(score_of(table), "0 : 1");
    table.match->settings.game = rules::Game::StraightPool;
    table.match->rack.scores[Seat::First] = 45;
    table.match->rack.scores[Seat::Second] = -1;
    EXPECT_EQ(score_of(table), "45 : -1 of 100");
}

TEST(PlayerName, IsOneWhereAServerTakesIt) {
    EXPECT_TRUE(is_player_name("Ada"));
    EXPECT_FALSE(is_player_name(" "));
    EXPECT_FALSE(is_player_name(std::string(25, 'x')));
    EXPECT_TRUE(is_player_name(std::string(24, 'x')));
}

TEST(ShotClock, WarnsInItsLastTenSeconds) {
    EXPECT_TRUE(is_low(10));
    EXPECT_FALSE(is_low(11));
}

}  // namespace
}  // namespace billiards::client
