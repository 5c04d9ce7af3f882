// Takes any bytes; gives back nothing, but ends the program where a decoder does what it must not.
#include "tests/fuzz/decode_anything.h"

#include "common/base/check.h"
#include "common/protocol/codec.h"
#include "common/protocol/codec_journal.h"
#include "common/protocol/framing.h"
#include "common/protocol/packing.h"
#include "common/protocol/text.h"
#include "common/replay/block_chain.h"
#include "common/replay/play.h"
#include "common/replay/replay_file.h"
#include "common/timeline/evaluate.h"

#include <cmath>
#include <string_view>

namespace billiards::fuzz {

namespace {

using namespace protocol;

std::span<const std::byte> content_of(const SharedFrame& frame) {
    return std::span<const std::byte>(*frame).subspan(kFrameHeaderBytes);
}

void play(const timeline::ShotRecord& record) {
    for (const timeline::BallTrack& track : record.timeline.tracks) {
        for (const double time_s : {0.0, record.duration_s / 2, record.duration_s}) {
            const base::Vec3 position = timeline::evaluate(track, time_s).position_m;
            CHECK(std::isfinite(position.x + position.y + position.z));
        }
    }
}

void play(const ServerMessage& message) {
    if (const auto* played = std::get_if<server::ShotPlayed>(&message)) play(played->record);
    const auto* snapshot = std::get_if<server::TableSnapshot>(&message);
    if (snapshot != nullptr && snapshot->rolling) play(snapshot->rolling->record);
    const auto* chunk = std::get_if<server::ReplayChunk>(&message);
    if (chunk == nullptr) return;
    for (const std::vector<std::byte>& step : chunk->messages) {
        const auto told = decode_server(step);
        const auto* played = told ? std::get_if<server::ShotPlayed>(&*told) : nullptr;
        if (played != nullptr) play(played->record);
    }
}

/// Bytes are compared, and not values: a client's shot may hold a NaN.
template <class Message>
void check_that_it_settles(const Message& message, auto decode) {
    const SharedFrame once = encode(message);
    const auto again = decode(content_of(once));
    CHECK(again.ok());
    CHECK(*encode(*again) == *once);
}

void decode_columns(std::span<const std::byte> bytes) {
    const Bytes column(bytes.begin(), bytes.end());
    JournalEntry plain;
    const Bytes command = encode_entry(plain).command;
    for (const EncodedEntry& columns :
         {EncodedEntry{column, {}, {}, {}}, EncodedEntry{command, column, {}, {}},
          EncodedEntry{command, {}, column, {}}, EncodedEntry{command, {}, {}, column}}) {
        const auto entry = decode_entry(columns);
        if (!entry) continue;
        if (entry->record) play(*entry->record);
        const auto again = decode_entry(encode_entry(*entry));
        CHECK(again.ok());
    }
}

void decode_around_messages(std::span<const std::byte> bytes) {
    if (bytes.size() >= kPreambleBytes) {
        static_cast<void>(decode_preamble(bytes.first<kPreambleBytes>()));
    }
    if (bytes.size() >= kFrameHeaderBytes) {
        static_cast<void>(
            decode_frame_header(bytes.first<kFrameHeaderBytes>(), kMaxServerFrameBytes));
    }
    const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    const auto clean = clean_text(text, kMaxChatLength);
    CHECK(!clean || clean_text(*clean, kMaxChatLength) == clean);
}

void open_replay(std::span<const std::byte> bytes) {
    const auto opened = replay::from_bytes(bytes);
    if (!opened) return;
    for (const JournalEntry& entry : opened->replay.entries) {
        if (entry.record) play(*entry.record);
    }
    static_cast<void>(replay::play(opened->replay, [](const replay::Moment&) {}));
    const auto again = replay::to_bytes(opened->replay);
    CHECK(again.ok() && replay::from_bytes(*again)->replay == opened->replay);
}

/// As a file, and as the content of a file whose checks are right.
void open_replays(std::span<const std::byte> bytes) {
    open_replay(bytes);
    static const Bytes whole = replay::to_bytes(replay::Replay{}).value();
    const auto start = std::span(whole).first<replay::kStartBytes>();
    replay::BlockReader reader(whole, replay::kStartBytes);
    const replay::Block header = reader.next().value();
    for (const bool is_header : {false, true}) {
        replay::BlockWriter writer(start);
        if (!is_header) writer.add(header);
        writer.add({.kind = is_header ? 1U : 2U, .content = bytes});
        open_replay(writer.bytes());
    }
}

}  // namespace

void decode_anything(std::span<const std::byte> bytes) {
    if (const auto message = decode_client(bytes)) check_that_it_settles(*message, decode_client);
    if (const auto message = decode_server(bytes)) {
        play(*message);
        check_that_it_settles(*message, decode_server);
    }
    decode_columns(bytes);
    static_cast<void>(decode_settings(bytes));
    static_cast<void>(unpacked(bytes, kMaxServerFrameBytes));
    open_replays(bytes);
    decode_around_messages(bytes);
}

}  // namespace billiards::fuzz
