// Holds the queue of one receiver against its limits and its four kinds of frames.
#include "server/net/write_queue.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <memory>
#include <rapidcheck/gtest.h>
#include <vector>

namespace billiards::server {
namespace {

protocol::SharedFrame frame_of(std::size_t bytes) {
    return std::make_shared<const std::vector<std::byte>>(bytes);
}

using Frames = std::vector<protocol::SharedFrame>;

TEST(WriteQueue, GivesOrderedFramesInTheirOrder) {
    WriteQueue queue(1000, 1000);
    const Frames frames{frame_of(1), frame_of(2), frame_of(3)};
    for (const auto& frame : frames) EXPECT_TRUE(queue.push(frame, Delivery::Ordered).fits);
    EXPECT_EQ(queue.take(), frames);
    EXPECT_TRUE(queue.nothing_waits());
}

TEST(WriteQueue, SharesFramesInsteadOfCopyingThem) {
    WriteQueue queue(1000, 1000);
    const auto frame = frame_of(1);
    queue.push(frame, Delivery::Ordered);
    EXPECT_EQ(queue.take().at(0).get(), frame.get());
}

TEST(WriteQueue, RefusesAnOrderedFrameBeyondItsLimitAndStaysAsItWas) {
    WriteQueue queue(100, 100);
    EXPECT_TRUE(queue.push(frame_of(100), Delivery::Ordered).fits);
    EXPECT_FALSE(queue.push(frame_of(1), Delivery::Ordered).fits);
    EXPECT_EQ(queue.bytes(), 100U);
}

TEST(WriteQueue, CountsWhatIsTakenUntilItIsWritten) {
    WriteQueue queue(100, 100);
    queue.push(frame_of(60), Delivery::Ordered);
    queue.take();
    EXPECT_FALSE(queue.push(frame_of(60), Delivery::Ordered).fits);
    queue.written();
    EXPECT_TRUE(queue.push(frame_of(60), Delivery::Ordered).fits);
}

TEST(WriteQueue, LetsTheLatestTakeThePlaceOfTheOneThatWaits) {
    WriteQueue queue(1000, 1000);
    const Frames frames{frame_of(8), frame_of(16), frame_of(24), frame_of(32)};
    queue.push(frames[0], Delivery::LatestWins);
    queue.push(frames[1], Delivery::Ordered);
    queue.push(frames[2], Delivery::LatestWins);
    queue.push(frames[3], Delivery::Ordered);
    EXPECT_EQ(queue.bytes(), 72U);
    EXPECT_EQ(queue.take(), (Frames{frames[1], frames[2], frames[3]}));
}

TEST(WriteQueue, DoesNotReplaceWhatIsAlreadyBeingWritten) {
    WriteQueue queue(1000, 1000);
    queue.push(frame_of(8), Delivery::LatestWins);
    queue.take();
    const auto ordered = frame_of(8);
    const auto newer = frame_of(8);
    queue.push(ordered, Delivery::Ordered);
    queue.push(newer, Delivery::LatestWins);
    EXPECT_EQ(queue.take(), (Frames{ordered, newer}));
}

TEST(WriteQueue, DropsTheLatestWhereItIsHalfFull) {
    WriteQueue queue(100, 100);
    queue.push(frame_of(48), Delivery::Ordered);
    EXPECT_TRUE(queue.push(frame_of(8), Delivery::LatestWins).fits);
    EXPECT_EQ(queue.bytes(), 48U);
    EXPECT_EQ(queue.take().size(), 1U);
}

WriteQueue::Pushed push(WriteQueue& queue, std::size_t bytes, Delivery delivery) {
    return queue.push(frame_of(bytes), delivery);
}

/// A spectator of 100 bytes that is behind: 60 are being written, and 60 more did not fit.
WriteQueue behind() {
    WriteQueue queue(1000, 100);
    push(queue, 60, Delivery::Sheddable);
    queue.take();
    push(queue, 60, Delivery::Sheddable);
    return queue;
}

TEST(WriteQueue, DropsEverythingThatCanBeShedOnceItIsOverItsLimit) {
    WriteQueue queue(1000, 100);
    const Frames ordered{frame_of(10), frame_of(20)};
    push(queue, 30, Delivery::Sheddable);
    queue.push(ordered[0], Delivery::Ordered);
    push(queue, 8, Delivery::LatestWins);
    push(queue, 30, Delivery::Sheddable);
    queue.push(ordered[1], Delivery::Ordered);
    EXPECT_EQ(push(queue, 30, Delivery::Sheddable).shed, 4U);
    EXPECT_EQ(queue.bytes(), 30U);
    EXPECT_EQ(queue.take(), ordered);
}

TEST(WriteQueue, GivesNothingThatCanBeShedUntilAFreshFrame) {
    WriteQueue queue = behind();
    EXPECT_EQ(push(queue, 1, Delivery::Sheddable).shed, 1U);
    push(queue, 1, Delivery::LatestWins);
    EXPECT_TRUE(queue.nothing_waits());
    const Frames frames{frame_of(50), frame_of(1)};
    EXPECT_TRUE(queue.push(frames[0], Delivery::Fresh).fits);
    queue.written();
    EXPECT_EQ(queue.push(frames[1], Delivery::Sheddable).shed, 0U);
    EXPECT_EQ(queue.take(), frames);
}

TEST(WriteQueue, TellsOnceThatItFellBehindAndOnceMoreTheNextTime) {
    WriteQueue queue = behind();
    EXPECT_TRUE(queue.tell_fell_behind());
    EXPECT_FALSE(queue.tell_fell_behind());
    push(queue, 1, Delivery::Sheddable);
    EXPECT_FALSE(queue.tell_fell_behind());
    push(queue, 60, Delivery::Fresh);
    EXPECT_FALSE(queue.tell_fell_behind());
    push(queue, 60, Delivery::Sheddable);
    EXPECT_TRUE(queue.tell_fell_behind());
}

TEST(WriteQueue, HasNothingToTellWhereAFreshFrameCameFirst) {
    WriteQueue queue = behind();
    push(queue, 60, Delivery::Fresh);
    EXPECT_FALSE(queue.tell_fell_behind());
}

TEST(WriteQueue, TakesAFreshFrameInPlaceOfWhatCanBeShed) {
    WriteQueue queue(1000, 100);
    push(queue, 90, Delivery::Sheddable);
    const auto fresh = frame_of(50);
    EXPECT_EQ(queue.push(fresh, Delivery::Fresh).shed, 1U);
    EXPECT_FALSE(queue.tell_fell_behind());
    EXPECT_EQ(queue.take(), Frames{fresh});
}

TEST(WriteQueue, TakesAFrameOfAnySizeWhereNothingIsOnItsWay) {
    WriteQueue queue(1000, 100);
    EXPECT_EQ(push(queue, 5000, Delivery::Sheddable).shed, 0U);
    EXPECT_EQ(queue.take().size(), 1U);
}

struct Push {
    std::size_t bytes = 0;
    int delivery = 0;
    bool is_written_before = false;
};

std::vector<Push> pushes() {
    return *rc::gen::container<std::vector<Push>>(
        rc::gen::build<Push>(rc::gen::set(&Push::bytes, rc::gen::inRange<std::size_t>(1, 90)),
                             rc::gen::set(&Push::delivery, rc::gen::inRange(0, 4)),
                             rc::gen::set(&Push::is_written_before)));
}

RC_GTEST_PROP(WriteQueue, NeverHoldsMoreThanItsLimitAndNeverLosesWhatMustArrive, ()) {
    WriteQueue queue(1000, 100);
    Frames must_arrive;
    Frames given;
    const auto take = [&] {
        const Frames taken = queue.take();
        given.insert(given.end(), taken.begin(), taken.end());
    };
    for (const Push& next : pushes()) {
        if (next.is_written_before) queue.written(), take();
        const auto frame = frame_of(next.bytes);
        const auto delivery = static_cast<Delivery>(next.delivery);
        const std::size_t before = queue.bytes();
        const bool fits = queue.push(frame, delivery).fits;
        if (delivery == Delivery::Ordered && fits) must_arrive.push_back(frame);
        RC_ASSERT(queue.bytes() <= 1000U);
        if (delivery == Delivery::Sheddable)
            RC_ASSERT(queue.bytes() <= std::max(before, std::size_t{100}));
    }
    take();
    std::erase_if(given, [&](const auto& frame) {
        return std::find(must_arrive.begin(), must_arrive.end(), frame) == must_arrive.end();
    });
    RC_ASSERT(given == must_arrive);
}

}  // namespace
}  // namespace billiards::server
