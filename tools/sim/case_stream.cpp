// Takes cases as JSON text; gives answers line by line.
#include "tools/sim/case_stream.h"

#include <istream>
#include <iterator>
#include <ostream>
#include <set>
#include <string>
#include <vector>

namespace billiards::tools {

namespace {

constexpr int kBadInput = 2;

/// Looks on as a case is parsed, so that what is wrong with its text has a name too.
class Reader {
  public:
    explicit Reader(Fault& fault) : fault_(fault) {}

    /// Reports a key that an object has had already: what it means then is anybody's guess.
    Json read(const std::string& text) {
        try {
            return Json::parse(text, [this](int, Json::parse_event_t event, const Json& value) {
                return look(event, value);
            });
        } catch (const Json::out_of_range&) {
            fault_.report(field(), "has a number that is not finite");
        } catch (const Json::exception& error) {
            fault_.report("input", std::string("is no JSON: ") + error.what());
        }
        return {};
    }

  private:
    /// An object that is still open, and the key at which reading it stands.
    struct Open {
        std::set<std::string> keys;
        std::string key;
    };

    /// Whether to keep it.
    bool look(Json::parse_event_t event, const Json& value) {
        constexpr std::size_t kMostKeys = 10'000;
        if (event == Json::parse_event_t::object_start) open_.emplace_back();
        if (event == Json::parse_event_t::object_end) open_.pop_back();
        if (event != Json::parse_event_t::key) return true;
        Open& object = open_.back();
        object.key = value.get<std::string>();
        const bool is_new = object.keys.insert(object.key).second;
        if (!is_new) fault_.report(field(), "stands there twice");
        if (object.keys.size() > kMostKeys) fault_.report(field(), "is one field too many");
        return !fault_.is_found();
    }

    std::string field() const {
        std::string path;
        for (const Open& object : open_) path += (path.empty() ? "" : ".") + object.key;
        return path.empty() ? "input" : path;
    }

    Fault& fault_;
    std::vector<Open> open_;
};

Json answer_text(const std::string& text, const AnswerCase& answer, Fault& fault) {
    const Json input = Reader(fault).read(text);
    if (!fault.is_found() && !input.is_object()) fault.report("input", "must be one JSON object");
    if (fault.is_found()) return {};
    return answer(JsonNode(&input, "", fault), fault);
}

/// A message may quote bytes that are no text.
std::string text_of(const Json& json) {
    return json.dump(-1, ' ', false, Json::error_handler_t::replace);
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
    out << text_of(result) << '\n';
    return 0;
}

int answer_lines(std::istream& in, std::ostream& out, const AnswerCase& answer) {
    std::string line;
    while (std::getline(in, line)) {
        if (line.find_first_not_of(" \t\r") == std::string::npos) continue;
        Fault fault;
        const Json result = answer_text(line, answer, fault);
        out << text_of(fault.is_found() ? Json{{"error", fault.text()}} : result) << '\n';
    }
    return 0;
}

}  // namespace billiards::tools
