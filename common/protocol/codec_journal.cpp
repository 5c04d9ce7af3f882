// Takes the commands of a match and their outcomes; gives the journal's columns, and back.
#include "common/protocol/codec_journal.h"

#include "common/protocol/codec_enums.h"
#include "common/protocol/codec_match.h"
#include "common/protocol/codec_message.h"
#include "common/protocol/codec_model.h"
#include "common/protocol/codec_record.h"
#include "common/protocol/codec_table.h"
#include "proto/journal.capnp.h"

#include <utility>

namespace billiards::protocol {

namespace {

using Out = wire::Command::Builder;
using protocol::read;
using protocol::write;

// ---- To the journal, one a command

void write(Out out, const match::PlaceCueBall& place) {
    auto body = out.initPlaceCueBall();
    body.setXM(place.position_m.x);
    body.setYM(place.position_m.y);
}

void write(Out out, const match::TakeShot& take) {
    out.setTurn(take.turn.value);
    auto body = out.initTakeShot();
    write(body.initShot(), take.shot);
    write(body.initCall(), take.call);
}

void write(Out out, const match::Choose& choose) {
    out.setTurn(choose.turn.value);
    out.setChoose(to_wire(choose.choice));
}

void write(Out out, const match::Timeout& timeout) {
    out.setTurn(timeout.turn.value);
    out.setTimeout();
}

void write(Out out, const match::Concede&) {
    out.setConcede();
}

void write(Out out, const match::Forfeit&) {
    out.setForfeit();
}

void write(Out out, const match::Extend& extend) {
    out.setTurn(extend.turn.value);
    out.setExtend();
}

void write(Out out, const match::Offer& offer) {
    out.setTurn(offer.turn.value);
    out.setOffer(to_wire(offer.kind));
}

void write(Out out, const match::Answer& answer) {
    out.setTurn(answer.turn.value);
    out.setAnswer(answer.accept);
}

void write(Out out, const match::ClaimStalemate& claim) {
    out.setTurn(claim.turn.value);
    out.setClaimStalemate();
}

void write(Out out, const match::SpotNearest& spot) {
    out.setTurn(spot.turn.value);
    out.setSpotNearest();
}

void write(Out out, const match::PlaceBall& place) {
    auto body = out.initPlaceBall();
    body.setBall(place.ball.number);
    body.setXM(place.position_m.x);
    body.setYM(place.position_m.y);
}

void write(Out out, const match::Undo&) {
    out.setUndo();
}

void write(Out out, const match::Repeat&) {
    out.setRepeat();
}

void write(Out out, const match::Rerack&) {
    out.setRerack();
}

// ---- From the journal

template <class Group>
base::Vec2 position(Group in) {
    return {finite(in.getXM(), "position_m"), finite(in.getYM(), "position_m")};
}

match::TakeShot take_shot(wire::Command::TakeShot::Reader in, model::TurnNumber turn) {
    match::TakeShot take{.turn = turn, .shot = {}, .call = {}};
    take.shot = finite(read(in.getShot()));
    take.call = read(in.getCall());
    return take;
}

match::PlaceBall place_ball(wire::Command::PlaceBall::Reader in) {
    match::PlaceBall place;
    place.ball = ball_id(in.getBall());
    place.position_m = position(in);
    return place;
}

match::Command read_command(wire::Command::Reader in) {
    const model::TurnNumber turn{in.getTurn()};
    switch (in.which()) {
        case wire::Command::PLACE_CUE_BALL:
            return match::PlaceCueBall{position(in.getPlaceCueBall())};
        case wire::Command::TAKE_SHOT:
            return take_shot(in.getTakeShot(), turn);
        case wire::Command::CHOOSE:
            return match::Choose{turn, from_wire<rules::Choice>(in.getChoose(), "choice")};
        case wire::Command::TIMEOUT:
            return match::Timeout{turn};
        case wire::Command::CONCEDE:
            return match::Concede{};
        case wire::Command::FORFEIT:
            return match::Forfeit{};
        case wire::Command::EXTEND:
            return match::Extend{turn};
        case wire::Command::OFFER:
            return match::Offer{turn, from_wire<match::OfferKind>(in.getOffer(), "offer")};
        case wire::Command::ANSWER:
            return match::Answer{turn, in.getAnswer()};
        case wire::Command::CLAIM_STALEMATE:
            return match::ClaimStalemate{turn};
        case wire::Command::SPOT_NEAREST:
            return match::SpotNearest{turn};
        case wire::Command::PLACE_BALL:
            return place_ball(in.getPlaceBall());
        case wire::Command::UNDO:
            return match::Undo{};
        case wire::Command::REPEAT:
            return match::Repeat{};
        case wire::Command::RERACK:
            return match::Rerack{};
    }
    fail(DecodeErrorCode::UnknownKind, "command");
}

JournalEntry read(wire::Command::Reader in) {
    return {.seat = read(in.getSeat()),
            .command = read_command(in),
            .shot_id = in.getShotId(),
            .verdict = {},
            .final_layout = {},
            .record = {}};
}

template <class Root, class Value>
Bytes encode_if(const std::optional<Value>& value) {
    if (!value) return {};
    return encode_root<Root>([&](typename Root::Builder out) { write(out, *value); });
}

/// Fills `value` unless the column is empty; the error, if there is one.
template <class Root, class Value>
std::optional<DecodeError> decode_if(const Bytes& column, std::optional<Value>& value) {
    if (column.empty()) return std::nullopt;
    auto decoded = decode_root<Root>(column, [](typename Root::Reader in) { return read(in); });
    if (!decoded) return std::move(decoded).error();
    value = *std::move(decoded);
    return std::nullopt;
}

}  // namespace

EncodedEntry encode_entry(const JournalEntry& entry) {
    const auto fill = [&](Out out) {
        out.setSeat(to_wire(entry.seat));
        out.setShotId(entry.shot_id);
        std::visit([&](const auto& command) { write(out, command); }, entry.command);
    };
    return {.command = encode_root<wire::Command>(fill),
            .verdict = encode_if<wire::Verdict>(entry.verdict),
            .final_layout = encode_if<wire::Layout>(entry.final_layout),
            .record = encode_if<wire::ShotRecord>(entry.record)};
}

base::Result<JournalEntry, DecodeError> decode_entry(const EncodedEntry& encoded) {
    auto entry = decode_root<wire::Command>(encoded.command,
                                            [](wire::Command::Reader in) { return read(in); });
    if (!entry) return entry;
    if (auto error = decode_if<wire::Verdict>(encoded.verdict, entry->verdict)) return *error;
    if (auto error = decode_if<wire::Layout>(encoded.final_layout, entry->final_layout)) {
        return *error;
    }
    if (auto error = decode_if<wire::ShotRecord>(encoded.record, entry->record)) return *error;
    return entry;
}

Bytes encode_settings(const match::Settings& settings, std::uint64_t seed) {
    return encode_root<wire::StoredSettings>([&](wire::StoredSettings::Builder out) {
        write(out.initSettings(), settings);
        out.setSeed(seed);
    });
}

base::Result<StoredSettings, DecodeError> decode_settings(std::span<const std::byte> bytes) {
    return decode_root<wire::StoredSettings>(bytes, [](wire::StoredSettings::Reader in) {
        return StoredSettings{.settings = accepted_settings(in.getSettings()),
                              .seed = in.getSeed()};
    });
}

bool is_sendable(const timeline::ShotRecord& record) {
    std::size_t segments = 0;
    for (const timeline::BallTrack& track : record.timeline.tracks) {
        segments += track.segments.size();
    }
    return record.events.size() <= kMaxEventsInRecord && segments <= kMaxSegmentsInRecord &&
           record.duration_s <= kMaxShotDuration_s;
}

std::size_t encoded_record_size(const timeline::ShotRecord& record) {
    return encode_root<wire::ShotRecord>([&](wire::ShotRecord::Builder out) { write(out, record); })
        .size();
}

}  // namespace billiards::protocol
