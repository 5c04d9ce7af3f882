// Gives the answer of a subcommand of billiards-sim to one case, or what it said was wrong.
#pragma once

#include "tools/sim/case_stream.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <sstream>
#include <string>

namespace billiards::tools {

/// As `--jsonl` has it; the input may be written on several lines.
inline std::string answer_line(const AnswerCase& answer_case, std::string input) {
    std::replace(input.begin(), input.end(), '\n', ' ');
    std::istringstream in(input);
    std::ostringstream out;
    answer_lines(in, out, answer_case);
    std::string line = out.str();
    while (!line.empty() && line.back() == '\n') line.pop_back();
    return line;
}

inline Json answered(const AnswerCase& answer_case, const std::string& input) {
    const Json answer = Json::parse(answer_line(answer_case, input));
    EXPECT_FALSE(answer.contains("error")) << input << "\n" << answer.dump();
    return answer;
}

inline std::string fault_of(const AnswerCase& answer_case, const std::string& input) {
    return Json::parse(answer_line(answer_case, input)).value("error", "none");
}

}  // namespace billiards::tools
