// Holds who may come to a table: owners, invites, passcodes, and those who were sent away.
#include "server/table/access.h"

#include <chrono>
#include <gtest/gtest.h>
#include <string>
#include <vector>

namespace billiards::server {
namespace {

using namespace std::chrono_literals;
using protocol::RefusedCode;
using protocol::Role;

constexpr PlayerId kOwner{1};
constexpr PlayerId kStranger{2};

class AccessTest : public testing::Test {
  protected:
    /// What was refused; none: welcome.
    std::optional<RefusedCode> at_the_door(Role role, const Shown& shown = {},
                                           PlayerId player = kStranger) {
        const auto admitted = access.admits(now, player, role, shown);
        return admitted ? std::nullopt : std::optional(admitted.error());
    }
    protocol::InviteSecret make_invite(bool is_for_playing) {
        return access.invite(now, is_for_playing, random)->secret;
    }
    Shown invited(bool is_for_playing) { return {.invite = make_invite(is_for_playing)}; }
    void lock(const std::optional<std::string>& passcode = {}) {
        ASSERT_TRUE(access.change(true, passcode, random).ok());
    }
    StoredTable stored() const {
        StoredTable table;
        access.store_into(table);
        return table;
    }

    LobbyLimits limits;
    base::Instant now{};
    std::uint8_t next_random = 0;
    RandomBytes random = [this](std::span<std::uint8_t> bytes) {
        for (std::uint8_t& byte : bytes) byte = ++next_random;
    };
    Access access{limits, {kOwner, "Ada#0001"}};
};

TEST_F(AccessTest, LetsEveryoneToAPublicTable) {
    for (const Role role : {Role::Player, Role::Spectator, Role::BothSeats}) {
        EXPECT_EQ(at_the_door(role), std::nullopt);
        EXPECT_EQ(at_the_door(role, {.invite = {}, .passcode = "anything"}), std::nullopt);
    }
}

TEST_F(AccessTest, TellsStrangersThatAPrivateTableIsNotThere) {
    lock();
    EXPECT_EQ(at_the_door(Role::Player), RefusedCode::UnknownTable);
    EXPECT_EQ(at_the_door(Role::Spectator), RefusedCode::UnknownTable);
}

TEST_F(AccessTest, LetsTheOwnerInWithoutASecret) {
    lock("cue");
    EXPECT_EQ(at_the_door(Role::Player, {}, kOwner), std::nullopt);
}

TEST_F(AccessTest, MakesATableWithAPasscodePrivateUntilBothAreTakenBack) {
    ASSERT_TRUE(access.change(false, "cue", random).ok());
    EXPECT_TRUE(access.is_private());
    EXPECT_TRUE(access.has_passcode());
    EXPECT_EQ(at_the_door(Role::Player), RefusedCode::WrongSecret);
    ASSERT_TRUE(access.change(false, std::nullopt, random).ok());
    EXPECT_TRUE(access.is_private());
    ASSERT_TRUE(access.change(false, "", random).ok());
    EXPECT_FALSE(access.is_private());
    EXPECT_EQ(at_the_door(Role::Player), std::nullopt);
}

TEST_F(AccessTest, OpensEveryPlaceToThePasscodeHoweverItIsComposed) {
    lock("caf\xc3\xa9");
    for (const Role role : {Role::Player, Role::Spectator, Role::BothSeats}) {
        EXPECT_EQ(at_the_door(role, {.invite = {}, .passcode = "caf\xc3\xa9"}), std::nullopt);
        EXPECT_EQ(at_the_door(role, {.invite = {}, .passcode = " cafe\xcc\x81 "}), std::nullopt);
    }
    EXPECT_EQ(at_the_door(Role::Player, {.invite = {}, .passcode = "cafe"}),
              RefusedCode::WrongSecret);
    EXPECT_EQ(at_the_door(Role::Player, {.invite = {}, .passcode = "\xff"}),
              RefusedCode::WrongSecret);
}

TEST_F(AccessTest, ChangesNothingForAPasscodeThatIsNoText) {
    lock("cue");
    for (const std::string& wrong : {std::string("a\x07"), std::string(33, 'x')}) {
        const auto changed = access.change(false, wrong, random);
        ASSERT_FALSE(changed.ok());
        EXPECT_EQ(changed.error(), RefusedCode::Malformed);
    }
    EXPECT_EQ(at_the_door(Role::Player, {.invite = {}, .passcode = "cue"}), std::nullopt);
}

TEST_F(AccessTest, GivesEqualPasscodesDifferentHashes) {
    lock("cue");
    const auto first = stored().passcode_hash;
    lock("cue");
    EXPECT_NE(stored().passcode_hash, first);
}

TEST_F(AccessTest, OpensPlayingOnceToAPlayInvite) {
    lock();
    const Shown shown = invited(true);
    const auto admitted = access.admits(now, kStranger, Role::Player, shown);
    ASSERT_TRUE(admitted.ok());
    EXPECT_EQ(at_the_door(Role::Player, shown), std::nullopt) << "the seat was not taken yet";
    access.use_up(*admitted);
    EXPECT_EQ(at_the_door(Role::Player, shown), RefusedCode::WrongSecret);
}

TEST_F(AccessTest, DoesNotUseAPlayInviteUpByWatching) {
    lock();
    const Shown shown = invited(true);
    const auto admitted = access.admits(now, kStranger, Role::Spectator, shown);
    ASSERT_TRUE(admitted.ok());
    access.use_up(*admitted);
    EXPECT_EQ(at_the_door(Role::BothSeats, shown), std::nullopt);
}

TEST_F(AccessTest, OpensOnlyWatchingToAWatchInviteAndAsOftenAsWanted) {
    lock();
    const Shown shown = invited(false);
    for (int i = 0; i < 3; ++i) {
        const auto admitted = access.admits(now, kStranger, Role::Spectator, shown);
        ASSERT_TRUE(admitted.ok());
        access.use_up(*admitted);
    }
    EXPECT_EQ(at_the_door(Role::Player, shown), RefusedCode::WrongSecret);
    EXPECT_EQ(at_the_door(Role::BothSeats, shown), RefusedCode::WrongSecret);
}

TEST_F(AccessTest, TakesThePasscodeOfWhoShowsAStaleInviteWithIt) {
    lock("cue");
    EXPECT_EQ(at_the_door(Role::Player, {.invite = protocol::InviteSecret{}, .passcode = "cue"}),
              std::nullopt);
}

TEST_F(AccessTest, LetsInvitesExpire) {
    lock();
    const auto made = access.invite(now, true, random);
    EXPECT_EQ(made->expires, now + limits.invite_kept);
    now = made->expires - 1us;
    EXPECT_EQ(at_the_door(Role::Player, {.invite = made->secret}), std::nullopt);
    EXPECT_EQ(stored().invites.size(), 1U);
    now = made->expires;
    EXPECT_EQ(at_the_door(Role::Player, {.invite = made->secret}), RefusedCode::WrongSecret);
    EXPECT_TRUE(stored().invites.empty());
}

TEST_F(AccessTest, RevokesAllInvites) {
    lock();
    const Shown to_play = invited(true);
    const Shown to_watch = invited(false);
    access.revoke_invites();
    EXPECT_EQ(at_the_door(Role::Player, to_play), RefusedCode::WrongSecret);
    EXPECT_EQ(at_the_door(Role::Spectator, to_watch), RefusedCode::WrongSecret);
}

TEST_F(AccessTest, LimitsHowManyInvitesStandAtOnce) {
    limits.invites_per_table = 2;
    make_invite(true);
    make_invite(false);
    const auto refused = access.invite(now, true, random);
    ASSERT_FALSE(refused.ok());
    EXPECT_EQ(refused.error(), RefusedCode::TooMany);
    now += limits.invite_kept;
    EXPECT_TRUE(access.invite(now, true, random).ok());
}

TEST_F(AccessTest, LimitsWrongSecretsHoweverTheyAreMixedAndGood) {
    lock("cue");
    const Shown good_passcode{.invite = {}, .passcode = "cue"};
    for (int i = 0; i < limits.wrong_secrets_per_min; ++i) {
        EXPECT_EQ(at_the_door(Role::Player, good_passcode), std::nullopt);
        const Shown wrong = i % 2 == 0 ? Shown{.invite = {}, .passcode = "guess"}
                                       : Shown{.invite = protocol::InviteSecret{}};
        EXPECT_EQ(at_the_door(Role::Player, wrong), RefusedCode::WrongSecret);
    }
    EXPECT_EQ(at_the_door(Role::Player, {.invite = {}, .passcode = "guess"}), RefusedCode::TooMany);
    EXPECT_EQ(at_the_door(Role::Player, good_passcode), RefusedCode::TooMany);
    now += 60s;
    EXPECT_EQ(at_the_door(Role::Player, good_passcode), std::nullopt);
}

TEST_F(AccessTest, KeepsAGoodInviteGoodWhateverOthersGuess) {
    lock("cue");
    const Shown shown = invited(true);
    for (int i = 0; i < 2 * limits.wrong_secrets_per_min; ++i) {
        at_the_door(Role::Player, {.invite = {}, .passcode = "guess"});
    }
    EXPECT_EQ(at_the_door(Role::Player, shown), std::nullopt);
}

TEST_F(AccessTest, DoesNotCountStrangersWhoShowNothing) {
    lock("cue");
    for (int i = 0; i < 2 * limits.wrong_secrets_per_min; ++i) at_the_door(Role::Player);
    EXPECT_EQ(at_the_door(Role::Player, {.invite = {}, .passcode = "cue"}), std::nullopt);
}

TEST_F(AccessTest, LetsNobodyBackInWhoWasKickedWhateverTheyShow) {
    access.kick(kStranger);
    EXPECT_EQ(at_the_door(Role::Spectator), RefusedCode::NotAllowed);
    lock("cue");
    Shown shown = invited(true);
    shown.passcode = "cue";
    EXPECT_EQ(at_the_door(Role::Player, shown), RefusedCode::NotAllowed);
    EXPECT_EQ(at_the_door(Role::Player, shown, PlayerId{3}), std::nullopt);
}

TEST_F(AccessTest, ForgetsTheOldestOfTooManyWhoWereKicked) {
    limits.kicked_per_table = 2;
    for (const std::uint64_t player : {10U, 11U, 11U, 12U}) access.kick({player});
    EXPECT_FALSE(access.is_kicked({10}));
    EXPECT_TRUE(access.is_kicked({11}));
    EXPECT_TRUE(access.is_kicked({12}));
}

TEST_F(AccessTest, PassesTheTableOn) {
    lock();
    access.pass_to({kStranger, "Grace#0002"});
    EXPECT_EQ(access.owner().name, "Grace#0002");
    EXPECT_EQ(at_the_door(Role::Player), std::nullopt);
    EXPECT_EQ(at_the_door(Role::Player, {}, kOwner), RefusedCode::UnknownTable);
}

TEST_F(AccessTest, IsTheSameAfterARestartAndItsInvitesAsGoodAsNew) {
    lock("cue");
    const Shown to_play = invited(true);
    const Shown to_watch = invited(false);
    access.kick({7});
    now += limits.invite_kept - 1us;
    const StoredTable table = stored();

    Access again(limits, table, "Ada#0001", base::Instant{});
    StoredTable again_stored;
    again.store_into(again_stored);
    EXPECT_EQ(again_stored, table);
    EXPECT_EQ(again.owner().name, "Ada#0001");
    const base::Instant later = base::Instant{} + limits.invite_kept - 1us;
    EXPECT_TRUE(again.admits(later, kStranger, Role::Player, to_play).ok());
    EXPECT_TRUE(again.admits(later, kStranger, Role::Spectator, to_watch).ok());
    EXPECT_TRUE(
        again.admits(later, kStranger, Role::Player, {.invite = {}, .passcode = "cue"}).ok());
    EXPECT_FALSE(again.admits(later, PlayerId{7}, Role::Player, to_play).ok());
}

TEST_F(AccessTest, StoresNoSecret) {
    lock("cue");
    const auto secret = make_invite(true);
    EXPECT_EQ(stored().invites.front().hash, hash_of(secret));
    EXPECT_EQ(stored().passcode_hash, hash_of(stored().passcode_salt, "cue"));
}

}  // namespace
}  // namespace billiards::server
