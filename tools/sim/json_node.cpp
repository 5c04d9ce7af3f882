// Takes JSON values; gives numbers, words and lists, or a fault that names the field.
#include "tools/sim/json_node.h"

#include <algorithm>
#include <cmath>

namespace billiards::tools {

JsonNode JsonNode::operator[](const std::string& key) const {
    const std::string field = field_.empty() ? key : field_ + "." + key;
    if (!is_present()) return {nullptr, field, *fault_};
    if (!value_->is_object()) {
        report("must be an object");
        return {nullptr, field, *fault_};
    }
    const auto found = value_->find(key);
    return {found == value_->end() ? nullptr : &*found, field, *fault_};
}

double JsonNode::number() const {
    if (is_present() && value_->is_number()) return value_->get<double>();
    report(is_written() ? "must be a number" : "is missing");
    return 0.0;
}

double JsonNode::number_or(double fallback) const {
    return is_written() ? number() : fallback;
}

double JsonNode::number_in(double least, double most) const {
    const double value = number();
    expect_within(value, least, most);
    return value;
}

double JsonNode::number_in_or(double fallback, double least, double most) const {
    return is_written() ? number_in(least, most) : fallback;
}

void JsonNode::expect_within(double value, double least, double most) const {
    if (!(value >= least && value <= most)) report("is out of range");
}

int JsonNode::integer(int least, int most) const {
    const double value = number();
    if (value >= least && value <= most && value == std::floor(value)) {
        return static_cast<int>(value);
    }
    report("must be a whole number from " + std::to_string(least) + " to " + std::to_string(most));
    return least;
}

bool JsonNode::truth_or(bool fallback) const {
    if (!is_written()) return fallback;
    if (value_->is_boolean()) return value_->get<bool>();
    report("must be true or false");
    return fallback;
}

std::string JsonNode::text() const {
    if (is_text()) return value_->get<std::string>();
    report(is_written() ? "must be a string" : "is missing");
    return {};
}

std::string JsonNode::text_or(const std::string& fallback) const {
    return is_written() ? text() : fallback;
}

std::size_t JsonNode::one_of(std::span<const char* const> words) const {
    const std::string word = text();
    const auto found = std::find(words.begin(), words.end(), word);
    if (found != words.end()) return static_cast<std::size_t>(found - words.begin());
    std::string wanted;
    for (const char* each : words) wanted += (wanted.empty() ? "" : ", ") + std::string(each);
    report("must be one of " + wanted);
    return 0;
}

std::vector<double> JsonNode::numbers(std::size_t least, std::size_t most) const {
    std::vector<double> result;
    for (const JsonNode& item : items()) result.push_back(item.number());
    if (!is_present()) report("is missing");
    if (result.size() < least || result.size() > most) {
        report("must have " + std::to_string(most) + " numbers");
    }
    result.resize(most);
    return result;
}

base::Vec2 JsonNode::pair() const {
    const std::vector<double> values = numbers(2, 2);
    return {values[0], values[1]};
}

base::Vec2 JsonNode::pair_or(const base::Vec2& fallback) const {
    return is_written() ? pair() : fallback;
}

base::Vec3 JsonNode::triple(std::optional<double> height) const {
    const bool is_flat = height && is_present() && value_->size() == 2;
    const std::vector<double> values = numbers(is_flat ? 2 : 3, is_flat ? 2 : 3);
    return {values[0], values[1], is_flat ? *height : values[2]};
}

base::Vec3 JsonNode::triple_or(const base::Vec3& fallback) const {
    return is_written() ? triple() : fallback;
}

std::vector<JsonNode> JsonNode::items() const {
    std::vector<JsonNode> result;
    if (!is_present()) return result;
    if (!value_->is_array()) {
        report("must be a list");
        return result;
    }
    for (std::size_t i = 0; i < value_->size(); ++i) {
        result.emplace_back(&(*value_)[i], field_ + "[" + std::to_string(i) + "]", *fault_);
    }
    return result;
}

std::vector<std::pair<std::string, JsonNode>> JsonNode::members() const {
    std::vector<std::pair<std::string, JsonNode>> result;
    if (!is_present()) return result;
    if (!value_->is_object()) {
        report("must be an object");
        return result;
    }
    for (const auto& [key, value] : value_->items()) {
        result.emplace_back(key, JsonNode(&value, field_ + "." + key, *fault_));
    }
    return result;
}

/// Adding 0 makes a negative zero one that people read.
Json json_of(const base::Vec3& v) {
    return Json::array({v.x + 0.0, v.y + 0.0, v.z + 0.0});
}

}  // namespace billiards::tools
