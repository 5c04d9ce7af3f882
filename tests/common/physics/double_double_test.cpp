// Holds sums and products of twice the digits against ones that can be told exactly.
#include "common/physics/double_double.h"

#include "common/base/random.h"
#include "tests/common/physics/exact_contact.h"

#include <gtest/gtest.h>

namespace billiards::physics {
namespace {

Exact exact(const DoubleDouble& number) {
    return Exact(number.high) + number.low;
}

TEST(DoubleDouble, KeepsWhatTheRoundedSumAndProductLose) {
    base::Random random(61);
    for (int i = 0; i < 2000; ++i) {
        const double a = random.uniform(-1, 1) * (i % 2 == 0 ? 1.0 : 1e-9);
        const double b = random.uniform(-1, 1);
        EXPECT_EQ(exact(exact_sum(a, b)), Exact(a) + b);
        EXPECT_EQ(exact(exact_product(a, b)), Exact(a) * b);
    }
}

TEST(DoubleDouble, HasAboutThirtyDigits) {
    base::Random random(62);
    for (int i = 0; i < 2000; ++i) {
        const DoubleDouble a = exact_product(random.uniform(-1, 1), random.uniform(-1, 1));
        const DoubleDouble b = exact_sum(random.uniform(-1, 1), random.uniform(-1e-20, 1e-20));
        EXPECT_LE(abs(exact(a + b) - (exact(a) + exact(b))), 1e-31);
        EXPECT_LE(abs(exact(a * b) - exact(a) * exact(b)), 1e-31);
    }
}

}  // namespace
}  // namespace billiards::physics
