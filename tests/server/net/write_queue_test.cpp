// Holds the queue of one receiver against its limit and its two kinds of frames.
#include "server/net/write_queue.h"

#include <gtest/gtest.h>
#include <memory>
#include <vector>

namespace billiards::server {
namespace {

protocol::SharedFrame frame_of(std::size_t bytes) {
    return std::make_shared<const std::vector<std::byte>>(bytes);
}

using Frames = std::vector<protocol::SharedFrame>;

TEST(WriteQueue, GivesOrderedFramesInTheirOrder) {
    WriteQueue queue(1000);
    const Frames frames{frame_of(1), frame_of(2), frame_of(3)};
    for (const auto& frame : frames) EXPECT_TRUE(queue.push(frame, Delivery::Ordered));
    EXPECT_EQ(queue.take(), frames);
    EXPECT_TRUE(queue.nothing_waits());
}

TEST(WriteQueue, SharesFramesInsteadOfCopyingThem) {
    WriteQueue queue(1000);
    const auto frame = frame_of(1);
    queue.push(frame, Delivery::Ordered);
    EXPECT_EQ(queue.take().at(0).get(), frame.get());
}

TEST(WriteQueue, RefusesAnOrderedFrameBeyondItsLimitAndStaysAsItWas) {
    WriteQueue queue(100);
    EXPECT_TRUE(queue.push(frame_of(100), Delivery::Ordered));
    EXPECT_FALSE(queue.push(frame_of(1), Delivery::Ordered));
    EXPECT_EQ(queue.bytes(), 100U);
}

TEST(WriteQueue, CountsWhatIsTakenUntilItIsWritten) {
    WriteQueue queue(100);
    queue.push(frame_of(60), Delivery::Ordered);
    queue.take();
    EXPECT_FALSE(queue.push(frame_of(60), Delivery::Ordered));
    queue.written();
    EXPECT_TRUE(queue.push(frame_of(60), Delivery::Ordered));
}

TEST(WriteQueue, LetsTheLatestTakeThePlaceOfTheOneThatWaits) {
    WriteQueue queue(1000);
    const Frames frames{frame_of(8), frame_of(16), frame_of(24), frame_of(32)};
    queue.push(frames[0], Delivery::LatestWins);
    queue.push(frames[1], Delivery::Ordered);
    queue.push(frames[2], Delivery::LatestWins);
    queue.push(frames[3], Delivery::Ordered);
    EXPECT_EQ(queue.bytes(), 72U);
    EXPECT_EQ(queue.take(), (Frames{frames[1], frames[2], frames[3]}));
}

TEST(WriteQueue, DoesNotReplaceWhatIsAlreadyBeingWritten) {
    WriteQueue queue(1000);
    queue.push(frame_of(8), Delivery::LatestWins);
    queue.take();
    const auto ordered = frame_of(8);
    const auto newer = frame_of(8);
    queue.push(ordered, Delivery::Ordered);
    queue.push(newer, Delivery::LatestWins);
    EXPECT_EQ(queue.take(), (Frames{ordered, newer}));
}

TEST(WriteQueue, DropsTheLatestWhereItIsHalfFull) {
    WriteQueue queue(100);
    queue.push(frame_of(48), Delivery::Ordered);
    EXPECT_TRUE(queue.push(frame_of(8), Delivery::LatestWins));
    EXPECT_EQ(queue.bytes(), 48U);
    EXPECT_EQ(queue.take().size(), 1U);
}

}  // namespace
}  // namespace billiards::server
