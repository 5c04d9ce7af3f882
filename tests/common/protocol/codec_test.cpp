// Shows that what one side says is what the other side hears: every message, every field.
#include "common/protocol/codec.h"

#include "common/protocol/codec_journal.h"
#include "common/protocol/framing.h"
#include "tests/common/protocol/generators.h"
#include "tests/common/protocol/samples.h"

#include <cmath>
#include <cstring>
#include <gtest/gtest.h>
#include <limits>
#include <rapidcheck/gtest.h>
#include <set>
#include <variant>

namespace billiards::protocol {
namespace {

template <class T>
std::set<std::size_t> kinds_of(const std::vector<Sample<T>>& samples, auto variant_of) {
    std::set<std::size_t> kinds;
    for (const Sample<T>& sample : samples) kinds.insert(variant_of(sample.value).index());
    return kinds;
}

TEST(Samples, HaveEveryKindOfMessage) {
    EXPECT_EQ(kinds_of(client_samples(), [](const auto& m) { return m.body; }).size(),
              std::variant_size_v<ClientMessageBody>);
    EXPECT_EQ(kinds_of(server_samples(), [](const auto& m) { return m; }).size(),
              std::variant_size_v<ServerMessage>);
    EXPECT_EQ(kinds_of(journal_samples(), [](const auto& e) { return e.command; }).size(),
              std::variant_size_v<match::Command>);
}

TEST(Codec, GivesBackEverySample) {
    for (const auto& [name, message] : client_samples()) {
        const auto decoded = decode_client(content_of(encode(message)));
        ASSERT_TRUE(decoded.ok()) << name << ": " << decoded.error().detail;
        EXPECT_EQ(*decoded, message) << name;
    }
    for (const auto& [name, message] : server_samples()) {
        const auto decoded = decode_server(content_of(encode(message)));
        ASSERT_TRUE(decoded.ok()) << name << ": " << decoded.error().detail;
        EXPECT_EQ(*decoded, message) << name;
    }
}

RC_GTEST_PROP(Codec, GivesBackAnyClientMessage, ()) {
    const ClientMessage message = *any_client_message();
    const auto decoded = decode_client(content_of(encode(message)));
    RC_ASSERT(decoded.ok());
    RC_ASSERT(*decoded == message);
}

RC_GTEST_PROP(Codec, GivesBackAnyServerMessage, ()) {
    const ServerMessage message = *any_server_message();
    const auto decoded = decode_server(content_of(encode(message)));
    RC_ASSERT(decoded.ok());
    RC_ASSERT(*decoded == message);
}

RC_GTEST_PROP(Codec, GivesBackAnyJournalEntry, ()) {
    const JournalEntry entry = *any_journal_entry();
    const auto decoded = decode_entry(encode_entry(entry));
    RC_ASSERT(decoded.ok());
    RC_ASSERT(*decoded == entry);
}

TEST(Codec, GivesBackEveryJournalSampleAndTheSettings) {
    for (const auto& [name, entry] : journal_samples()) {
        const auto decoded = decode_entry(encode_entry(entry));
        ASSERT_TRUE(decoded.ok()) << name << ": " << decoded.error().detail;
        EXPECT_EQ(*decoded, entry) << name;
    }
    const StoredSettings stored = sample_settings();
    const auto decoded = decode_settings(encode_settings(stored.settings, stored.seed));
    ASSERT_TRUE(decoded.ok());
    EXPECT_EQ(decoded->settings, stored.settings);
    EXPECT_EQ(decoded->seed, stored.seed);
}

TEST(Codec, LeavesAnAbsentOutcomeOfTheJournalEmpty) {
    JournalEntry entry;
    entry.command = match::Concede{};
    const EncodedEntry encoded = encode_entry(entry);
    EXPECT_FALSE(encoded.command.empty());
    EXPECT_TRUE(encoded.verdict.empty());
    EXPECT_TRUE(encoded.final_layout.empty());
    EXPECT_TRUE(encoded.record.empty());
}

TEST(Codec, NeverSendsTheSeedOfAMatch) {
    server::MatchStarted started;
    started.state.seed = 0x1122334455667788U;
    const SharedFrame frame = encode(ServerMessage{started});
    const std::uint8_t secret[] = {0x88, 0x77, 0x66, 0x55, 0x44, 0x33, 0x22, 0x11};
    EXPECT_EQ(memmem(frame->data(), frame->size(), secret, sizeof(secret)), nullptr);
}

TEST(Codec, WritesTheLengthBeforeTheMessage) {
    for (const auto& [name, message] : server_samples()) {
        const SharedFrame frame = encode(message);
        const auto length =
            decode_frame_header(std::span(*frame).first<kFrameHeaderBytes>(), kMaxServerFrameBytes);
        ASSERT_TRUE(length.ok()) << name;
        EXPECT_EQ(*length, frame->size() - kFrameHeaderBytes) << name;
    }
}

TEST(Codec, ReadsAFrameAtAnyAlignment) {
    const ServerMessage message = server_samples().back().value;
    const SharedFrame frame = encode(message);
    for (std::size_t offset = 0; offset < 8; ++offset) {
        std::vector<std::byte> moved(offset);
        moved.insert(moved.end(), content_of(frame).begin(), content_of(frame).end());
        const auto decoded = decode_server(std::span(moved).subspan(offset));
        ASSERT_TRUE(decoded.ok());
        EXPECT_EQ(*decoded, message);
    }
}

TEST(Codec, LeavesNumbersOfAClientsShotForTheMatchToRefuse) {
    for (const double number : {std::numeric_limits<double>::quiet_NaN(),
                                std::numeric_limits<double>::infinity(), -1e300}) {
        client::TakeShot take;
        take.shot = {.angle_rad = number, .power = number};
        const auto decoded = decode_client(content_of(encode({1, take})));
        ASSERT_TRUE(decoded.ok());
        const auto& shot = std::get<client::TakeShot>(decoded->body).shot;
        EXPECT_EQ(std::isnan(shot.angle_rad), std::isnan(number));
        EXPECT_EQ(std::isfinite(shot.power), std::isfinite(number));
    }
}

TEST(Codec, LeavesSettingsOfAClientForTheMatchToRefuse) {
    client::CreateTable create;
    create.settings.race_to = -7;
    create.settings.shot_clock_s = 1e9;
    const auto decoded = decode_client(content_of(encode({1, create})));
    ASSERT_TRUE(decoded.ok());
    EXPECT_EQ(std::get<client::CreateTable>(decoded->body), create);
}

TEST(Codec, ClipsADetailThatIsTooLongBetweenTwoCodePoints) {
    server::Notice notice{.detail = std::string(kMaxDetailLength - 1, 'x') + "é"};
    const auto decoded = decode_server(content_of(encode(ServerMessage{notice})));
    ASSERT_TRUE(decoded.ok());
    EXPECT_EQ(std::get<server::Notice>(*decoded).detail, std::string(kMaxDetailLength - 1, 'x'));
}

TEST(Codec, FitsTheGreetingAndTheLongestRequestsIntoTheirFrames) {
    std::string name;
    for (std::size_t i = 0; i < kMaxNameLength; ++i) name += "🎱";
    EXPECT_LE(content_of(encode({1, client::Hello{name, ResumeToken{}}})).size(),
              kMaxGreetingFrameBytes);
    std::string chat;
    for (std::size_t i = 0; i < kMaxChatLength; ++i) chat += "🎱";
    EXPECT_LE(content_of(encode({1, client::Chat{chat}})).size(), kMaxClientFrameBytes);
}

TEST(Codec, FitsTheLongestTableListIntoAFrame) {
    std::string name;
    for (std::size_t i = 0; i < kMaxTableNameLength; ++i) name += "🎱";
    server::TableRow row;
    row.name = name;
    for (const model::Seat seat : model::kSeats) {
        row.seats[seat].name = name.substr(0, 4 * kMaxShownNameLength);
    }
    const ServerMessage list = server::TableList{std::vector(kMaxTableRows, row)};
    const SharedFrame frame = encode(list);
    EXPECT_LE(content_of(frame).size(), kMaxServerFrameBytes);
    EXPECT_TRUE(decode_server(content_of(frame)).ok());
}

}  // namespace
}  // namespace billiards::protocol
