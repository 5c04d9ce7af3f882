// Takes a JSON value and where it stands; gives its numbers, and remembers the first thing that is
// wrong by the name of its field.
#pragma once

#include "common/base/vec.h"

#include <initializer_list>
#include <nlohmann/json.hpp>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace billiards::tools {

/// Keys keep the order in which they were written.
using Json = nlohmann::ordered_json;

/// The first thing that was wrong with a case, as "field: what". Later ones are kept out.
class Fault {
  public:
    void report(const std::string& field, const std::string& what) {
        if (!text_) text_ = field + ": " + what;
    }
    bool is_found() const { return text_.has_value(); }
    /// Only where is_found().
    const std::string& text() const { return *text_; }

  private:
    std::optional<std::string> text_;
};

/// One value within a case, which may be absent. Reading what is absent or of another kind than
/// asked for reports a fault and gives a zero, so that a reader needs to look at the fault only
/// once.
class JsonNode {
  public:
    /// All must outlive the node. `value` is nullptr where the field is absent.
    JsonNode(const Json* value, std::string field, Fault& fault)
        : value_(value), field_(std::move(field)), fault_(&fault) {}

    JsonNode operator[](const std::string& key) const;
    bool is_present() const { return value_ != nullptr && !value_->is_null(); }
    /// Whether the field is there at all; null is no number and no text.
    bool is_written() const { return value_ != nullptr; }
    bool is_text() const { return is_present() && value_->is_string(); }
    const std::string& field() const { return field_; }
    void report(const std::string& what) const { fault_->report(field_, what); }

    double number() const;
    double number_or(double fallback) const;
    /// A number in [least, most].
    double number_in(double least, double most) const;
    double number_in_or(double fallback, double least, double most) const;
    /// Reports a value read here that is outside of these.
    void expect_within(double value, double least, double most) const;
    /// A whole number in [least, most]; `least`, with a fault, where none stands here.
    int integer(int least, int most) const;
    bool truth_or(bool fallback) const;
    std::string text() const;
    std::string text_or(const std::string& fallback) const;
    /// Which of these words stands here; 0, with a fault, where none does.
    std::size_t one_of(std::span<const char* const> words) const;
    std::size_t one_of(std::initializer_list<const char*> words) const {
        return one_of(std::span(words.begin(), words.size()));
    }
    base::Vec2 pair() const;
    base::Vec2 pair_or(const base::Vec2& fallback) const;
    /// Three numbers, or two where `height` says what the third is.
    base::Vec3 triple(std::optional<double> height = {}) const;
    base::Vec3 triple_or(const base::Vec3& fallback) const;
    /// An absent list is empty.
    std::vector<JsonNode> items() const;
    /// An object's fields by name, in the order in which they were written.
    std::vector<std::pair<std::string, JsonNode>> members() const;

  private:
    std::vector<double> numbers(std::size_t least, std::size_t most) const;

    const Json* value_;
    std::string field_;
    Fault* fault_;
};

Json json_of(const base::Vec3& v);

}  // namespace billiards::tools
