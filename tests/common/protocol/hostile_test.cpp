// Shows that whatever the bytes are, a decoder gives a value or says what is wrong, and reserves
// nothing that they only claim.
#include "common/protocol/codec.h"
#include "common/protocol/limits.h"
#include "tests/common/protocol/samples.h"

#include <algorithm>
#include <cstring>
#include <functional>
#include <gtest/gtest.h>
#include <limits>

namespace billiards::protocol {
namespace {

using Words = std::vector<std::uint64_t>;

/// One segment with its table.
std::vector<std::byte> message_of(const Words& segment) {
    Words words{std::uint64_t{segment.size()} << 32U};
    words.insert(words.end(), segment.begin(), segment.end());
    std::vector<std::byte> bytes(8 * words.size());
    std::memcpy(bytes.data(), words.data(), bytes.size());
    return bytes;
}

std::vector<std::byte> copy_of(std::span<const std::byte> bytes) {
    return {bytes.begin(), bytes.end()};
}

// ---- The envelope

TEST(HostileFrame, ThatIsNotOneWholeSegmentIsMalformed) {
    const auto good = copy_of(content_of(encode(ClientMessage{1, client::Ping{7}})));
    ASSERT_TRUE(decode_client(good).ok());
    auto too_long = good;
    too_long.resize(good.size() + 8);
    auto too_short = good;
    too_short.resize(good.size() - 8);
    auto odd = good;
    odd.resize(good.size() - 3);
    auto two_segments = good;
    two_segments[0] = std::byte{1};
    auto four_billion_segments = good;
    for (int i = 0; i < 4; ++i)
        four_billion_segments[static_cast<std::size_t>(i)] = std::byte{0xff};
    for (const auto& bytes :
         {too_long, too_short, odd, two_segments, four_billion_segments, std::vector<std::byte>(),
          std::vector<std::byte>(8), std::vector<std::byte>(3)}) {
        const auto decoded = decode_client(bytes);
        ASSERT_FALSE(decoded.ok());
        EXPECT_EQ(decoded.error().code, DecodeErrorCode::Malformed);
    }
}

TEST(HostileFrame, WithAPointerOutsideIsMalformed) {
    // The root: a struct of 1 + 1 words, 1,000 words further on.
    const auto decoded = decode_client(message_of({0x0001000100000000U | 1000U << 2U, 0, 0}));
    ASSERT_FALSE(decoded.ok());
    EXPECT_EQ(decoded.error().code, DecodeErrorCode::Malformed);
}

// ---- Newer minor versions

TEST(HostileFrame, OfANewerKindIsUnknown) {
    constexpr std::size_t kClientKindAt = 8 + 8 + 4;  // After the table, the root, request_id.
    auto from_client = copy_of(content_of(encode(ClientMessage{1, client::Leave{}})));
    from_client[kClientKindAt] = std::byte{200};
    const auto client_message = decode_client(from_client);
    ASSERT_FALSE(client_message.ok());
    EXPECT_EQ(client_message.error().code, DecodeErrorCode::UnknownKind);

    constexpr std::size_t kServerKindAt = 8 + 8;
    auto from_server = copy_of(content_of(encode(ServerMessage{server::Pong{}})));
    from_server[kServerKindAt] = std::byte{200};
    const auto server_message = decode_server(from_server);
    ASSERT_FALSE(server_message.ok());
    EXPECT_EQ(server_message.error().code, DecodeErrorCode::UnknownKind);
}

TEST(HostileFrame, WithANewerEnumerantIsUnknown) {
    const auto player =
        copy_of(content_of(encode(ClientMessage{1, client::Join{TableId{9}, Role::Player}})));
    auto changed =
        copy_of(content_of(encode(ClientMessage{1, client::Join{TableId{9}, Role::Spectator}})));
    const auto at = std::mismatch(player.begin(), player.end(), changed.begin()).second;
    *at = std::byte{77};
    const auto decoded = decode_client(changed);
    ASSERT_FALSE(decoded.ok());
    EXPECT_EQ(decoded.error(), (DecodeError{DecodeErrorCode::UnknownKind, "role"}));
}

// ---- Sizes that are only claimed

constexpr std::uint64_t kTableListKind = 2;
constexpr std::uint64_t kRootOfAServerMessage = 0x0001000100000000U;  // 1 word, 1 pointer.
constexpr std::uint64_t kTableListOfOnePointer = 0x0001000000000000U;

TEST(HostileFrame, ThatClaimsAnEnormousListOfNothingIsRefused) {
    for (const std::uint64_t rows : {std::uint64_t{1001}, std::uint64_t{1} << 28U}) {
        const std::uint64_t list_of_structs = 1U | 7ULL << 32U;  // No words of content at all.
        const std::uint64_t tag = rows << 2U;                    // Structs of no size.
        const auto decoded = decode_server(message_of(
            {kRootOfAServerMessage, kTableListKind, kTableListOfOnePointer, list_of_structs, tag}));
        ASSERT_FALSE(decoded.ok()) << rows;
    }
}

constexpr std::uint64_t kHistoryPageKind = 19;
constexpr std::uint64_t kReplayChunkKind = 21;

/// A page of rows of a single word each; a chunk of messages without a byte.
std::vector<std::byte> page_of(std::uint64_t rows) {
    Words words{kRootOfAServerMessage,          kHistoryPageKind,
                1ULL << 32U | 1ULL << 48U,      0,
                1U | 7ULL << 32U | rows << 35U, rows << 2U | 1ULL << 32U};
    words.resize(words.size() + std::min(rows, std::uint64_t{1000}));
    return message_of(words);
}

std::vector<std::byte> chunk_of(std::uint64_t messages) {
    Words words{kRootOfAServerMessage,
                kReplayChunkKind,
                3ULL << 32U | 1ULL << 48U,
                7,
                0,
                0,
                1U | 6ULL << 32U | messages << 35U};
    words.resize(words.size() + std::min(messages, std::uint64_t{1000}));
    return message_of(words);
}

TEST(HostileFrame, WithMoreRowsOrStepsThanMayBeIsRefused) {
    EXPECT_TRUE(decode_server(page_of(0)).ok());
    EXPECT_TRUE(decode_server(chunk_of(kMaxReplaySteps)).ok());
    for (const std::uint64_t count : {std::uint64_t{1001}, std::uint64_t{1} << 28U}) {
        EXPECT_FALSE(decode_server(page_of(count)).ok()) << count;
        EXPECT_FALSE(decode_server(chunk_of(count)).ok()) << count;
    }
    const auto rows = decode_server(page_of(kMaxHistoryRows + 1));
    ASSERT_FALSE(rows.ok());
    EXPECT_EQ(rows.error(), (DecodeError{DecodeErrorCode::OutOfBounds, "rows"}));
    const auto steps = decode_server(chunk_of(kMaxReplaySteps + 1));
    ASSERT_FALSE(steps.ok());
    EXPECT_EQ(steps.error(), (DecodeError{DecodeErrorCode::OutOfBounds, "messages"}));
}

/// The same message with its 16 secret bytes said to be fewer.
std::vector<std::byte> with_shorter_secret(std::span<const std::byte> good, std::uint64_t bytes) {
    Words words(good.size() / 8);
    std::memcpy(words.data(), good.data(), good.size());
    constexpr std::uint64_t kListOfBytes = 2;
    for (std::uint64_t& word : words) {
        const bool is_secret = (word & 3U) == 1U && word >> 32U == (kListOfBytes | 16U << 3U);
        if (is_secret) word = (word & 0xffffffffU) | (kListOfBytes | bytes << 3U) << 32U;
    }
    std::vector<std::byte> bad(good.size());
    std::memcpy(bad.data(), words.data(), bad.size());
    return bad;
}

TEST(HostileFrame, WithASecretOfAnotherSizeIsRefused) {
    client::Join join;
    join.invite.emplace().fill(7);
    const auto from_client = copy_of(content_of(encode(ClientMessage{1, join})));
    server::InviteMade made;
    made.secret.fill(7);
    const auto from_server = copy_of(content_of(encode(ServerMessage{made})));
    for (const std::uint64_t bytes : {1U, 8U, 15U}) {
        const auto joined = decode_client(with_shorter_secret(from_client, bytes));
        ASSERT_FALSE(joined.ok()) << bytes;
        EXPECT_EQ(joined.error(), (DecodeError{DecodeErrorCode::OutOfBounds, "invite"}));
        const auto invited = decode_server(with_shorter_secret(from_server, bytes));
        ASSERT_FALSE(invited.ok()) << bytes;
        EXPECT_EQ(invited.error(), (DecodeError{DecodeErrorCode::OutOfBounds, "secret"}));
    }
}

/// A list whose rows all have one and the same name and settings, sent once.
std::vector<std::byte> rows_that_share(std::uint64_t rows) {
    std::string name;
    for (std::size_t i = 0; i < kMaxTableNameLength; ++i) name += "🎱";
    const std::uint64_t name_bytes = name.size() + 1;
    const Words settings{0, std::uint64_t{1} << 32U, 0, 0};  // A race to 1.
    Words words{kRootOfAServerMessage, kTableListKind, kTableListOfOnePointer,
                1U | 7ULL << 32U | 2 * rows << 35U, rows << 2U | 2ULL << 48U};
    for (std::uint64_t row = 0; row < rows; ++row) {
        const std::uint64_t to_settings = 2 * (rows - row - 1);
        const std::uint64_t to_name = to_settings + 1 + settings.size();
        words.push_back(1U | to_name << 2U | 2ULL << 32U | name_bytes << 35U);
        words.push_back(to_settings << 2U | settings.size() << 32U);
    }
    words.insert(words.end(), settings.begin(), settings.end());
    const std::size_t text_at = words.size();
    words.resize(text_at + (name_bytes + 7) / 8);
    std::memcpy(&words[text_at], name.data(), name.size());
    return message_of(words);
}

TEST(HostileFrame, MayShareAPartButNotWithoutEnd) {
    const auto three = decode_server(rows_that_share(3));
    ASSERT_TRUE(three.ok()) << three.error().detail;
    EXPECT_EQ(std::get<server::TableList>(*three).tables[2].settings.race_to, 1);
    const auto thousand = decode_server(rows_that_share(kMaxTableRows));
    ASSERT_FALSE(thousand.ok());
    EXPECT_EQ(thousand.error().code, DecodeErrorCode::Malformed);
    EXPECT_NE(thousand.error().detail.find("traversal limit"), std::string::npos);
}

// ---- Values beyond their limits

template <class Message>
struct Change {
    const char* detail;
    std::function<void(Message&)> apply;
};

template <class Message>
void expect_out_of_bounds(const Message& good, const std::vector<Change<Message>>& changes) {
    ASSERT_TRUE(decode_server(content_of(encode(ServerMessage{good}))).ok());
    for (const Change<Message>& change : changes) {
        Message bad = good;
        change.apply(bad);
        const auto decoded = decode_server(content_of(encode(ServerMessage{bad})));
        ASSERT_FALSE(decoded.ok()) << change.detail;
        EXPECT_EQ(decoded.error(), (DecodeError{DecodeErrorCode::OutOfBounds, change.detail}));
    }
}

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

TEST(HostileRecord, IsRefusedWhereItCouldNotBePlayed) {
    using timeline::ShotRecord;
    server::ShotPlayed good;
    good.record = sample_record();
    const auto in_record = [](auto apply) {
        return [apply](server::ShotPlayed& played) { apply(played.record); };
    };
    const auto in_segment = [&](auto apply) {
        return in_record([apply](ShotRecord& r) { apply(r.timeline.tracks[0].segments[2]); });
    };
    expect_out_of_bounds<server::ShotPlayed>(
        good,
        {{"duration_s", in_record([](ShotRecord& r) { r.duration_s = kNaN; })},
         {"duration_s", in_record([](ShotRecord& r) { r.duration_s = -1; })},
         {"duration_s", in_record([](ShotRecord& r) { r.duration_s = kMaxShotDuration_s + 1; })},
         {"times", in_record([](ShotRecord& r) { r.events.back().time_s = kInfinity; })},
         {"times", in_record([](ShotRecord& r) { r.events.front().time_s = -1; })},
         {"events", in_record([](ShotRecord& r) { std::swap(r.events.front(), r.events.back()); })},
         {"events", in_record([](ShotRecord& r) { r.events.resize(kMaxEventsInRecord + 1); })},
         {"ball", in_record([](ShotRecord& r) { r.events[0].ball.number = model::kMaxBalls; })},
         {"other", in_record([](ShotRecord& r) { r.events[1].other = r.events[1].ball; })},
         {"direction", in_record([](ShotRecord& r) { r.events[4].direction = 0; })},
         {"pocket", in_record([](ShotRecord& r) { r.events[6].index = 6; })},
         {"tracks", in_record([](ShotRecord& r) { r.timeline.tracks[1].ball = {}; })},
         {"tracks", in_record([](ShotRecord& r) {
              r.timeline.tracks.resize(model::kMaxBalls + 1, r.timeline.tracks[0]);
          })},
         {"segments", in_record([](ShotRecord& r) { r.timeline.tracks[0].segments.clear(); })},
         {"segments", in_record([](ShotRecord& r) {
              r.timeline.tracks[0].segments.resize(kMaxSegmentsInRecord + 1);
          })},
         {"radius_m", in_record([](ShotRecord& r) { r.timeline.tracks[0].radius_m = kNaN; })},
         {"radius_m", in_record([](ShotRecord& r) { r.timeline.tracks[0].radius_m = 0; })},
         {"start_s",
          in_record([](ShotRecord& r) { r.timeline.tracks[0].segments[0].start_s = 0.05; })},
         {"start_s",
          in_record([](ShotRecord& r) { r.timeline.tracks[0].segments[2].start_s = 0.05; })},
         {"numbers", in_segment([](timeline::Segment& s) { s.position_m.x = kNaN; })},
         {"numbers", in_segment([](timeline::Segment& s) { s.velocity_mps.y = kInfinity; })},
         {"numbers", in_segment([](timeline::Segment& s) { s.spin_radps.z = 1e7; })},
         {"position",
          in_record([](ShotRecord& r) { r.final_layout.balls[0].position_m.x = kNaN; })},
         {"balls",
          in_record([](ShotRecord& r) { r.final_layout.balls.resize(model::kMaxBalls + 1); })},
         {"balls",
          in_record([](ShotRecord& r) { r.final_layout.balls[1] = r.final_layout.balls[0]; })}});
}

TEST(HostileMatch, IsRefusedByTheNameOfItsField) {
    using match::MatchState;
    const auto in_state = [](auto apply) {
        return [apply](server::MatchMoved& moved) { apply(moved.after); };
    };
    server::MatchMoved good;
    good.verdict = rules::Verdict{};
    expect_out_of_bounds<server::MatchMoved>(
        good,
        {{"race_to must be in [1, 50], was 0",
          in_state([](MatchState& s) { s.settings.race_to = 0; })},
         {"shot_clock_s must be in [0, 600], was nan",
          in_state([](MatchState& s) { s.settings.shot_clock_s = kNaN; })},
         {"spectator_delay_s must be in [0, 600], was 1e+09",
          in_state([](MatchState& s) { s.settings.spectator_delay_s = 1e9; })},
         {"claim", in_state([](MatchState& s) {
              s.claim = {{0, kMaxCount + 1}};
          })},
         {"rack_number", in_state([](MatchState& s) { s.rack_number = kMaxCount + 1; })},
         {"racks_won", in_state([](MatchState& s) { s.racks_won.values[1] = kMaxCount + 1; })},
         {"fouls", [](server::MatchMoved& m) { m.verdict->fouls.resize(17); }},
         {"choices", [](server::MatchMoved& m) { m.verdict->choices.resize(17); }},
         {"spotted", [](server::MatchMoved& m) { m.verdict->spotted.resize(23); }},
         {"ball", [](server::MatchMoved& m) { m.verdict->spotted = {model::BallId{22}}; }}});
}

TEST(HostileText, IsRefusedWhereItIsTooLongOrNoText) {
    const std::string longest(kMaxChatLength, 'x');
    expect_out_of_bounds<server::ChatSaid>(
        {"Ada#3f21", longest},
        {{"text", [](server::ChatSaid& said) { said.text += 'x'; }},
         {"text", [](server::ChatSaid& said) { said.text = "\xff"; }},
         {"text", [](server::ChatSaid& said) { said.text = "\xed\xa0\x80"; }},
         {"text", [](server::ChatSaid& said) { said.text = std::string(1 << 20, 'x'); }},
         {"name", [](server::ChatSaid& said) { said.name = std::string(100, 'x'); }}});
}

TEST(HostileTable, IsRefusedWhereItHasTooMuch) {
    expect_out_of_bounds<server::TableSnapshot>(
        {}, {{"your_seats", [](server::TableSnapshot& s) { s.your_seats.resize(3); }},
             {"name", [](server::TableSnapshot& s) { s.row.name = std::string(41, 'x'); }}});
}

TEST(HostileClient, IsRefusedByTheNameOfItsField) {
    const std::string long_passcode(kMaxPasscodeLength + 1, 'x');
    const std::string long_player(kMaxShownNameLength + 1, 'x');
    client::CreateTable create;
    create.passcode = long_passcode;
    client::Join join;
    join.passcode = long_passcode;
    client::ChangeTable change;
    change.passcode = long_passcode;
    const std::vector<std::pair<const char*, ClientMessageBody>> cases = {
        {"passcode", create},
        {"passcode", join},
        {"passcode", change},
        {"name", client::Kick{long_player}},
        {"player", client::AskHistory{long_player, 0}},
        {"player", client::AskRecord{long_player}},
        {"ball", client::PlaceBall{model::BallId{22}, {}}},
        {"name", client::Hello{std::string(kMaxNameLength + 1, 'x'), {}}},
        {"name", client::CreateTable{std::string(kMaxTableNameLength + 1, 'x'), {}, {}}},
        {"text", client::Chat{std::string(kMaxChatLength + 1, 'x')}},
        {"ball", client::TakeShot{{}, 1, {}, model::CalledBall{model::BallId{22}, {}}}},
        {"pocket", client::TakeShot{{}, 1, {}, model::CalledBall{{}, model::PocketId{6}}}},
    };
    for (const auto& [detail, body] : cases) {
        const auto decoded = decode_client(content_of(encode(ClientMessage{1, body})));
        ASSERT_FALSE(decoded.ok()) << detail;
        EXPECT_EQ(decoded.error(), (DecodeError{DecodeErrorCode::OutOfBounds, detail}));
    }
}

}  // namespace
}  // namespace billiards::protocol
