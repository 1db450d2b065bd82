// Reading JSON that people write: the first thing that is wrong is told with its place and what was expected.
//
// Getters never fail on the spot; they remember the first error and give a harmless value back. Whoever reads
// must ask status() at the end and drop what was read unless it is ok. That keeps readers as short as the
// format they describe.
#pragma once

#include <initializer_list>
#include <limits>
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <optional>
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
    // Fails when this is no object or has no such key.
    JsonNode operator[](std::string_view key) const;
    // Nothing when this is an object without that key.
    std::optional<JsonNode> find(std::string_view key) const;
    // Fails when this is an object with any other key: for formats of our own, where that is a typing error.
    void allowOnly(std::initializer_list<std::string_view> keys) const;

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
    // `where` is the file for error messages. Text that is no JSON shows as the error of status(), with line
    // and column; so does JSON that is nested more than 64 deep or has more than 1000 keys in an object. No
    // file of ours needs that; it would exhaust the stack of whoever walks it, and the patience of whoever
    // waits: in documents that keep their order (ordered_json), a key is found by asking each.
    JsonDocument(std::string_view text, std::string where, JsonComments comments = JsonComments::refused);
    // For what was no JSON, but was made into it.
    static JsonDocument of(const nlohmann::json& value, std::string where);

    JsonNode root() const;
    Result<void> status() const;

  private:
    explicit JsonDocument(std::string where);

    std::shared_ptr<JsonNode::State> state_;
};

}  // namespace macula
