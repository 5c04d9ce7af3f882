// Takes and gives settings, rulings and matches on the wire.
#include "common/protocol/codec_match.h"

#include "common/protocol/codec_model.h"

#include <cmath>
#include <cstddef>
#include <vector>

namespace billiards::protocol {

namespace {

constexpr std::size_t kMaxFouls = 16;
constexpr std::size_t kMaxChoices = 16;

template <class List, class Enum>
void write_enums(List out, const std::vector<Enum>& values) {
    for (unsigned int i = 0; i < out.size(); ++i) out.set(i, to_wire(values[i]));
}

template <class Enum, class List>
std::vector<Enum> read_enums(List in, std::size_t max_size, std::string_view field) {
    std::vector<Enum> values;
    values.reserve(at_most(in, max_size, field).size());
    for (const auto value : in) values.push_back(from_wire<Enum>(value, field));
    return values;
}

template <class Union>
void write_groups(Union out, const std::optional<model::PerSeat<rules::Group>>& groups) {
    if (!groups) return;
    auto set = out.initSet();
    set.setFirst(to_wire((*groups)[model::Seat::First]));
    set.setSecond(to_wire((*groups)[model::Seat::Second]));
}

template <class Union>
std::optional<model::PerSeat<rules::Group>> read_groups(Union in) {
    if (in.isNone()) return std::nullopt;
    if (!in.isSet()) fail(DecodeErrorCode::UnknownKind, "groups");
    const auto set = in.getSet();
    return model::PerSeat<rules::Group>{{from_wire<rules::Group>(set.getFirst(), "groups"),
                                         from_wire<rules::Group>(set.getSecond(), "groups")}};
}

void write_balls(capnp::List<std::uint8_t>::Builder out, const std::vector<model::BallId>& balls) {
    for (unsigned int i = 0; i < out.size(); ++i) out.set(i, balls[i].number);
}

std::vector<model::BallId> read_balls(capnp::List<std::uint8_t>::Reader in,
                                      std::string_view field) {
    std::vector<model::BallId> balls;
    balls.reserve(at_most(in, model::kMaxBalls, field).size());
    for (const std::uint8_t number : in) balls.push_back(ball_id(number));
    return balls;
}

model::BallSet ball_set(std::uint32_t bits, std::string_view field) {
    const model::BallSet set = model::BallSet::from_bits(bits);
    return require(set.bits() == bits, field), set;
}

unsigned int size_of(const auto& values) {
    return static_cast<unsigned int>(values.size());
}

}  // namespace

void write(wire::Settings::Builder out, const match::Settings& settings) {
    out.setGame(to_wire(settings.game));
    out.setCall(settings.options.call);
    out.setTable(to_wire(settings.table));
    out.setPhysics(to_wire(settings.physics));
    out.setBreakOrder(to_wire(settings.break_order));
    out.setRaceTo(settings.race_to);
    out.setShotClockS(settings.shot_clock_s);
    out.setBreakShotClockS(settings.break_shot_clock_s);
    out.setNineOnFootSpot(settings.options.nine_on_foot_spot);
    out.setTenWinsAnyTime(settings.options.ten_wins_any_time);
    out.setTargetPoints(settings.options.target_points);
    out.setExtensionS(settings.extension_s);
    out.setAimHelp(settings.aim_help);
    out.setSpectatorDelayS(settings.spectator_delay_s);
}

match::Settings read(wire::Settings::Reader in) {
    return {.game = from_wire<rules::Game>(in.getGame(), "game"),
            .options = {.call = in.getCall(),
                        .nine_on_foot_spot = in.getNineOnFootSpot(),
                        .ten_wins_any_time = in.getTenWinsAnyTime(),
                        .target_points = in.getTargetPoints()},
            .table = from_wire<model::TableSize>(in.getTable(), "table"),
            .physics = from_wire<match::PhysicsPreset>(in.getPhysics(), "physics"),
            .break_order = from_wire<match::BreakOrder>(in.getBreakOrder(), "break_order"),
            .race_to = in.getRaceTo(),
            .shot_clock_s = in.getShotClockS(),
            .break_shot_clock_s = in.getBreakShotClockS(),
            .extension_s = in.getExtensionS(),
            .aim_help = in.getAimHelp(),
            .spectator_delay_s = in.getSpectatorDelayS()};
}

match::Settings accepted_settings(wire::Settings::Reader in) {
    const match::Settings settings = read(in);
    const auto accepted = match::check(settings);
    if (!accepted) fail(DecodeErrorCode::OutOfBounds, accepted.error().detail);
    return settings;
}

void write(wire::RackState::Builder out, const rules::RackState& rack) {
    out.setPhase(to_wire(rack.phase));
    out.setShooter(to_wire(rack.shooter));
    write_groups(out.getGroups(), rack.groups);
    out.setOnTable(rack.on_table.bits());
    out.setInHand(to_wire(rack.in_hand));
    out.setBehindHeadString(rack.behind_head_string.bits());
    write_counts(out.getConsecutiveFouls(), rack.consecutive_fouls);
    out.setPushOutAllowed(rack.push_out_allowed);
    write_scores(out.getScores(), rack.scores);
}

rules::RackState read(wire::RackState::Reader in) {
    return {.phase = from_wire<rules::Phase>(in.getPhase(), "phase"),
            .shooter = from_wire<model::Seat>(in.getShooter(), "shooter"),
            .groups = read_groups(in.getGroups()),
            .on_table = ball_set(in.getOnTable(), "on_table"),
            .in_hand = from_wire<rules::Zone>(in.getInHand(), "in_hand"),
            .behind_head_string = ball_set(in.getBehindHeadString(), "behind_head_string"),
            .consecutive_fouls = read_counts(in.getConsecutiveFouls(), "consecutive_fouls"),
            .push_out_allowed = in.getPushOutAllowed(),
            .scores = read_scores(in.getScores(), "scores")};
}

void write(wire::Verdict::Builder out, const rules::Verdict& verdict) {
    write_enums(out.initFouls(size_of(verdict.fouls)), verdict.fouls);
    out.setTurnContinues(verdict.turn_continues);
    out.setNextPlayer(to_wire(verdict.next_player));
    out.setInHand(to_wire(verdict.in_hand));
    write_enums(out.initChoices(size_of(verdict.choices)), verdict.choices);
    write_seat(out.getChooser(), verdict.chooser);
    write_groups(out.getGroups(), verdict.groups);
    write_balls(out.initSpotted(size_of(verdict.spotted)), verdict.spotted);
    write_seat(out.getWinner(), verdict.winner);
    write_counts(out.getConsecutiveFouls(), verdict.consecutive_fouls);
    out.setReason(to_wire(verdict.reason));
    out.setPhase(to_wire(verdict.phase));
    write_scores(out.getScoreChange(), verdict.score_change);
    out.setRerack(to_wire(verdict.rerack));
}

rules::Verdict read(wire::Verdict::Reader in) {
    return {.fouls = read_enums<rules::Foul>(in.getFouls(), kMaxFouls, "fouls"),
            .turn_continues = in.getTurnContinues(),
            .next_player = from_wire<model::Seat>(in.getNextPlayer(), "next_player"),
            .in_hand = from_wire<rules::Zone>(in.getInHand(), "in_hand"),
            .choices = read_enums<rules::Choice>(in.getChoices(), kMaxChoices, "choices"),
            .chooser = read_seat(in.getChooser(), "chooser"),
            .groups = read_groups(in.getGroups()),
            .spotted = read_balls(in.getSpotted(), "spotted"),
            .winner = read_seat(in.getWinner(), "winner"),
            .consecutive_fouls = read_counts(in.getConsecutiveFouls(), "consecutive_fouls"),
            .reason = from_wire<rules::Reason>(in.getReason(), "reason"),
            .phase = from_wire<rules::Phase>(in.getPhase(), "phase"),
            .score_change = read_scores(in.getScoreChange(), "score_change"),
            .rerack = from_wire<rules::Rerack>(in.getRerack(), "rerack")};
}

void write(wire::MatchState::Builder out, const match::MatchState& state) {
    write(out.initSettings(), state.settings);
    out.setStage(to_wire(state.stage));
    out.setTurn(state.turn.value);
    out.setToAct(to_wire(state.to_act));
    out.setRackNumber(to_count(state.rack_number));
    out.setBreaker(to_wire(state.breaker));
    write_counts(out.getRacksWon(), state.racks_won);
    out.setShotsPlayed(to_count(state.shots_played));
    write(out.initRack(), state.rack);
    write(out.initLayout(), state.layout);
    if (state.pending) {
        auto choice = out.getPending().initChoice();
        write(choice.initVerdict(), state.pending->verdict);
        write(choice.initBefore(), state.pending->before);
    }
    write_seat(out.getWinner(), state.winner);
    out.getExtendedIn().setFirst(state.extended_in[model::Seat::First].value);
    out.getExtendedIn().setSecond(state.extended_in[model::Seat::Second].value);
    if (state.offer) {
        auto made = out.getOffer().initMade();
        made.setKind(to_wire(state.offer->kind));
        made.setBy(to_wire(state.offer->by));
    }
    if (state.claim) write_counts(out.getClaim().initTurns(), *state.claim);
}

namespace {

std::optional<match::MatchState::StandingOffer> read_offer(wire::MatchState::Offer::Reader in) {
    switch (in.which()) {
        case wire::MatchState::Offer::NONE:
            return std::nullopt;
        case wire::MatchState::Offer::MADE:
            return match::MatchState::StandingOffer{
                .kind = from_wire<match::OfferKind>(in.getMade().getKind(), "offer"),
                .by = from_wire<model::Seat>(in.getMade().getBy(), "offer")};
    }
    fail(DecodeErrorCode::UnknownKind, "offer");
}

std::optional<model::PerSeat<int>> read_claim(wire::MatchState::Claim::Reader in) {
    switch (in.which()) {
        case wire::MatchState::Claim::NONE:
            return std::nullopt;
        case wire::MatchState::Claim::TURNS:
            return read_counts(in.getTurns(), "claim");
    }
    fail(DecodeErrorCode::UnknownKind, "claim");
}

std::optional<match::MatchState::Pending> read_pending(wire::MatchState::Pending::Reader in) {
    switch (in.which()) {
        case wire::MatchState::Pending::NONE:
            return std::nullopt;
        case wire::MatchState::Pending::CHOICE:
            return match::MatchState::Pending{.verdict = read(in.getChoice().getVerdict()),
                                              .before = read(in.getChoice().getBefore())};
    }
    fail(DecodeErrorCode::UnknownKind, "pending");
}

}  // namespace

match::MatchState read(wire::MatchState::Reader in) {
    return {.settings = accepted_settings(in.getSettings()),
            .seed = 0,
            .stage = from_wire<match::Stage>(in.getStage(), "stage"),
            .turn = model::TurnNumber{in.getTurn()},
            .to_act = from_wire<model::Seat>(in.getToAct(), "to_act"),
            .rack_number = count(in.getRackNumber(), "rack_number"),
            .breaker = from_wire<model::Seat>(in.getBreaker(), "breaker"),
            .racks_won = read_counts(in.getRacksWon(), "racks_won"),
            .shots_played = count(in.getShotsPlayed(), "shots_played"),
            .rack = read(in.getRack()),
            .layout = read(in.getLayout()),
            .pending = read_pending(in.getPending()),
            .winner = read_seat(in.getWinner(), "winner"),
            .extended_in = {{model::TurnNumber{in.getExtendedIn().getFirst()},
                             model::TurnNumber{in.getExtendedIn().getSecond()}}},
            .offer = read_offer(in.getOffer()),
            .claim = read_claim(in.getClaim()),
            .undo = {},
            .before_shot = {}};
}

}  // namespace billiards::protocol
