// Shows what a Result promises.
#include "common/base/result.h"

#include <gtest/gtest.h>
#include <memory>
#include <string>

namespace billiards::base {
namespace {

TEST(Result, HoldsAValueOrAnError) {
    const Result<int, std::string> good(7);
    const Result<int, std::string> bad(std::string("no such table"));
    ASSERT_TRUE(good.ok());
    EXPECT_EQ(*good, 7);
    ASSERT_FALSE(bad.ok());
    EXPECT_EQ(bad.error(), "no such table");
}

TEST(Result, GivesAwayAValueThatCannotBeCopied) {
    Result<std::unique_ptr<int>, std::string> result(std::make_unique<int>(3));
    const std::unique_ptr<int> taken = *std::move(result);
    EXPECT_EQ(*taken, 3);
}

TEST(ResultDeathTest, ReadingTheSideThatIsNotThereEndsTheProgram) {
    const Result<int, std::string> bad(std::string("gone"));
    EXPECT_DEATH(static_cast<void>(bad.value()), "CHECK");
}

}  // namespace
}  // namespace billiards::base
