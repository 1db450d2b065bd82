#include "dicom/stack/split_rules.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <nlohmann/json.hpp>

#include "base/check.h"
#include "base/parsing.h"
#include "base/utf8.h"
#include "dicom/read/date_time.h"
#include "dicom/read/tags.h"
#include "dicom/rules/embedded.h"

namespace macula::dicom {

namespace {

using Json = nlohmann::json;

Tag tagOf(const std::string& text) {
    const auto hex = [&](std::size_t at) {
        std::uint16_t value = 0;
        const char* begin = text.data() + at;
        const auto [end, error] = std::from_chars(begin, begin + 4, value, 16);
        MACULA_CHECK(error == std::errc() && end == begin + 4);
        return value;
    };
    MACULA_CHECK_EQ(text.size(), std::size_t{9});  // "gggg,eeee"
    return {hex(0), hex(5)};
}

// Parses one tag, or two: with a plus, the text of the first goes before that of the second; with a slash,
// the second is in an item of the first; or, with a minus, a tag and the bias of its number.
Attribute::Source sourceOf(const std::string& text) {
    const std::size_t minus = text.find('-');
    if (minus != std::string::npos) {
        const auto bias = finiteNumber(std::string_view(text).substr(minus + 1));
        MACULA_CHECK(bias && *bias > 0.0);
        return {.before = {}, .tag = tagOf(text.substr(0, minus)), .bias = *bias};
    }
    const std::size_t plus = text.find('+');
    if (plus != std::string::npos) return {tagOf(text.substr(0, plus)), tagOf(text.substr(plus + 1))};
    const std::size_t slash = text.find('/');
    if (slash == std::string::npos) return {{}, tagOf(text)};
    return {{}, tagOf(text.substr(slash + 1)), tagOf(text.substr(0, slash))};
}

Attribute::Reading readingOf(const std::string& name) {
    if (name == "list") return Attribute::Reading::list;
    if (name == "dimensions") return Attribute::Reading::dimensions;
    MACULA_CHECK(name.empty());
    return Attribute::Reading::value;
}

Attribute::Kind kindOf(const std::string& name) {
    if (name == "number") return Attribute::Kind::number;
    if (name == "numbers") return Attribute::Kind::numbers;
    if (name == "time") return Attribute::Kind::time;
    if (name == "contains") return Attribute::Kind::contains;
    MACULA_CHECK(name == "text");
    return Attribute::Kind::text;
}

// The index of the attribute in the rules, to which it is added if it is new.
std::size_t enter(SplitRules& rules, const Json& json) {
    Attribute attribute{.name = json.at("name"),
                        .kind = kindOf(json.value("as", "text")),
                        .tolerance = json.value("tolerance", 0.0),
                        .relativeTolerance = json.value("relativeTolerance", 0.0),
                        .value = json.value("value", ""),
                        .reading = readingOf(json.value("read", ""))};
    for (const std::string text : json.at("tags")) attribute.tags.push_back(sourceOf(text));
    const auto found = std::find(rules.attributes.begin(), rules.attributes.end(), attribute);
    if (found != rules.attributes.end()) {
        return static_cast<std::size_t>(found - rules.attributes.begin());
    }
    rules.attributes.push_back(std::move(attribute));
    return rules.attributes.size() - 1;
}

SplitRules::Soft::Step stepOf(const std::string& name) {
    using Step = SplitRules::Soft::Step;
    if (name == "once") return Step::once;
    if (name == "always") return Step::always;
    MACULA_CHECK(name.empty());
    return Step::silent;
}

// Adds attributes that are read from data sets first, and those of later versions of the rules last, because
// saved views refer to attributes by index.
void enterInOrder(SplitRules& rules, const Json& json) {
    const auto enterThoseOf = [&](const Json& list, bool alsoRead) {
        for (const Json& rule : list) {
            if ((alsoRead || !rule.contains("read")) && !rule.contains("since")) enter(rules, rule);
        }
    };
    for (const bool alsoRead : {false, true}) {
        enterThoseOf(json.at("hard"), alsoRead);
        for (const auto& [modality, list] : json.at("soft").items()) enterThoseOf(list, alsoRead);
        enterThoseOf(json.at("runs"), alsoRead);
        enterThoseOf(json.at("phases"), alsoRead);
    }
}

SplitRules parse(std::string_view text) {
    const Json json = Json::parse(text);
    SplitRules rules;
    enterInOrder(rules, json);
    for (const Json& rule : json.at("hard")) rules.hard.push_back({enter(rules, rule), rule.at("message")});
    for (const auto& [modality, list] : json.at("soft").items()) {
        for (const Json& rule : list) {
            rules.soft.push_back({enter(rules, rule), modality == "any" ? std::string() : modality,
                                  rule.value("evenToo", false), rule.value("interleavable", false),
                                  stepOf(rule.value("step", ""))});
        }
    }
    for (const Json& rule : json.at("runs")) rules.runs.push_back(enter(rules, rule));
    for (const Json& rule : json.at("phases")) {
        rules.phases.push_back(
            {enter(rules, rule),
             rule.at("by") == "rank" ? SplitRules::Phase::By::rank : SplitRules::Phase::By::value,
             rule.value("first", false), rule.value("assumed", false)});
    }
    return rules;
}

std::vector<std::string_view> values(std::string_view text) {
    std::vector<std::string_view> parts;
    for (std::size_t begin = 0;;) {
        const std::size_t end = text.find('\\', begin);
        parts.push_back(text.substr(begin, end == std::string_view::npos ? end : end - begin));
        if (end == std::string_view::npos) return parts;
        begin = end + 1;
    }
}

bool sameNumber(const Attribute& attribute, std::string_view a, std::string_view b) {
    const auto x = numberOf(a);
    const auto y = numberOf(b);
    if (!x || !y) return a == b;
    const double allowed =
        std::max(attribute.tolerance, attribute.relativeTolerance * std::max(std::abs(*x), std::abs(*y)));
    return std::abs(*x - *y) <= allowed;
}

// The first number without the bias; text that is not a number stays as it is.
std::string withoutBias(std::string text, double bias) {
    const auto number = numberOf(text);
    if (!number) return text;
    return fmt::format("{}", *number < bias ? *number : *number - bias);
}

std::optional<std::string> textAt(const Dataset& frame, const Attribute::Source& source) {
    if (!source.within) {
        auto text = frame.text(source.tag);
        if (text && source.bias > 0.0) text = withoutBias(*std::move(text), source.bias);
        if (text && source.before) text = frame.text(*source.before).value_or("") + *text;
        return text;
    }
    const std::vector<Dataset> items = frame.items(*source.within);
    return items.empty() ? std::nullopt : items.front().text(source.tag);
}

// The time, with the offset of the image's time zone if the text has none. Nothing when the text has no time
// of day.
std::optional<std::string> timeAt(const Dataset& frame, const Attribute::Source& source) {
    auto text = textAt(frame, source);
    if (!text || !momentOf(*text)) return {};
    if (text->find_first_of("+-") != std::string::npos) return text;
    const std::string offset = frame.text(tag::kTimezoneOffsetFromUtc).value_or("");
    return secondsOfOffset(offset) ? *text + offset : text;
}

}  // namespace

const SplitRules& splitRules() {
    static const SplitRules rules = parse(rules::kSplit);
    return rules;
}

std::vector<std::string> readAttributes(const SplitRules& rules, const Dataset& frame) {
    std::vector<std::string> result;
    result.reserve(rules.attributes.size());
    for (const Attribute& attribute : rules.attributes) {
        std::string value;
        for (const Attribute::Source& source : attribute.tags) {
            if (attribute.reading != Attribute::Reading::value) break;
            auto text =
                attribute.kind == Attribute::Kind::time ? timeAt(frame, source) : textAt(frame, source);
            if (!text) continue;
            value = std::move(*text);
            break;
        }
        // No real value is as long, and there is one for each frame.
        constexpr std::size_t kLongest = 256;
        value.resize(startOf(value, kLongest).size());
        if (attribute.kind == Attribute::Kind::contains) {
            const auto parts = values(value);
            value = std::find(parts.begin(), parts.end(), attribute.value) != parts.end() ? "yes" : "";
        }
        result.push_back(std::move(value));
    }
    return result;
}

bool sameValue(const Attribute& attribute, std::string_view a, std::string_view b) {
    if (a == b) return true;
    switch (attribute.kind) {
        case Attribute::Kind::text:
        case Attribute::Kind::contains:
            return false;
        case Attribute::Kind::time: {
            const auto x = momentOf(a);
            const auto y = momentOf(b);
            return x && y && x->day.has_value() == y->day.has_value() && x->seconds == y->seconds;
        }
        case Attribute::Kind::number:
            return sameNumber(attribute, a, b);
        case Attribute::Kind::numbers: {
            const auto x = values(a);
            const auto y = values(b);
            return x.size() == y.size() &&
                   std::equal(x.begin(), x.end(), y.begin(), [&](std::string_view p, std::string_view q) {
                       return sameNumber(attribute, p, q);
                   });
        }
    }
    return false;
}

std::optional<double> numberOf(std::string_view text) {
    return finiteNumber(text.substr(0, text.find('\\')));
}

}  // namespace macula::dicom
