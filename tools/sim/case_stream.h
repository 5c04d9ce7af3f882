// Takes cases as JSON text; gives each one's answer as one line.
#pragma once

#include "tools/sim/json_node.h"

#include <functional>
#include <iosfwd>

namespace billiards::tools {

/// Answers one case, or reports what is wrong with it; then the answer means nothing.
using AnswerCase = std::function<Json(const JsonNode& input, Fault& fault)>;

/// One case, the whole input: its answer on `out`, and 0; where it is bad one line on `err`, and 2.
int answer_one(std::istream& in, std::ostream& out, std::ostream& err, const AnswerCase& answer);

/// One case a line: {"error": ...} stands on a bad one's line, and the others go on. Empty lines
/// are skipped. Gives 0.
int answer_lines(std::istream& in, std::ostream& out, const AnswerCase& answer);

}  // namespace billiards::tools
