// Holds a player without a screen against what servers say, moment by moment.
#include "tools/player/headless_player.h"

#include "tests/client/app/told.h"
#include "tools/player/command_message.h"

#include <gtest/gtest.h>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace billiards::tools {
namespace {

namespace asked = protocol::client;
namespace server = protocol::server;
namespace told = client::told;
using model::Seat;
using std::chrono::milliseconds;
using std::chrono::seconds;
using told::kNow;

constexpr protocol::TableId kTable{7};

match::Command shoot_straight(const match::MatchState& state, base::Random&) {
    if (!state.layout.on_table(model::kCueBall)) return match::PlaceCueBall{{-0.6, 0.0}};
    return match::TakeShot{.turn = state.turn, .shot = {}, .call = {}};
}

/// A player and all it said and told.
struct Played {
    std::vector<protocol::ClientMessageBody> said;
    std::vector<std::string> told;
    std::vector<int> shots;
    std::function<match::Command(const match::MatchState&, base::Random&)> choose = shoot_straight;
    HeadlessPlayer player;

    explicit Played(PlayerOptions options = {})
        : player(with_choose(std::move(options)), events(), [this](auto body) {
              said.push_back(std::move(body));
              return static_cast<std::uint32_t>(said.size());
          }) {}

    PlayerOptions with_choose(PlayerOptions options) {
        options.choose = [this](const auto& state, auto& random) { return choose(state, random); };
        return options;
    }
    PlayerEvents events() {
        PlayerEvents events;
        events.shot = [this](const auto&, const server::ShotPlayed& shot) {
            shots.push_back(shot.after.shots_played);
        };
        events.over = [this](const auto&, const auto&) { told.emplace_back("over"); };
        events.seated = [this](const auto&) { told.emplace_back("seated"); };
        return events;
    }
    Played& hears(const protocol::ServerMessage& message, base::Instant at = kNow) {
        player.received(message, at);
        return *this;
    }
    Played& waits_until(base::Instant at) {
        player.advance_time(at);
        return *this;
    }
    template <class Message>
    std::vector<Message> said_of() const {
        std::vector<Message> found;
        for (const auto& body : said) {
            if (const auto* message = std::get_if<Message>(&body)) found.push_back(*message);
        }
        return found;
    }
};

server::TableSnapshot at_turn(std::uint32_t turn, Seat to_act, int shots_played = 0) {
    return told::snapshot(1, {Seat::First}, told::match_at(turn, to_act, shots_played));
}

/// Ada's seat, her turn open since now.
Played adas_turn(PlayerOptions options = {}) {
    Played played(std::move(options));
    server::TableSnapshot snapshot = at_turn(3, Seat::First);
    snapshot.turn.opens_us = told::welcome().server_time_us;
    played.hears(told::welcome(kTable)).hears(snapshot);
    return played;
}

TEST(HeadlessPlayer, OpensATableWhereItWasGivenNone) {
    PlayerOptions options;
    options.table_name = "Mine";
    options.settings.race_to = 4;
    Played played(options);
    played.hears(told::welcome());
    const auto opened = played.said_of<asked::CreateTable>();
    ASSERT_EQ(opened.size(), 1U);
    EXPECT_EQ(opened[0].name, "Mine");
    EXPECT_EQ(opened[0].settings.race_to, 4);
}

TEST(HeadlessPlayer, JoinsTheTableItWasGiven) {
    PlayerOptions options;
    options.table = kTable;
    options.role = protocol::Role::Spectator;
    Played played(options);
    played.hears(told::welcome());
    EXPECT_EQ(played.said_of<asked::Join>(),
              (std::vector{asked::Join{.table = kTable, .role = protocol::Role::Spectator}}));
}

TEST(HeadlessPlayer, AWelcomeBackToItsTableAsksForNothing) {
    Played played;
    played.hears(told::welcome(kTable));
    EXPECT_TRUE(played.said.empty());
}

TEST(HeadlessPlayer, IsReadyAtATableThatWaits) {
    Played player;
    player.hears(told::snapshot(1, {Seat::First}, std::nullopt));
    EXPECT_EQ(player.said_of<asked::Ready>().size(), 1U);
    Played spectator;
    spectator.hears(told::snapshot(1, {}, std::nullopt));
    EXPECT_TRUE(spectator.said.empty());
}

TEST(HeadlessPlayer, ShootsWhenItsTurnIsOpenAndItHasThought) {
    PlayerOptions options;
    options.min_think = options.max_think = milliseconds(700);
    Played played(options);
    server::TableSnapshot snapshot = at_turn(3, Seat::First);
    snapshot.turn.opens_us = told::welcome().server_time_us + 2'000'000;
    played.hears(told::welcome(kTable)).hears(snapshot);
    const base::Instant due = kNow + seconds(2) + milliseconds(700);
    EXPECT_EQ(played.player.next_deadline(), due);
    EXPECT_TRUE(played.waits_until(due - milliseconds(1)).said.empty());
    const auto shots = played.waits_until(due).said_of<asked::TakeShot>();
    ASSERT_EQ(shots.size(), 1U);
    EXPECT_EQ(shots[0].turn, model::TurnNumber{3});
}

TEST(HeadlessPlayer, DoesNothingInTheOthersTurn) {
    Played played;
    played.hears(told::welcome(kTable)).hears(at_turn(3, Seat::Second));
    EXPECT_FALSE(played.player.next_deadline());
}

TEST(HeadlessPlayer, ActsSoonerWhenTheTurnOpensSooner) {
    Played played;
    server::TableSnapshot snapshot = at_turn(3, Seat::First);
    snapshot.turn.opens_us = told::welcome().server_time_us + 9'000'000;
    played.hears(told::welcome(kTable)).hears(snapshot);
    server::TurnOpened opened;
    opened.sequence = 2;
    opened.number = model::TurnNumber{3};
    opened.turn.opens_us = told::welcome().server_time_us + 1'000'000;
    played.hears(opened);
    EXPECT_EQ(played.player.next_deadline(), kNow + seconds(1));
}

TEST(HeadlessPlayer, SetsTheCueBallDownAndThenShoots) {
    Played played;
    server::TableSnapshot snapshot = at_turn(3, Seat::First);
    snapshot.match->layout.balls[0].place = model::Place::InHand;
    played.hears(told::welcome(kTable)).hears(snapshot).waits_until(kNow + seconds(60));
    ASSERT_EQ(played.said_of<asked::PlaceCueBall>().size(), 1U);
    EXPECT_FALSE(played.player.next_deadline()) << "it waits for the answer";
    played.hears(server::CueBallPlaced{2, Seat::First, {-0.6, 0.0}});
    played.waits_until(kNow + seconds(60));
    EXPECT_EQ(played.said_of<asked::TakeShot>().size(), 1U);
}

TEST(HeadlessPlayer, SaysSeenAtOnceOrWhenTheBallsRest) {
    server::ShotPlayed shot = told::shot(2, told::match_at(4, Seat::Second, 1));
    shot.struck_us = told::welcome().server_time_us;
    shot.record.duration_s = 3.0;
    for (const bool watches : {false, true}) {
        PlayerOptions options;
        options.watches_balls_roll = watches;
        Played played(options);
        played.hears(told::welcome(kTable)).hears(at_turn(3, Seat::Second)).hears(shot);
        const base::Instant due = watches ? kNow + seconds(3) : kNow;
        EXPECT_EQ(played.player.next_deadline(), due);
        played.waits_until(due);
        EXPECT_EQ(played.said_of<asked::Seen>(), std::vector{asked::Seen{.sequence = 2}});
    }
}

TEST(HeadlessPlayer, AfterARefusalItWaitsAndShootsUnderAnotherId) {
    Played played = adas_turn();
    played.waits_until(kNow);
    played.hears(told::refused(protocol::RefusedCode::TooEarly, 1));
    EXPECT_GT(played.player.next_deadline(), kNow);
    played.waits_until(kNow + seconds(1));
    const auto shots = played.said_of<asked::TakeShot>();
    ASSERT_EQ(shots.size(), 2U);
    EXPECT_NE(shots[0].shot_id, shots[1].shot_id);
}

TEST(HeadlessPlayer, ARefusalOfSomethingElseChangesNothing) {
    Played played = adas_turn();
    played.waits_until(kNow);
    played.hears(told::refused(protocol::RefusedCode::TooMany, 99));
    EXPECT_FALSE(played.player.next_deadline());
    EXPECT_FALSE(played.player.is_finished());
}

TEST(HeadlessPlayer, GivesUpWhereEverythingIsRefused) {
    Played played = adas_turn();
    base::Instant now = kNow;
    for (int i = 0; i < 100 && !played.player.is_finished(); ++i) {
        now += seconds(1);
        played.waits_until(now);
        played.hears(told::refused(protocol::RefusedCode::Match,
                                   static_cast<std::uint32_t>(played.said.size())),
                     now);
    }
    EXPECT_TRUE(played.player.is_finished());
    EXPECT_FALSE(played.player.failure().empty());
    EXPECT_LT(played.said.size(), 50U);
}

TEST(HeadlessPlayer, AShotThatIsOnItsWayIsNotDecidedASecondTime) {
    Played played = adas_turn();
    played.waits_until(kNow);
    ASSERT_EQ(played.said_of<asked::TakeShot>().size(), 1U);
    played.player.link_lost();
    played.hears(told::welcome(kTable)).hears(at_turn(3, Seat::First));
    EXPECT_FALSE(played.player.next_deadline());
    played.hears(told::shot(2, told::match_at(4, Seat::First, 1)));
    played.waits_until(kNow + seconds(60));
    EXPECT_EQ(played.said_of<asked::TakeShot>().size(), 2U);
}

/// Its turn, with the cue ball in hand.
server::TableSnapshot in_hand() {
    server::TableSnapshot snapshot = at_turn(3, Seat::First);
    snapshot.match->layout.balls[0].place = model::Place::InHand;
    return snapshot;
}

TEST(HeadlessPlayer, LeavesWhatTheLinkSaysAgainToTheLink) {
    Played played;
    for (int attempt = 0; attempt < 3; ++attempt) {
        played.hears(told::welcome(kTable)).hears(in_hand()).waits_until(kNow + seconds(60));
        played.player.link_lost();
        EXPECT_FALSE(played.player.next_deadline());
    }
    ASSERT_EQ(played.said_of<asked::PlaceCueBall>().size(), 1U);
    played.hears(told::welcome(kTable)).hears(in_hand());
    played.hears(server::CueBallPlaced{2, Seat::First, {-0.6, 0.0}})
        .waits_until(kNow + seconds(60));
    EXPECT_EQ(played.said_of<asked::TakeShot>().size(), 1U);
}

TEST(HeadlessPlayer, DecidesAnewWhatTheLinkDoesNotSayAgain) {
    Played played;
    played.choose = [](const match::MatchState& state, base::Random&) {
        return match::Offer{.turn = state.turn, .kind = match::OfferKind::Draw};
    };
    for (int attempt = 0; attempt < 2; ++attempt) {
        played.hears(told::welcome(kTable)).hears(at_turn(3, Seat::First));
        played.waits_until(kNow + seconds(60));
        played.player.link_lost();
    }
    EXPECT_EQ(played.said_of<asked::Offer>().size(), 2U);
}

TEST(HeadlessPlayer, GoesOnWhereItWasWhenNothingWasMissed) {
    Played played;
    played.hears(told::welcome(kTable)).hears(at_turn(3, Seat::Second));
    played.player.link_lost();
    played.hears(told::welcome(kTable)).waits_until(kNow + seconds(60));
    EXPECT_TRUE(played.said.empty());
    played.hears(
        server::Resumed{.table = kTable, .your_seats = {Seat::First}, .server_time_us = 0});
    played.hears(told::shot(2, told::match_at(4, Seat::First, 1))).waits_until(kNow + seconds(60));
    EXPECT_EQ(played.said_of<asked::TakeShot>().size(), 1U);
    EXPECT_EQ(played.player.digest().missed(), 0);
    EXPECT_EQ(played.told, (std::vector<std::string>{"seated", "seated"}));
}

TEST(HeadlessPlayer, WaitsForASnapshotBeforeItActsOnANewLink) {
    Played played = adas_turn();
    played.player.link_lost();
    played.hears(told::welcome(kTable)).waits_until(kNow + seconds(60));
    EXPECT_TRUE(played.said.empty());
    played.hears(at_turn(4, Seat::First)).waits_until(kNow + seconds(60));
    ASSERT_EQ(played.said.size(), 1U);
    EXPECT_EQ(played.said_of<asked::TakeShot>().at(0).turn, model::TurnNumber{4});
}

TEST(HeadlessPlayer, CannotGoOnWhereItsGreetingIsRefused) {
    Played played;
    played.hears(told::refused(protocol::RefusedCode::BadName, 0));
    EXPECT_TRUE(played.player.failure().starts_with("the server refuses"));
}

TEST(HeadlessPlayer, StartedOverWithTheSameSeedItShootsUnderTheSameId) {
    PlayerOptions options;
    options.seed = 5;
    Played before = adas_turn(options);
    Played after = adas_turn(options);
    options.seed = 6;
    Played other = adas_turn(options);
    const auto id = [](Played& played) {
        return played.waits_until(kNow).said_of<asked::TakeShot>().at(0).shot_id;
    };
    EXPECT_EQ(id(before), id(after));
    EXPECT_NE(id(before), id(other));
}

TEST(HeadlessPlayer, EachShotIsToldOnceInWhateverWayItCame) {
    Played played;
    played.hears(told::welcome(kTable)).hears(at_turn(3, Seat::Second));
    played.hears(told::shot(2, told::match_at(4, Seat::Second, 1)));
    played.hears(told::shot(2, told::match_at(4, Seat::Second, 1)));
    server::TableSnapshot snapshot = at_turn(5, Seat::Second, 2);
    snapshot.rolling = told::shot(3, told::match_at(5, Seat::Second, 2));
    played.hears(snapshot).hears(snapshot);
    EXPECT_EQ(played.shots, (std::vector{1, 2}));
    EXPECT_EQ(played.player.digest().missed(), 0);
    played.hears(told::shot(9, told::match_at(8, Seat::Second, 5)));
    EXPECT_EQ(played.player.digest().missed(), 2);
}

TEST(HeadlessPlayer, IsFinishedWhenTheMatchIs) {
    Played played;
    played.hears(told::welcome(kTable)).hears(at_turn(3, Seat::Second));
    EXPECT_FALSE(played.player.is_finished());
    played.hears(told::over(2, Seat::Second));
    EXPECT_TRUE(played.player.is_finished());
    EXPECT_EQ(played.told, (std::vector<std::string>{"seated", "over"}));
}

TEST(HeadlessPlayer, LearnsOfAnEndThatItMissed) {
    Played played;
    played.hears(told::welcome(kTable)).hears(at_turn(3, Seat::Second));
    server::TableSnapshot over = at_turn(9, Seat::Second, 6);
    over.match->stage = match::Stage::Over;
    over.match->winner = Seat::Second;
    played.hears(told::welcome(kTable)).hears(over);
    EXPECT_TRUE(played.player.is_finished());
    EXPECT_EQ(played.told, (std::vector<std::string>{"seated", "over", "seated"}));
}

TEST(HeadlessPlayer, PlaysAgainWhereItIsAskedTo) {
    PlayerOptions options;
    options.plays_again = true;
    Played played(options);
    played.hears(told::welcome(kTable)).hears(at_turn(3, Seat::Second));
    played.hears(told::over(2, Seat::Second));
    EXPECT_FALSE(played.player.is_finished());
    EXPECT_EQ(played.said_of<asked::Rematch>().size(), 1U);
    EXPECT_TRUE(played.said_of<asked::Ready>().empty());
}

TEST(HeadlessPlayer, PlaysAgainWithSomebodyElseWhereItsOpponentIsGone) {
    PlayerOptions options;
    options.plays_again = true;
    Played played(options);
    played.hears(told::welcome(kTable)).hears(at_turn(3, Seat::Second));
    played.hears(told::over(2, Seat::Second));
    played.hears(told::refused(protocol::RefusedCode::NotAllowed, 1));
    EXPECT_EQ(played.said_of<asked::Ready>().size(), 1U);
}

TEST(HeadlessPlayer, IsReadyAgainWhenTheTableWasChanged) {
    Played played;
    const server::TableSnapshot waiting = told::snapshot(1, {Seat::First}, std::nullopt);
    played.hears(waiting).hears(server::TableChanged{.sequence = 2, .row = waiting.row});
    EXPECT_EQ(played.said_of<asked::Ready>().size(), 2U);
}

server::SeatChanged grace_away(std::optional<std::int64_t> claimable_us) {
    server::SeatChanged changed{
        .sequence = 2, .seats = at_turn(3, Seat::Second).row.seats, .spectators = 0};
    changed.seats[Seat::Second].taken = true;
    changed.seats[Seat::Second].claimable_us = claimable_us;
    return changed;
}

TEST(HeadlessPlayer, ClaimsTheMatchAsSoonAsItMay) {
    PlayerOptions options;
    options.claims_match = true;
    Played played(options);
    played.hears(told::welcome(kTable)).hears(at_turn(3, Seat::Second));
    EXPECT_FALSE(played.player.next_deadline());
    played.hears(grace_away(told::welcome().server_time_us + 60'000'000));
    EXPECT_EQ(played.player.next_deadline(), kNow + seconds(60));
    played.waits_until(kNow + seconds(60)).waits_until(kNow + seconds(61));
    EXPECT_EQ(played.said_of<asked::ClaimMatch>().size(), 1U);
    played.hears(told::refused(protocol::RefusedCode::NotAllowed, 1), kNow + seconds(61));
    played.waits_until(kNow + seconds(62));
    EXPECT_EQ(played.said_of<asked::ClaimMatch>().size(), 2U) << "its clock may be ahead";
}

TEST(HeadlessPlayer, WaitsForAnOpponentWhoIsAwayUnlessItIsToldToClaim) {
    Played played;
    played.hears(told::welcome(kTable)).hears(at_turn(3, Seat::Second));
    played.hears(grace_away(told::welcome().server_time_us));
    EXPECT_FALSE(played.player.next_deadline());
}

server::MatchMoved draw_offered(Seat by) {
    match::MatchState match = told::match_at(3, Seat::Second);
    match.offer = {match::OfferKind::Draw, by};
    server::MatchMoved moved = told::moved(2, by, match);
    moved.move = server::Move::Offer;
    return moved;
}

TEST(HeadlessPlayer, AnswersOffersAsItIsTold) {
    for (const auto& accepts : {std::optional<bool>(), std::optional(true), std::optional(false)}) {
        PlayerOptions options;
        options.accepts_offers = accepts;
        Played played(options);
        played.hears(told::welcome(kTable)).hears(at_turn(3, Seat::Second));
        played.hears(draw_offered(Seat::Second)).waits_until(kNow + seconds(60));
        played.waits_until(kNow + seconds(61));
        const auto answers = played.said_of<asked::Answer>();
        ASSERT_EQ(answers.size(), accepts ? 1U : 0U);
        if (!accepts) continue;
        EXPECT_EQ(answers[0], (asked::Answer{.turn = {3}, .accept = *accepts}));
    }
}

TEST(HeadlessPlayer, DoesNotAnswerItsOwnOffer) {
    PlayerOptions options;
    options.accepts_offers = true;
    Played played(options);
    played.hears(told::welcome(kTable)).hears(at_turn(3, Seat::Second));
    played.hears(draw_offered(Seat::First)).waits_until(kNow + seconds(60));
    EXPECT_TRUE(played.said.empty());
}

TEST(HeadlessPlayer, AsksForAsLongAsItTakesWhereTheServerCannotStore) {
    Played played = adas_turn();
    base::Instant now = kNow;
    for (int i = 0; i < 100; ++i) {
        now += seconds(1);
        played.waits_until(now);
        played.hears(told::refused(protocol::RefusedCode::StorageFailed,
                                   static_cast<std::uint32_t>(played.said.size())),
                     now);
    }
    EXPECT_FALSE(played.player.is_finished());
    const auto shots = played.said_of<asked::TakeShot>();
    EXPECT_EQ(shots.size(), 100U);
    EXPECT_EQ(shots.front().shot_id, shots.back().shot_id);
}

TEST(CommandMessage, SaysEveryCommandOfAPlayer) {
    constexpr model::TurnNumber kTurn{3};
    const std::vector<std::pair<match::Command, protocol::ClientMessageBody>> all{
        {match::PlaceCueBall{{1.0, 2.0}}, asked::PlaceCueBall{kTurn, {1.0, 2.0}}},
        {match::TakeShot{.turn = kTurn, .shot = {}, .call = {}},
         asked::TakeShot{.turn = kTurn, .shot_id = 7, .shot = {}, .call = {}}},
        {match::Choose{kTurn, rules::Choice::PassBack},
         asked::Choose{kTurn, rules::Choice::PassBack}},
        {match::Concede{}, asked::Concede{}},
        {match::Extend{kTurn}, asked::Extend{kTurn}},
        {match::Offer{kTurn, match::OfferKind::Draw}, asked::Offer{kTurn, match::OfferKind::Draw}},
        {match::Answer{kTurn, true}, asked::Answer{kTurn, true}},
        {match::ClaimStalemate{kTurn}, asked::ClaimStalemate{kTurn}},
        {match::SpotNearest{kTurn}, asked::SpotNearest{kTurn}},
        {match::PlaceBall{model::BallId{5}, {1.0, 2.0}},
         asked::PlaceBall{model::BallId{5}, {1.0, 2.0}}},
        {match::Undo{}, asked::Undo{}},
        {match::Repeat{}, asked::Repeat{}},
        {match::Rerack{}, asked::Rerack{}}};
    for (const auto& [command, message] : all) EXPECT_EQ(message_of(command, kTurn, 7), message);
}

TEST(HeadlessPlayer, CannotGoOnWithoutItsTable) {
    Played gone;
    gone.hears(told::welcome(kTable)).hears(at_turn(3, Seat::Second)).hears(told::welcome());
    EXPECT_FALSE(gone.player.failure().empty());

    PlayerOptions options;
    options.table = kTable;
    Played taken(options);
    taken.hears(told::welcome()).hears(told::refused(protocol::RefusedCode::SeatTaken, 1));
    EXPECT_FALSE(taken.player.failure().empty());
}

TEST(HeadlessPlayer, ShowsItsAimWhileItThinks) {
    PlayerOptions options;
    options.min_think = options.max_think = seconds(1);
    options.aim_every = milliseconds(100);
    Played played = adas_turn(options);
    for (base::Instant at = kNow; at <= kNow + seconds(1); at += milliseconds(1)) {
        played.waits_until(at);
    }
    EXPECT_EQ(played.said_of<asked::Aim>().size(), 10U);
    EXPECT_EQ(played.said_of<asked::TakeShot>().size(), 1U);
}

}  // namespace
}  // namespace billiards::tools
