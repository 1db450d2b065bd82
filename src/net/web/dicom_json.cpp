#include "net/web/dicom_json.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <nlohmann/json.hpp>
#include <optional>

#include "base/exceptions.h"
#include "base/parsing.h"
#include "base/utf8.h"

namespace macula::net {

namespace {

constexpr std::size_t kDeepestJson = 64;
constexpr std::size_t kMostValues = 256;            // of an element
constexpr std::size_t kMostItems = 100'000;         // of all sequences
constexpr std::size_t kMostElementsOfDataset = 64;  // of those that are wanted

Error notJson() {
    return {ErrorCode::archiveNotUsable,
            Text("The archive's answer cannot be read."),
            {},
            Text("Check that the address is that of DICOMweb, and not of a page for people.")};
}

std::optional<std::uint32_t> tagOfKey(std::string_view key) {
    constexpr std::size_t kDigits = 8;
    std::uint32_t tag = 0;
    const auto [end, error] = std::from_chars(key.data(), key.data() + key.size(), tag, 16);
    if (key.size() != kDigits || error != std::errc() || end != key.data() + key.size()) return {};
    return tag;
}

// What the walk is in.
enum class JsonPlace { datasets, dataset, element, values };

struct JsonLevel {
    JsonPlace place = JsonPlace::datasets;
    JsonDataset dataset;                // of a dataset, or of a value that is an object
    std::array<std::string, 3> groups;  // the component groups of a value that is a name
    bool isName = false;
    JsonElement element;
    std::string key;  // the last one
};

constexpr std::array<std::string_view, 3> kComponentGroups{"Alphabetic", "Ideographic", "Phonetic"};

std::string joinedName(const std::array<std::string, 3>& groups) {
    std::string name = groups[0] + "=" + groups[1] + "=" + groups[2];
    while (name.ends_with('=')) name.pop_back();
    return name;
}

// Receives the events of nlohmann's parser, which itself does not recurse. Each function returns whether the
// parser goes on.
class JsonWalk {
  public:
    JsonWalk(std::span<const std::uint32_t> wanted, std::size_t mostDatasets)
        : wanted_(wanted), mostDatasets_(mostDatasets) {}

    std::vector<JsonDataset> datasets;

    bool null() { return scalar({}); }
    bool boolean(bool /*value*/) { return scalar({}); }
    bool number_integer(std::int64_t value) { return scalar(std::to_string(value)); }
    bool number_unsigned(std::uint64_t value) { return scalar(std::to_string(value)); }
    bool number_float(double /*value*/, const std::string& text) { return scalar(text); }
    bool string(const std::string& text) { return scalar(text); }
    bool binary(std::vector<std::uint8_t>& /*value*/) { return false; }
    bool parse_error(std::size_t /*at*/, const std::string& /*token*/, const std::exception& /*why*/) {
        return false;
    }

    bool key(const std::string& name) {
        if (ignored_ == 0) levels_.back().key = name;
        return true;
    }

    bool start_array(std::size_t /*count*/) {
        if (ignored_ > 0) return ignore();
        if (levels_.empty()) return enter(JsonPlace::datasets);
        const JsonLevel& top = levels_.back();
        return top.place == JsonPlace::element && top.key == "Value" ? enter(JsonPlace::values) : ignore();
    }

    bool start_object(std::size_t /*count*/) {
        if (ignored_ > 0) return ignore();
        if (levels_.empty()) return enter(JsonPlace::dataset);
        const JsonLevel& top = levels_.back();
        switch (top.place) {
            case JsonPlace::datasets:
            case JsonPlace::values:
                return enter(JsonPlace::dataset);
            case JsonPlace::dataset: {
                const auto tag = wantedTag(top);
                if (!tag) return ignore();
                if (!enter(JsonPlace::element)) return false;
                levels_.back().element.tag = *tag;
                return true;
            }
            case JsonPlace::element:
                break;
        }
        return top.key == "Value" ? enter(JsonPlace::dataset) : ignore();
    }

    bool end_array() { return leave(); }
    bool end_object() { return leave(); }

  private:
    bool enter(JsonPlace place) {
        if (levels_.size() >= kDeepestJson) return false;
        levels_.emplace_back().place = place;
        return true;
    }

    // What is in it does not matter, but it may not go too deep either.
    bool ignore() { return ++ignored_ < kDeepestJson; }

    std::optional<std::uint32_t> wantedTag(const JsonLevel& level) const {
        const auto tag = tagOfKey(level.key);
        const bool isKept = tag && std::ranges::find(wanted_, *tag) != wanted_.end() &&
                            level.dataset.elements.size() < kMostElementsOfDataset;
        return isKept ? tag : std::nullopt;
    }

