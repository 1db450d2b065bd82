#include "pipeline/volume/json_reader.h"

#include <algorithm>
#include <nlohmann/json.hpp>

namespace macula {

struct JsonNode::State {
    nlohmann::json document;
    std::string where;
    std::optional<Error> error;

    void fail(Text message, Text hint) {
        if (!error) error = Error{ErrorCode::inputNotUsable, std::move(message), where, std::move(hint)};
    }
};

namespace {

// Stands for a missing or wrong value, so that getters can continue.
const nlohmann::json& nothing() {
    static const nlohmann::json value;
    return value;
}

std::string child(const std::string& path, std::string_view key) {
    return path.empty() ? std::string(key) : path + "." + std::string(key);
}

Text describeRange(JsonRange range) {
    const bool low = range.low > std::numeric_limits<double>::lowest();
    const bool high = range.high < std::numeric_limits<double>::max();
    if (low && high) return Text("a number from {} to {}", range.low, range.high);
    if (low) return Text("a number not below {}", range.low);
    if (high) return Text("a number not above {}", range.high);
    return Text("a number");
}

// nlohmann counts bytes from 1; people count lines and columns.
Text lineAndColumn(std::string_view text, std::size_t byte) {
    const std::string_view before = text.substr(0, byte > 0 ? std::min(byte - 1, text.size()) : 0);
    const auto line = 1 + std::count(before.begin(), before.end(), '\n');
    const std::size_t lastBreak = before.rfind('\n');
    const std::size_t column =
        lastBreak == std::string_view::npos ? before.size() + 1 : before.size() - lastBreak;
    return Text("line {}, column {}", line, column);
}

constexpr int kMaxDepth = 64;
constexpr std::size_t kMostKeys = 1000;

// Finds valid JSON that is rejected nevertheless: nested more than kMaxDepth deep, or with more than
// kMostKeys in an object. Scans only the text, outside comments and quotes, before it is parsed.
class TextLimits {
  public:
    explicit TextLimits(std::string_view text) {
        bool quoted = false;
        for (std::size_t i = 0; i < text.size() && !isBroken(); ++i) {
            const char c = text[i];
            if (quoted) {
                if (c == '\\') ++i;
                if (c == '"') quoted = false;
            } else if (c == '"') {
                quoted = true;
            } else if (text.substr(i, 2) == "//") {
                i = std::min(text.find('\n', i), text.size());
            } else if (text.substr(i, 2) == "/*") {
                i = std::min(text.find("*/", i + 2), text.size()) + 1;  // at its slash
            } else {
                count(c, i);
            }
        }
    }

    bool isBroken() const { return isTooDeep_ || hasTooManyKeys_; }
    bool isTooDeep() const { return isTooDeep_; }
    std::size_t place() const { return place_; }

  private:
    void count(char c, std::size_t place) {
        place_ = place;
        if (c == '[' || c == '{') {
            isTooDeep_ = ++depth_ > kMaxDepth;
            if (!isTooDeep_) keys_.at(std::size_t(depth_)) = 0;
        } else if ((c == ']' || c == '}') && depth_ > 0) {
            --depth_;
        } else if (c == ':') {
            hasTooManyKeys_ = ++keys_.at(std::size_t(depth_)) > kMostKeys;
        }
    }

