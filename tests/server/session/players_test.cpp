// Holds the directory of players: which tokens and names find them, and when they stop to.
#include "server/session/players.h"

#include <gtest/gtest.h>

namespace billiards::server {
namespace {

TokenHash hash(std::uint8_t number) {
    TokenHash hash{};
    hash.back() = number;  // All lead with the same bytes: only the whole of it tells them apart.
    return hash;
}

StoredPlayer stored(std::uint64_t id, std::uint8_t token) {
    return {.player = {id}, .name = "Ada#0000", .token_hash = hash(token)};
}

class PlayersTest : public testing::Test {
  protected:
    PlayersTest() {
        players.add(stored(1, 10));
        players.add(stored(2, 20));
    }
    std::uint64_t found(std::uint8_t token) {
        const Player* player = players.find(hash(token));
        return player == nullptr ? 0 : player->stored.player.value;
    }
    Player& ada() { return *players.find(PlayerId{1}); }

    Players players;
};

TEST_F(PlayersTest, AreFoundByTheirOwnTokenOnly) {
    EXPECT_EQ(found(10), 1U);
    EXPECT_EQ(found(20), 2U);
    EXPECT_EQ(found(30), 0U);
}

TEST_F(PlayersTest, AreFoundByBothTokensUntilTheNewOneIsConfirmed) {
    players.rotate(ada(), hash(10), hash(11));
    EXPECT_EQ(found(10), 1U);
    EXPECT_EQ(found(11), 1U);
    EXPECT_TRUE(players.confirm(ada()));
    EXPECT_EQ(found(10), 0U);
    EXPECT_EQ(found(11), 1U);
    EXPECT_FALSE(players.confirm(ada()));
}

TEST_F(PlayersTest, KeepTheTokenThatWasUsedWhenTheNewOneNeverArrived) {
    players.rotate(ada(), hash(10), hash(11));
    players.rotate(ada(), hash(10), hash(12));
    EXPECT_EQ(found(10), 1U);
    EXPECT_EQ(found(11), 0U);
    EXPECT_EQ(found(12), 1U);
}

TEST_F(PlayersTest, AreFoundByThePreviousTokenThatWasStored) {
    StoredPlayer linus = stored(3, 31);
    linus.previous_token_hash = hash(30);
    players.add(linus);
    EXPECT_EQ(found(30), 3U);
    EXPECT_EQ(found(31), 3U);
}

TEST_F(PlayersTest, AreForgottenWithAllTheirTokens) {
    players.rotate(ada(), hash(10), hash(11));
    players.remove({1});
    EXPECT_EQ(found(10), 0U);
    EXPECT_EQ(found(11), 0U);
    EXPECT_EQ(found(20), 2U);
    EXPECT_EQ(players.size(), 1U);
}

TEST_F(PlayersTest, AreFoundByTheWholeNameThatIsShown) {
    StoredPlayer grace = stored(3, 30);
    grace.name = "Grace#00ff";
    players.add(grace);
    ASSERT_NE(players.find_named("Grace#00ff"), nullptr);
    EXPECT_EQ(players.find_named("Grace#00ff")->stored.player, PlayerId{3});
    EXPECT_EQ(players.find_named("Grace"), nullptr);
    players.remove({3});
    EXPECT_EQ(players.find_named("Grace#00ff"), nullptr);
}

TEST_F(PlayersTest, OfOneNameFromAnOldDatabaseAreForgottenOneByOne) {
    ASSERT_NE(players.find_named("Ada#0000"), nullptr);
    players.remove({1});
    ASSERT_NE(players.find_named("Ada#0000"), nullptr);
    EXPECT_EQ(players.find_named("Ada#0000")->stored.player, PlayerId{2});
    players.remove({2});
    EXPECT_EQ(players.find_named("Ada#0000"), nullptr);
}

TEST_F(PlayersTest, GetTheFirstFreeDiscriminatorFromTheOneThatWasDrawn) {
    EXPECT_EQ(players.free_name("Grace", 0x3f21), "Grace#3f21");
    EXPECT_EQ(players.free_name("Ada", 0), "Ada#0001");
    EXPECT_EQ(players.free_name("Ada", 0xffff), "Ada#ffff");
}

TEST_F(PlayersTest, GetNoNameOnceAllItsDiscriminatorsAreTaken) {
    for (std::uint64_t id = 3; id < 3 + 0xfffe; ++id) {
        StoredPlayer another = stored(id, 0);
        another.token_hash[0] = static_cast<std::uint8_t>(id);
        another.token_hash[1] = static_cast<std::uint8_t>(id >> 8U);
        another.name = *players.free_name("Ada", static_cast<std::uint16_t>(id - 2));
        players.add(another);
    }
    EXPECT_EQ(players.free_name("Ada", 0xfffe), "Ada#ffff");
    StoredPlayer last = stored(100'000, 1);
    last.name = "Ada#ffff";
    players.add(last);
    EXPECT_EQ(players.free_name("Ada", 0x1234), std::nullopt);
    EXPECT_EQ(players.free_name("Grace", 0x1234), "Grace#1234");
}

}  // namespace
}  // namespace billiards::server
