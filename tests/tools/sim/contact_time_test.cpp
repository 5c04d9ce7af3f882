// Holds `billiards-sim contact-time` against the rules of contact.
#include "tools/sim/contact_time.h"

#include "tests/tools/sim/answered.h"

#include <cmath>

namespace billiards::tools {
namespace {

/// Balls of radius 0.5: they touch at a distance of 1. `b` stands still at x = distance.
std::string case_of(double distance, const std::string& v, const std::string& a,
                    double horizon = 10) {
    return R"({"radius_m":0.5,"a":{"p":[0,0],"v":)" + v + R"(,"a":)" + a + R"(},"b":{"p":[)" +
           std::to_string(distance) + R"(,0],"v":[0,0],"a":[0,0]},"horizon_s":)" +
           std::to_string(horizon) + "}";
}

TEST(ContactTime, FindsTheFirstTimeAtWhichTheGapCloses) {
    const auto time = [](const std::string& input) {
        return answered(contact_time, input)["t"].get<double>();
    };
    EXPECT_NEAR(time(case_of(3, "[2,0]", "[0,0]")), 1.0, 1e-13);
    EXPECT_NEAR(time(case_of(3, "[0,0]", "[1,0]")), 2.0, 1e-12);
    // 3 t - t^2 / 2 = 2 on the way there, not on the way back.
    EXPECT_NEAR(time(case_of(3, "[3,0]", "[-1,0]")), 3 - std::sqrt(5.0), 1e-12);
}

TEST(ContactTime, GivesNullWhereBallsDoNotMeet) {
    for (const std::string& input :
         {case_of(3, "[-2,0]", "[0,0]"), case_of(3, "[2,2]", "[0,0]"), case_of(3, "[0,0]", "[0,0]"),
          case_of(3, "[2,0]", "[0,0]", 0.99), case_of(3, "[1,0]", "[-0.5,0]")}) {
        EXPECT_TRUE(answered(contact_time, input)["t"].is_null()) << input;
    }
}

TEST(ContactTime, TouchingBallsMeetNowOnlyIfTheyClose) {
    EXPECT_EQ(answered(contact_time, case_of(1, "[1,0]", "[0,0]"))["t"], 0.0);
    EXPECT_EQ(answered(contact_time, case_of(0.9999995, "[1,0]", "[0,0]"))["t"], 0.0);
    EXPECT_TRUE(answered(contact_time, case_of(1, "[-1,0]", "[0,0]"))["t"].is_null());
    EXPECT_TRUE(answered(contact_time, case_of(1, "[0,1]", "[0,0]"))["t"].is_null());
    EXPECT_NEAR(answered(contact_time, case_of(1, "[-1,0]", "[2,0]"))["t"].get<double>(), 1.0, 1e-9)
        << "they part and come back";
}

TEST(ContactTime, AccelerationsAndVelocitiesMayBeAbsent) {
    EXPECT_TRUE(answered(contact_time, R"({"radius_m":1,"a":{"p":[0,0]},"b":{"p":[3,0]},
        "horizon_s":1})")["t"]
                    .is_null());
}

struct BadCase {
    const char* input;
    const char* message;
};

TEST(ContactTime, NamesTheFieldThatIsWrong) {
    const BadCase cases[] = {
        {R"({})", "radius_m: is missing"},
        {R"({"radius_m":-1})", "radius_m: is out of range"},
        {R"({"radius_m":0})", "radius_m: is out of range"},
        {R"({"radius_m":1,"b":{"p":[0,9]},"horizon_s":1})", "a.p: is missing"},
        {R"({"radius_m":1,"a":{"p":[null,0]},"b":{"p":[0,9]},"horizon_s":1})",
         "a.p[0]: must be a number"},
        {R"({"radius_m":1,"a":{"p":[0,0,0]},"b":{"p":[0,9]},"horizon_s":1})",
         "a.p: must have 2 numbers"},
        {R"({"radius_m":1,"a":{"p":[0,0],"v":[1e9,0]},"b":{"p":[0,9]},"horizon_s":1})",
         "a.v: is out of range"},
        {R"({"radius_m":1,"a":{"p":[0,0],"a":"x"},"b":{"p":[0,9]},"horizon_s":1})",
         "a.a: must be a list"},
        {R"({"radius_m":1,"a":{"p":[0,0]},"b":{"p":[0,0]},"horizon_s":1})", "b.p: is where a is"},
        {R"({"radius_m":1,"a":{"p":[0,0]},"b":{"p":[0,9]},"horizon_s":-1})",
         "horizon_s: is out of range"},
        {R"({"radius_m":1,"a":{"p":[0,0]},"b":{"p":[0,9]}})", "horizon_s: is missing"},
        {R"({"radius_m":1,"a":{"p":[0,1e999]}})", "a.p: has a number that is not finite"},
    };
    for (const BadCase& bad : cases) EXPECT_EQ(fault_of(contact_time, bad.input), bad.message);
}

}  // namespace
}  // namespace billiards::tools
