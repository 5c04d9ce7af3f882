// Takes ball names; gives ids.
#include "tools/sim/ball_names.h"

#include "common/base/check.h"

#include <algorithm>
#include <cctype>

namespace billiards::tools {

namespace {

std::optional<int> own_number(const std::string& name) {
    if (name == "cue") return 0;
    for (int number = 1; number < model::kMaxBalls; ++number) {
        if (name == std::to_string(number)) return number;
    }
    return {};
}

}  // namespace

BallNames::BallNames(const std::vector<std::string>& names) {
    CHECK(names.size() <= names_.size());
    for (const std::string& name : names) {
        if (const auto number = own_number(name)) names_[static_cast<std::size_t>(*number)] = name;
    }
    for (const std::string& name : names) {
        if (own_number(name)) continue;
        auto place = std::find(names_.begin() + 1, names_.end(), std::nullopt);
        if (place == names_.end()) place = names_.begin();
        *place = name;
    }
}

model::BallId BallNames::id_of(const std::string& name) const {
    const auto found = std::find(names_.begin(), names_.end(), name);
    CHECK(found != names_.end());
    return model::BallId{static_cast<std::uint8_t>(found - names_.begin())};
}

const std::string& BallNames::name_of(model::BallId ball) const {
    CHECK(ball.number < names_.size() && names_[ball.number]);
    return *names_[ball.number];
}

std::string BallNames::translated(const std::string& sentence) const {
    static const std::string kWord = "ball ";
    std::string result;
    std::size_t from = 0;
    for (std::size_t at = sentence.find(kWord); at != std::string::npos;
         at = sentence.find(kWord, from)) {
        std::size_t end = at + kWord.size();
        int number = 0;
        while (end < sentence.size() &&
               std::isdigit(static_cast<unsigned char>(sentence[end])) != 0) {
            number = number * 10 + (sentence[end++] - '0');
        }
        const auto& name = names_[static_cast<std::size_t>(std::min(number, model::kMaxBalls - 1))];
        result += sentence.substr(from, at - from) + "balls." + name.value_or("?");
        from = end;
    }
    return result + sentence.substr(from);
}

}  // namespace billiards::tools
