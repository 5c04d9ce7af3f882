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

// ---- From the journal

match::Command read_command(wire::Command::Reader in) {
    const model::TurnNumber turn{in.getTurn()};
    switch (in.which()) {
        case wire::Command::PLACE_CUE_BALL: {
            const auto place = in.getPlaceCueBall();
            return match::PlaceCueBall{
                {finite(place.getXM(), "position_m"), finite(place.getYM(), "position_m")}};
        }
        case wire::Command::TAKE_SHOT: {
            const auto take = in.getTakeShot();
            return match::TakeShot{turn, finite(read(take.getShot())), read(take.getCall())};
        }
        case wire::Command::CHOOSE:
            return match::Choose{turn, from_wire<rules::Choice>(in.getChoose(), "choice")};
        case wire::Command::TIMEOUT:
            return match::Timeout{turn};
        case wire::Command::CONCEDE:
            return match::Concede{};
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
