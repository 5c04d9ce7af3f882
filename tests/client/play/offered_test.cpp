// Takes tables at all stages; gives whether exactly that is offered which the match would take.
#include "client/play/offered.h"

#include "common/match/match.h"
#include "tests/client/app/told.h"

#include <gtest/gtest.h>

namespace billiards::client {
namespace {

using model::Seat;

constexpr std::int64_t kSecond_us = 1'000'000;

/// Local time is the server's.
ClientState known() {
    ClientState known;
    known.name = "Ada#12ab";
    known.clock_offset = base::Duration::zero();
    return known;
}

TableView table_of(const match::MatchState& match, std::vector<Seat> mine = {Seat::First}) {
    TableView table;
    for (const Seat seat : model::kSeats) {
        table.row.seats[seat] = {.taken = true, .connected = true, .ready = false, .name = {}};
    }
    table.row.seats[Seat::First].name = "Ada#12ab";
    table.row.seats[Seat::Second].name = "Grace#3f21";
    table.row.settings = match.settings;
    table.row.playing = true;
    table.my_seats = std::move(mine);
    table.match = match;
    return table;
}

match::MatchState started(rules::Game game = rules::Game::EightBall) {
    match::Settings settings;
    settings.game = game;
    return *match::start(settings, 1);
}

match::MatchState broken(Seat to_act = Seat::First) {
    match::MatchState match = started();
    match.rack.phase = rules::Phase::Open;
    match.rack.shooter = match.to_act = to_act;
    match.rack.in_hand = rules::Zone::None;
    return match;
}

Offered offered_to(const TableView& table, std::optional<Seat> acting = Seat::First,
                   base::Instant now = told::kNow) {
    return offered(known(), table, acting, now);
}

TEST(Offered, NothingIsOfferedToAWatcher) {
    EXPECT_EQ(offered_to(table_of(broken(), {}), std::nullopt), Offered{});
}

TEST(Offered, AnExtensionIsOfferedOnceARackToWhoeverIsToAct) {
    match::MatchState match = broken();
    EXPECT_TRUE(offered_to(table_of(match)).extension);
    EXPECT_FALSE(offered_to(table_of(match), std::nullopt).extension);
    match.extended_in[Seat::First] = match.turn;
    EXPECT_FALSE(offered_to(table_of(match)).extension);
    match = broken();
    match.settings.shot_clock_s = 0.0;
    EXPECT_FALSE(offered_to(table_of(match)).extension);
}

TEST(Offered, ADrawAndAnotherRackMayBeOfferedByEitherUntilAnOfferStands) {
    match::MatchState match = broken(Seat::Second);
    const Offered before = offered_to(table_of(match), std::nullopt);
    EXPECT_TRUE(before.offer_draw);
    EXPECT_TRUE(before.offer_replay);
    match.offer = {.kind = match::OfferKind::Draw, .by = Seat::First};
    const Offered after = offered_to(table_of(match), std::nullopt);
    EXPECT_FALSE(after.offer_draw);
    EXPECT_FALSE(after.offer_replay);
    EXPECT_EQ(after.answer, std::nullopt) << "one's own offer";
}

TEST(Offered, AnOfferOfTheOpponentsIsToBeAnswered) {
    match::MatchState match = broken();
    match.offer = {.kind = match::OfferKind::Stalemate, .by = Seat::Second};
    EXPECT_EQ(offered_to(table_of(match)).answer, match::OfferKind::Stalemate);
}

TEST(Offered, ARackThatIsNotBrokenHasNoStalemate) {
    const Offered offered = offered_to(table_of(started()));
    EXPECT_FALSE(offered.offer_replay);
    EXPECT_FALSE(offered.claim_stalemate);
    EXPECT_TRUE(offered.offer_draw);
}

TEST(Offered, TwoAtOneScreenAgreeWithoutOffers) {
    const TableView table = table_of(broken(), {Seat::First, Seat::Second});
    EXPECT_FALSE(offered_to(table).offer_draw);
    EXPECT_FALSE(offered_to(table).offer_replay);
    EXPECT_TRUE(offered_to(table).claim_stalemate);
}

TEST(Offered, TheMatchMayBeClaimedFromTheMomentTheServerSays) {
    TableView table = table_of(broken(Seat::Second));
    table.row.seats[Seat::Second].connected = false;
    EXPECT_FALSE(offered_to(table, std::nullopt).claim_match);
    const auto now_us = told::kNow.time_since_epoch().count();
    table.row.seats[Seat::Second].claimable_us = now_us + kSecond_us;
    EXPECT_FALSE(offered_to(table, std::nullopt).claim_match);
    EXPECT_TRUE(offered_to(table, std::nullopt, told::kNow + std::chrono::seconds(1)).claim_match);
}

TEST(Offered, WhoIsAwayHimselfClaimsNothing) {
    TableView table = table_of(broken());
    table.row.seats[Seat::First].claimable_us = 0;
    EXPECT_FALSE(offered_to(table).claim_match);
}

TEST(Offered, ARematchIsOfferedBetweenTheSameTwoAndOtherwiseAStart) {
    TableView table = table_of(broken());
    table.match->stage = match::Stage::Over;
    EXPECT_TRUE(offered_to(table).start);
    table.over = protocol::server::MatchOver{};
    table.players_of_match = {{"Ada#12ab", "Grace#3f21"}};
    EXPECT_TRUE(offered_to(table).rematch);
    EXPECT_FALSE(offered_to(table).start);
    table.row.seats[Seat::Second].name = "Mary#0001";
    EXPECT_FALSE(offered_to(table).rematch);
    EXPECT_TRUE(offered_to(table).start);
}

TEST(Offered, CallsThatTheGameDoesNotKnowAreNotOffered) {
    EXPECT_TRUE(offered_to(table_of(broken())).safety);
    EXPECT_FALSE(offered_to(table_of(broken())).push_out);
    match::MatchState nine = started(rules::Game::NineBall);
    nine.to_act = nine.rack.shooter = Seat::First;
    nine.rack.phase = rules::Phase::AfterBreak;
    nine.rack.push_out_allowed = true;
    EXPECT_TRUE(offered_to(table_of(nine)).push_out);
}

TEST(Offered, TheNearestBallIsSpottedWhereNoLegalOneCanBeShotAt) {
    match::MatchState match = broken();
    match.rack.in_hand = rules::Zone::BehindHeadString;
    EXPECT_FALSE(offered_to(table_of(match)).spot_nearest);
    match.rack.behind_head_string = match.rack.on_table;
    EXPECT_TRUE(offered_to(table_of(match)).spot_nearest);
    EXPECT_FALSE(offered_to(table_of(match), std::nullopt).spot_nearest);
}

TEST(Offered, NoShotIsOfferedWhileAChoiceIsDue) {
    match::MatchState match = broken();
    EXPECT_TRUE(offered_to(table_of(match)).shoot);
    match.stage = match::Stage::Choosing;
    EXPECT_FALSE(offered_to(table_of(match)).shoot);
    EXPECT_FALSE(offered_to(table_of(match)).safety);
}

TEST(Offered, PracticeIsOfferedInPracticeAlone) {
    const TableView practice =
        table_of(started(rules::Game::Practice), {Seat::First, Seat::Second});
    EXPECT_TRUE(offered_to(practice).practise);
    EXPECT_FALSE(offered_to(practice).repeat) << "no shot yet";
    EXPECT_FALSE(offered_to(practice).extension);
    EXPECT_FALSE(offered_to(table_of(broken())).practise);
}

TEST(Offered, TheOwnerIsWhoIsNamedAtTheTable) {
    TableView table = table_of(broken());
    EXPECT_FALSE(is_owner(known(), table));
    table.row.owner = "Ada#12ab";
    EXPECT_TRUE(is_owner(known(), table));
    table.row.owner.clear();
    EXPECT_FALSE(is_owner(ClientState{}, table)) << "nobody is no owner";
}

}  // namespace
}  // namespace billiards::client
