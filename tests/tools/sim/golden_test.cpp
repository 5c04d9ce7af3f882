// Holds the subcommands' answers, bit for bit, against recorded ones that people can read.
#include "tests/tools/sim/answered.h"
#include "tools/sim/collide.h"
#include "tools/sim/contact_time.h"
#include "tools/sim/solve.h"
#include "tools/sim/strike.h"

#include <fstream>
#include <map>

namespace billiards::tools {
namespace {

/// "SUBCOMMAND INPUT", the answer on the next line; empty lines and lines that begin with # say
/// nothing.
TEST(Golden, EveryRecordedCaseHasItsRecordedAnswer) {
    const std::map<std::string, AnswerCase> subcommands{
        {"solve", solve}, {"collide", collide}, {"strike", strike}, {"contact-time", contact_time}};
    std::ifstream in(GOLDEN_SIM_FILE);
    ASSERT_TRUE(in) << GOLDEN_SIM_FILE;
    int cases = 0;
    for (std::string line; std::getline(in, line);) {
        if (line.empty() || line[0] == '#') continue;
        const std::size_t space = line.find(' ');
        const auto subcommand = subcommands.find(line.substr(0, space));
        ASSERT_NE(subcommand, subcommands.end()) << line;
        std::string expected;
        std::getline(in, expected);
        EXPECT_EQ(answer_line(subcommand->second, line.substr(space + 1)), expected) << line;
        ++cases;
    }
    EXPECT_GT(cases, 40);
}

}  // namespace
}  // namespace billiards::tools
