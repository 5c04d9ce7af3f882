// Takes cases as JSON text; gives answers line by line.
#include "tools/sim/case_stream.h"

#include <istream>
#include <iterator>
#include <ostream>
#include <string>

namespace billiards::tools {

namespace {

constexpr int kBadInput = 2;

Json answer_text(const std::string& text, const AnswerCase& answer, Fault& fault) {
    Json input;
    try {
        input = Json::parse(text);
    } catch (const Json::exception& error) {
        fault.report("input", std::string("is no JSON: ") + error.what());
        return {};
    }
    if (!input.is_object()) {
        fault.report("input", "must be one JSON object");
        return {};
    }
    return answer(JsonNode(&input, "", fault), fault);
}

}  // namespace

int answer_one(std::istream& in, std::ostream& out, std::ostream& err, const AnswerCase& answer) {
    const std::string text{std::istreambuf_iterator<char>(in), {}};
    Fault fault;
    const Json result = answer_text(text, answer, fault);
    if (fault.is_found()) {
        err << fault.text() << '\n';
        return kBadInput;
    }
    out << result.dump() << '\n';
    return 0;
}

int answer_lines(std::istream& in, std::ostream& out, const AnswerCase& answer) {
    std::string line;
    while (std::getline(in, line)) {
        if (line.find_first_not_of(" \t\r") == std::string::npos) continue;
        Fault fault;
        const Json result = answer_text(line, answer, fault);
        out << (fault.is_found() ? Json{{"error", fault.text()}} : result).dump() << '\n';
    }
    return 0;
}

}  // namespace billiards::tools
