// Takes shots told event by event; gives whether the facts drawn from them are right.
#include "common/rules/facts.h"

#include "tests/common/rules/told_shot.h"

#include <gtest/gtest.h>

namespace billiards::rules {
namespace {

TEST(Facts, NothingHappenedGivesNoFacts) {
    EXPECT_EQ(facts_of({}), Facts{});
}

TEST(Facts, FirstContactIsTheFirstBallTheCueBallMeets) {
    const Facts facts = ToldShot().meets(4, 5).hits(3).hits(7).facts();
    EXPECT_EQ(facts.first_contacts, balls({3}));
}

TEST(Facts, FirstContactIsFoundInEitherOrderOfTheTwoBalls) {
    model::ShotEvent event = model::ShotEvent::ball_ball(0.1, model::kCueBall, model::BallId{6});
    std::swap(event.ball, event.other);
    EXPECT_EQ(facts_of(std::vector{event}).first_contacts, balls({6}));
}

TEST(Facts, ContactsAtTheSameInstantAreFirstTogether) {
    EXPECT_EQ(ToldShot().hits(3).at_once().hits(7).facts().first_contacts, balls({3, 7}));
    EXPECT_EQ(ToldShot().hits(3).after(5e-10).hits(7).facts().first_contacts, balls({3, 7}));
}

TEST(Facts, ContactAMicrosecondLaterIsNotFirst) {
    EXPECT_EQ(ToldShot().hits(3).after(1e-6).hits(7).facts().first_contacts, balls({3}));
}

TEST(Facts, PocketedBallsAreInTheOrderInWhichTheyFell) {
    const std::vector<PocketedBall> expected{{{9}, {4}}, {{2}, {1}}};
    EXPECT_EQ(ToldShot().hits(9).pots(9, 4).pots(2, 1).facts().pocketed, expected);
}

TEST(Facts, CueBallIsLostInAPocketAndOffTheTableAlike) {
    EXPECT_TRUE(ToldShot().pots(0).facts().cue_ball_lost);
    EXPECT_TRUE(ToldShot().leaves(0).facts().cue_ball_lost);
    EXPECT_FALSE(ToldShot().hits(3).pots(3).leaves(4).facts().cue_ball_lost);
}

TEST(Facts, CueBallIsNeitherAmongThePocketedNorAmongTheLost) {
    EXPECT_TRUE(ToldShot().pots(0).facts().pocketed.empty());
    EXPECT_TRUE(ToldShot().leaves(0).facts().off_table.empty());
}

TEST(Facts, BallsOffTheTableAreObjectBallsThatLeftIt) {
    const Facts facts = ToldShot().hits(3).leaves(3).pots(4).facts();
    EXPECT_EQ(facts.off_table, balls({3}));
}

TEST(Facts, DrivenToACushionAreNosesJawsPocketsAndTheFloor) {
    const Facts facts =
        ToldShot().hits(1).cushion(1).jaw(2).pots(3).leaves(4).cushion(0).moves(5).lands(6).facts();
    EXPECT_EQ(facts.driven_to_cushion, balls({1, 2, 3, 4}));
}

TEST(Facts, HeldContactIsNotDrivenToACushion) {
    const Facts facts = ToldShot().hits(1).cushion(1, true).jaw(2, true).facts();
    EXPECT_TRUE(facts.driven_to_cushion.empty());
    EXPECT_TRUE(facts.driven_after_contact.empty());
}

struct CushionCase {
    const char* what;
    ToldShot shot;
    model::BallSet after_contact;
};

TEST(Facts, DrivenAfterContactIsAnyBallAtOrAfterTheFirstContact) {
    const CushionCase cases[] = {
        {"no contact at all", ToldShot().cushion(0), {}},
        {"cushion only before", ToldShot().cushion(0).hits(3), {}},
        {"object ball to a cushion", ToldShot().hits(3).cushion(3), balls({3})},
        {"cue ball to a cushion", ToldShot().hits(3).cushion(0), balls({0})},
        {"cue ball to a jaw", ToldShot().hits(3).jaw(0), balls({0})},
        {"another ball to a cushion", ToldShot().hits(3).meets(3, 4).cushion(4), balls({4})},
        {"ball pocketed", ToldShot().hits(3).pots(3), balls({3})},
        {"cue ball pocketed", ToldShot().hits(3).pots(0), balls({0})},
        {"ball off the table", ToldShot().hits(3).leaves(3), balls({3})},
        {"cushion at the same instant", ToldShot().hits(3).at_once().cushion(0), balls({0})},
        {"cushion told before its contact", ToldShot().cushion(0).at_once().hits(3), balls({0})},
        {"held by the cushion", ToldShot().hits(3).cushion(3, true), {}},
        {"only rolls", ToldShot().hits(3).moves(3), {}},
    };
    for (const CushionCase& each : cases) {
        EXPECT_EQ(each.shot.facts().driven_after_contact, each.after_contact) << each.what;
    }
}

struct CrossingCase {
    const char* what;
    ToldShot shot;
    bool crossed;
};

TEST(Facts, HeadStringIsCrossedTowardsTheFootBeforeTheFirstContact) {
    const CrossingCase cases[] = {
        {"never", ToldShot().hits(3), false},
        {"before contact", ToldShot().crosses_head_string().hits(3), true},
        {"without contact", ToldShot().crosses_head_string(), true},
        {"after contact", ToldShot().hits(3).crosses_head_string(), false},
        {"the other way", ToldShot().crosses_head_string(-1).hits(3), false},
        {"and back", ToldShot().crosses_head_string().crosses_head_string(-1).hits(3), true},
    };
    for (const CrossingCase& each : cases) {
        EXPECT_EQ(each.shot.facts().crossed_head_string, each.crossed) << each.what;
    }
}

TEST(Facts, FallenBallsAreTheObjectBallsPocketed) {
    EXPECT_EQ(fallen_balls(ToldShot().hits(3).pots(3).pots(9).pots(0).leaves(4).facts()),
              balls({3, 9}));
}

}  // namespace
}  // namespace billiards::rules
