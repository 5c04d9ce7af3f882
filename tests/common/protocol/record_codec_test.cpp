// Shows what a record loses on the wire, which is little and only once, and how long it is.
#include "common/base/elementary.h"
#include "common/base/random.h"
#include "common/match/match.h"
#include "common/physics/simulate.h"
#include "common/protocol/codec_journal.h"
#include "common/protocol/codec_segment.h"
#include "common/rules/ruleset.h"
#include "tests/common/protocol/samples.h"

#include <algorithm>
#include <gtest/gtest.h>

namespace billiards::protocol {
namespace {

using timeline::ShotRecord;

const model::TableSpec& table() {
    return model::table_of(model::TableSize::EightFoot);
}

ShotRecord played(const model::Layout& layout, const model::Shot& shot) {
    auto record = physics::simulate_shot(
        table(), match::parameters_of(match::PhysicsPreset::Realistic), layout, shot);
    return *std::move(record);
}

model::Shot any_shot(base::Random& random, double angle_rad, double low, double high) {
    return {.angle_rad = angle_rad + base::radians(random.uniform(-1, 1)),
            .power = random.uniform(low, high),
            .tip_left = random.uniform(-0.14, 0.14),
            .tip_up = random.uniform(-0.14, 0.14)};
}

/// As the benchmark has them: 8 ft, hard, hardly two alike.
std::vector<ShotRecord> breaks(int number) {
    base::Random random(1);
    std::vector<ShotRecord> records;
    for (int i = 0; i < number; ++i) {
        model::Layout layout = rules::ruleset_of(rules::Game::EightBall)
                                   .rack({}, table(), model::BallSpec{}.radius_m, random);
        *layout.find(model::kCueBall) = {model::kCueBall, model::Place::OnTable,
                                         model::head_spot(table())};
        records.push_back(played(layout, any_shot(random, 0.0, 0.7, 1.0)));
    }
    return records;
}

/// One shot at some ball after each break.
std::vector<ShotRecord> usual_shots(int number) {
    base::Random random(2);
    std::vector<ShotRecord> records;
    for (const ShotRecord& broken : breaks(number)) {
        const model::Layout& layout = broken.final_layout;
        if (!layout.on_table(model::kCueBall)) continue;
        const base::Vec2 from = layout.find(model::kCueBall)->position_m;
        const base::Vec2 at = layout.find(model::kEightBall)->position_m;
        const double angle_rad = base::arc_tangent(at.y - from.y, at.x - from.x);
        records.push_back(played(layout, any_shot(random, angle_rad, 0.1, 0.4)));
    }
    return records;
}

ShotRecord sent(const ShotRecord& record) {
    JournalEntry entry;
    entry.record = record;
    const auto decoded = decode_entry(encode_entry(entry));
    return decoded.value().record.value();
}

TEST(RecordCodec, KeepsEverythingButTheSegmentsToTheBit) {
    for (const ShotRecord& record : breaks(20)) {
        const ShotRecord received = sent(record);
        EXPECT_EQ(received.events, record.events);
        EXPECT_EQ(received.final_layout, record.final_layout);
        EXPECT_EQ(received.duration_s, record.duration_s);
        EXPECT_EQ(received.hash, record.hash);
    }
}

TEST(RecordCodec, RoundsOnceAndNeverAgain) {
    for (const ShotRecord& record : breaks(20)) {
        const ShotRecord received = sent(record);
        EXPECT_NE(received, record);
        EXPECT_EQ(sent(received), received);
    }
}

void expect_near(const base::Vec3& a, const base::Vec3& b) {
    // A few last places of 32 bits, and those of the velocity that a rolling spin is made from.
    EXPECT_LE(glm::length(a - b), 1e-6 * glm::length(a) + 1e-9);
}

TEST(RecordCodec, MovesNoNumberOfASegmentByMoreThan32BitsDo) {
    for (const ShotRecord& record : breaks(20)) {
        const ShotRecord received = sent(record);
        for (std::size_t ball = 0; ball < record.timeline.tracks.size(); ++ball) {
            const auto& before = record.timeline.tracks[ball];
            const auto& after = received.timeline.tracks[ball];
            EXPECT_EQ(after.radius_m, before.radius_m);
            ASSERT_EQ(after.segments.size(), before.segments.size());
            for (std::size_t i = 0; i < before.segments.size(); ++i) {
                EXPECT_EQ(after.segments[i].start_s, before.segments[i].start_s);
                EXPECT_EQ(after.segments[i].motion, before.segments[i].motion);
                expect_near(before.segments[i].position_m, after.segments[i].position_m);
                expect_near(before.segments[i].velocity_mps, after.segments[i].velocity_mps);
                expect_near(before.segments[i].acceleration_mps2,
                            after.segments[i].acceleration_mps2);
                expect_near(before.segments[i].spin_radps, after.segments[i].spin_radps);
                expect_near(before.segments[i].spin_rate_radps2,
                            after.segments[i].spin_rate_radps2);
            }
        }
    }
}

TEST(RecordCodec, KeepsABallOnTheClothAtItsRadiusToTheBit) {
    for (const auto& track : sent(breaks(1)[0]).timeline.tracks) {
        for (const auto& segment : track.segments) {
            EXPECT_EQ(segment.position_m.z, track.radius_m);
            EXPECT_EQ(segment.velocity_mps.z, 0.0);
        }
    }
}

struct Sizes {
    std::size_t median = 0;
    std::size_t p99 = 0;
};

Sizes encoded_sizes(const std::vector<ShotRecord>& records) {
    std::vector<std::size_t> sizes;
    for (const ShotRecord& record : records) sizes.push_back(encoded_record_size(record));
    std::sort(sizes.begin(), sizes.end());
    return {sizes[sizes.size() / 2], sizes[sizes.size() * 99 / 100]};
}

TEST(RecordCodec, SendsABreakInTwelveKilobytesAndAUsualShotInThree) {
    const Sizes of_breaks = encoded_sizes(breaks(200));
    const Sizes of_usual_shots = encoded_sizes(usual_shots(200));
    EXPECT_LE(of_breaks.median, 12U * 1024);
    EXPECT_LE(of_breaks.p99, 24U * 1024);
    EXPECT_LE(of_usual_shots.median, 3U * 1024);
    RecordProperty("break_median", static_cast<int>(of_breaks.median));
    RecordProperty("break_p99", static_cast<int>(of_breaks.p99));
    RecordProperty("usual_median", static_cast<int>(of_usual_shots.median));
    RecordProperty("usual_p99", static_cast<int>(of_usual_shots.p99));
}

TEST(RecordCodec, AddsLittleToARecordInTheWholeFrameOfAShot) {
    server::ShotPlayed played;
    played.record = breaks(1)[0];
    played.after.layout = played.record.final_layout;
    EXPECT_LE(encode(ServerMessage{played})->size(), encoded_record_size(played.record) + 1024);
}

TEST(SegmentCodec, LeavesOutWhatFollowsFromTheRest) {
    // Sliding, rolling, flying, free, spinning, resting: as sample_record() has them.
    const std::size_t expected[] = {10, 8, 11, 12, 4, 2};
    const timeline::BallTrack track = sample_record().timeline.tracks[0];
    ASSERT_EQ(track.segments.size(), std::size(expected));
    for (std::size_t i = 0; i < track.segments.size(); ++i) {
        std::vector<float> numbers;
        pack(track.segments[i], track.radius_m, numbers);
        EXPECT_EQ(numbers.size(), expected[i]) << i;
    }
}

TEST(SegmentCodec, RefusesAnUnknownFormAndMissingNumbers) {
    const std::vector<float> none;
    std::span<const float> numbers(none);
    EXPECT_FALSE(unpack(0, 0.03, numbers).has_value());
    const std::vector<float> many(20);
    for (const std::uint8_t form : {std::uint8_t{7}, std::uint8_t{0x80}}) {
        numbers = many;
        EXPECT_FALSE(unpack(form, 0.03, numbers).has_value());
    }
}

TEST(SegmentCodec, RoundsPairsOfNumbersToo) {
    // Optimizers see neighbours: see as_sent.
    const auto rounded = [](const base::Vec2& v) { return base::Vec2(as_sent(v.x), as_sent(v.y)); };
    base::Random random(1);
    const base::Vec2 v(random.uniform(1, 2), random.uniform(1, 2));
    EXPECT_NE(rounded(v).x, v.x);
    EXPECT_NE(rounded(v).y, v.y);
    EXPECT_EQ(rounded(rounded(v)), rounded(v));
}

}  // namespace
}  // namespace billiards::protocol
