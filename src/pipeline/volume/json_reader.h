// Reads JSON that people write: reports the first error, with its place and what was expected.
//
// Getters never fail at once: they remember the first error and return a harmless value. The caller must
// check status() at the end, and discard the values unless it is ok. So readers are as short as the format
// that they describe.
#pragma once

#include <initializer_list>
#include <limits>
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"

namespace macula {

struct JsonRange {
    double low = std::numeric_limits<double>::lowest();
    double high = std::numeric_limits<double>::max();
};

// A value in a JsonDocument; keeps it alive. Cheap to copy.
class JsonNode {
  public:
    // Fails if this is not an object or has no such key.
    JsonNode operator[](std::string_view key) const;
    // Nothing if this is an object without that key; fails if it is not an object.
    std::optional<JsonNode> find(std::string_view key) const;
    // Fails if this object has any other key: for Macula's own formats, where that is a typing error.
    void allowOnly(std::initializer_list<std::string_view> keys) const {
        allowOnly(std::span(keys.begin(), keys.size()));
    }
    void allowOnly(std::span<const std::string_view> keys) const;

    // Fails unless this is an array with `minimum` to `maximum` entries.
    std::vector<JsonNode> items(std::size_t minimum, std::size_t maximum) const;
    double number(JsonRange range = {}) const;
    std::vector<double> numbers(std::size_t count, JsonRange range = {}) const;
    std::string text() const;
    bool isText() const;  // these three never fail
    bool isNumber() const;
    bool isList() const;
    bool boolean() const;

    // Remembers "PATH: expected EXPECTED".
    void fail(const Text& expected) const;

  private:
    friend class JsonDocument;
    struct State;

    JsonNode(std::shared_ptr<State> state, const nlohmann::json* value, std::string path)
        : state_(std::move(state)), value_(value), path_(std::move(path)) {}

    std::shared_ptr<State> state_;
    const nlohmann::json* value_;
    std::string path_;
};

enum class JsonComments { refused, ignored };

class JsonDocument {
  public:
    // `where` names the file in errors. status() reports text that is not JSON, with line and column;
    // likewise JSON that is nested more than 64 deep or has more than 1000 keys in an object. No file of
    // Macula needs that; deep nesting could overflow the stack, and many keys are slow in documents that keep
    // their order (ordered_json), which search keys one by one.
    JsonDocument(std::string_view text, std::string where, JsonComments comments = JsonComments::refused);
    // For values that were converted to JSON from another format.
    static JsonDocument of(const nlohmann::json& value, std::string where);

    JsonNode root() const;
    Result<void> status() const;

  private:
    explicit JsonDocument(std::string where);

    std::shared_ptr<JsonNode::State> state_;
};

}  // namespace macula