    static void addValue(JsonElement& element, std::string_view text) {
        if (element.values.size() < kMostValues) element.values.emplace_back(trimmed(text));
    }

    bool scalar(std::string_view text) {
        if (levels_.empty()) return false;
        if (ignored_ > 0) return true;
        JsonLevel& top = levels_.back();
        switch (top.place) {
            case JsonPlace::values:
                addValue(levels_[levels_.size() - 2].element, text);
                break;
            case JsonPlace::element:
                if (top.key == "Value") addValue(top.element, text);
                break;
            case JsonPlace::dataset:
                for (std::size_t i = 0; i < kComponentGroups.size(); ++i) {
                    if (top.key != kComponentGroups[i]) continue;
                    top.groups[i] = trimmed(text);
                    top.isName = true;
                }
                if (const auto tag = wantedTag(top)) {
                    JsonElement& element = top.dataset.elements.emplace_back();
                    element.tag = *tag;
                    addValue(element, text);
                }
                break;
            case JsonPlace::datasets:
                break;
        }
        return true;
    }

    bool leave() {
        if (ignored_ > 0) {
            --ignored_;
            return true;
        }
        JsonLevel left = std::move(levels_.back());
        levels_.pop_back();
        if (left.place == JsonPlace::element)
            levels_.back().dataset.elements.push_back(std::move(left.element));
        if (left.place != JsonPlace::dataset) return true;
        if (levels_.empty() || levels_.back().place == JsonPlace::datasets) {
            datasets.push_back(std::move(left.dataset));
            return datasets.size() <= mostDatasets_;
        }
        // A value of the element around it, with or without an array in between.
        const bool isInArray = levels_.back().place == JsonPlace::values;
        JsonElement& element = levels_[levels_.size() - (isInArray ? 2 : 1)].element;
        if (left.isName) addValue(element, joinedName(left.groups));
        if (!left.dataset.elements.empty()) {
            element.items.push_back(std::move(left.dataset));
            if (++items_ > kMostItems) return false;
        }
        return true;
    }

    std::span<const std::uint32_t> wanted_;
    std::size_t mostDatasets_;
    std::size_t items_ = 0;
    std::size_t ignored_ = 0;  // levels that are not wanted, below those that are
    std::vector<JsonLevel> levels_;
};

// Some archives send the bytes of another character set as they are. Those letters are lost; the rest is not.
std::string repairedUtf8(std::string_view text) {
    std::string repaired;
    repaired.reserve(text.size());
    while (!text.empty()) {
        const std::size_t bytes = firstCharacterBytes(text);
        if (bytes == 0) {
            repaired += '?';
        } else {
            repaired += text.substr(0, bytes);
        }
        text.remove_prefix(std::max<std::size_t>(bytes, 1));
    }
    return repaired;
}

}  // namespace

const JsonElement* JsonDataset::find(std::uint32_t tag) const {
    const auto found = std::ranges::find(elements, tag, &JsonElement::tag);
    return found == elements.end() ? nullptr : &*found;
}

std::string JsonDataset::first(std::uint32_t tag) const {
    const JsonElement* const element = find(tag);
    return element == nullptr || element->values.empty() ? std::string() : element->values.front();
}

std::span<const std::string> JsonDataset::values(std::uint32_t tag) const {
    const JsonElement* const element = find(tag);
    return element == nullptr ? std::span<const std::string>() : std::span(element->values);
}

std::span<const JsonDataset> JsonDataset::items(std::uint32_t tag) const {
    const JsonElement* const element = find(tag);
    return element == nullptr ? std::span<const JsonDataset>() : std::span(element->items);
}

Result<std::vector<JsonDataset>> dicomJsonOf(std::string_view text, std::span<const std::uint32_t> wanted,
                                             std::size_t mostDatasets) {
    try {
        JsonWalk walk(wanted, mostDatasets);
        if (nlohmann::json::sax_parse(text, &walk)) return std::move(walk.datasets);
        if (isValidUtf8(text)) return notJson();
        JsonWalk again(wanted, mostDatasets);
        if (!nlohmann::json::sax_parse(repairedUtf8(text), &again)) return notJson();
        return std::move(again.datasets);
    } catch (const nlohmann::json::exception&) {
        return notJson();
    } catch (const std::exception& thrown) {
        return errorOf(thrown, Text("read the archive's answer"));
    }
}

}  // namespace macula::net