    std::array<std::size_t, kMaxDepth + 1> keys_{};  // so far, in the open object at each depth
    int depth_ = 0;
    std::size_t place_ = 0;
    bool isTooDeep_ = false;
    bool hasTooManyKeys_ = false;
};

}  // namespace

JsonNode JsonNode::operator[](std::string_view key) const {
    if (value_->is_object()) {
        if (const auto found = value_->find(key); found != value_->end()) {
            return {state_, &*found, child(path_, key)};
        }
        state_->fail(Text("The key {} is missing.", child(path_, key)), Text("Add it."));
    } else {
        fail(Text("an object, { … }"));
    }
    return {state_, &nothing(), child(path_, key)};
}

std::optional<JsonNode> JsonNode::find(std::string_view key) const {
    if (!value_->is_object()) {
        fail(Text("an object, { … }"));
        return std::nullopt;
    }
    const auto found = value_->find(key);
    if (found == value_->end()) return std::nullopt;
    return JsonNode(state_, &*found, child(path_, key));
}

void JsonNode::allowOnly(std::span<const std::string_view> keys) const {
    if (!value_->is_object()) return fail(Text("an object, { … }"));
    for (const auto& [key, unused] : value_->items()) {
        if (std::find(keys.begin(), keys.end(), key) == keys.end()) {
            return state_->fail(Text("The key {} is unknown.", child(path_, key)),
                                Text("Known here: {}.", fmt::format("{}", fmt::join(keys, ", "))));
        }
    }
}

std::vector<JsonNode> JsonNode::items(std::size_t minimum, std::size_t maximum) const {
    std::vector<JsonNode> nodes;
    if (!value_->is_array() || value_->size() < minimum || value_->size() > maximum) {
        fail(minimum == maximum ? Text("a list of {} entries", minimum)
                                : Text("a list of {} to {} entries", minimum, maximum));
        return nodes;
    }
    nodes.reserve(value_->size());
    for (std::size_t i = 0; i < value_->size(); ++i) {
        nodes.push_back(JsonNode(state_, &(*value_)[i], fmt::format("{}[{}]", path_, i)));
    }
    return nodes;
}

double JsonNode::number(JsonRange range) const {
    if (value_->is_number()) {
        const double value = value_->get<double>();
        if (std::isfinite(value) && value >= range.low && value <= range.high) return value;
    }
    fail(describeRange(range));
    return std::clamp(0.0, range.low, range.high);
}

std::vector<double> JsonNode::numbers(std::size_t count, JsonRange range) const {
    std::vector<double> values;
    for (const JsonNode& item : items(count, count)) values.push_back(item.number(range));
    values.resize(count, 0.0);
    return values;
}

bool JsonNode::isText() const {
    return value_->is_string();
}

std::string JsonNode::text() const {
    if (value_->is_string()) return value_->get<std::string>();
    fail(Text("a text in quotes"));
    return {};
}

bool JsonNode::isNumber() const {
    return value_->is_number();
}

bool JsonNode::isList() const {
    return value_->is_array();
}

bool JsonNode::boolean() const {
    if (value_->is_boolean()) return value_->get<bool>();
    fail(Text("true or false"));
    return false;
}

void JsonNode::fail(const Text& expected) const {
    state_->fail(Text("{} is not as expected.", path_.empty() ? Text("The file") : Text::verbatim(path_)),
                 Text("Expected {}.", expected));
}

JsonDocument::JsonDocument(std::string where) : state_(std::make_shared<JsonNode::State>()) {
    state_->where = std::move(where);
}

JsonDocument JsonDocument::of(const nlohmann::json& value, std::string where) {
    JsonDocument document(std::move(where));
    document.state_->document = value;
    return document;
}

JsonDocument::JsonDocument(std::string_view text, std::string where, JsonComments comments)
    : JsonDocument(std::move(where)) {
    if (const TextLimits limits(text); limits.isBroken()) {
        const Text place = lineAndColumn(text, limits.place() + 1);
        if (limits.isTooDeep()) {
            state_->fail(Text("The file is nested too deeply at {}.", place),
                         Text("Give a file that is nested at most {} deep.", kMaxDepth));
        } else {
            state_->fail(Text("An object of the file has too many keys, at {}.", place),
                         Text("Give a file whose objects have at most {} keys.", kMostKeys));
        }
        return;
    }
    try {
        state_->document = nlohmann::json::parse(text, nullptr, true, comments == JsonComments::ignored);
    } catch (const nlohmann::json::parse_error& error) {
        state_->fail(Text("The file is no valid JSON from {} on.", lineAndColumn(text, error.byte)),
                     Text("Look for a missing comma, quote or bracket there or just before."));
    } catch (const nlohmann::json::exception&) {  // a number that no double can hold
        state_->fail(Text("The file is no valid JSON."), Text("Look for numbers that are too large."));
    }
}

JsonNode JsonDocument::root() const {
    return {state_, &state_->document, {}};
}

Result<void> JsonDocument::status() const {
    if (state_->error) return *state_->error;
    return {};
}

}  // namespace macula
