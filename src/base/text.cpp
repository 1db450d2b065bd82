#include "base/text.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <ostream>

namespace macula {

namespace {

// A placeholder of a format, or an escaped brace.
struct Place {
    std::size_t begin, end;  // in the format, including the braces; equal at the end of the format
    const TextArgument* argument = nullptr;
    std::string_view spec;  // without an argument: the text to put there
};

const TextArgument* argumentAt(std::string_view id, std::span<const TextArgument> arguments,
                               std::size_t& unnumbered) {
    if (id.empty()) {
        const std::size_t number = unnumbered++;
        return number < arguments.size() ? &arguments[number] : nullptr;
    }
    std::size_t number = 0;
    const auto [end, failed] = std::from_chars(id.data(), id.data() + id.size(), number);
    if (failed == std::errc() && end == id.data() + id.size())
        return number < arguments.size() ? &arguments[number] : nullptr;
    const auto named =
        std::ranges::find_if(arguments, [&](const TextArgument& argument) { return argument.name == id; });
    return named == arguments.end() ? nullptr : &*named;
}

Place nextPlace(std::string_view format, std::size_t from, std::span<const TextArgument> arguments,
                std::size_t& unnumbered) {
    const std::size_t begin = std::min(format.find_first_of("{}", from), format.size());
    if (begin == format.size()) return {begin, begin};
    if (format.substr(begin + 1, 1) == format.substr(begin, 1))
        return {begin, begin + 2, nullptr, format.substr(begin, 1)};
    const std::size_t end = format.find('}', begin);
    if (end == std::string_view::npos || format[begin] == '}')
        return {begin, begin + 1, nullptr, format.substr(begin, 1)};
    const std::string_view within = format.substr(begin + 1, end - begin - 1);
    const std::size_t colon = std::min(within.find(':'), within.size());
    const TextArgument* argument = argumentAt(within.substr(0, colon), arguments, unnumbered);
    if (argument == nullptr) return {begin, end + 1, nullptr, format.substr(begin, end + 1 - begin)};
    return {begin, end + 1, argument, within.substr(std::min(colon + 1, within.size()))};
}

}  // namespace

Text::Text(const char* words) : format_(words) {}

Text Text::of(std::string_view format, std::vector<TextArgument> arguments) {
    Text text;
    text.format_ = format;
    text.arguments_ = std::move(arguments);
    return text;
}

Text Text::verbatim(std::string_view words) {
    return words.empty() ? Text() : of("{}", {{{}, std::string(words)}});
}

Text Text::joined(std::vector<Text> texts, std::string_view between) {
    std::erase_if(texts, [](const Text& text) { return text.empty(); });
    if (texts.empty()) return {};
    if (texts.size() == 1) return std::move(texts.front());
    std::string format;
    std::vector<TextArgument> arguments;
    for (Text& text : texts) {
        format += format.empty() ? "{}" : std::string(between) + "{}";
        arguments.push_back({{}, std::move(text)});
    }
    return of(format, std::move(arguments));
}

std::string Text::english() const {
    return filled(format_, arguments_, englishOf);
}

bool Text::operator==(const Text& other) const {
    return format_ == other.format_ && arguments_ == other.arguments_;
}

std::string filled(std::string_view format, std::span<const TextArgument> arguments, const SayArgument& say) {
    if (arguments.empty()) return std::string(format);
    std::string all;
    std::size_t unnumbered = 0;
    for (std::size_t at = 0;;) {
        const Place place = nextPlace(format, at, arguments, unnumbered);
        all += format.substr(at, place.begin - at);
        if (place.begin == place.end) return all;
        all += place.argument != nullptr ? say(*place.argument, place.spec) : std::string(place.spec);
        at = place.end;
    }
}

std::string englishOf(const TextArgument& argument, std::string_view spec) {
    const std::string format = fmt::format("{{:{}}}", spec);
    try {
        if (const auto* text = std::get_if<Text>(&argument.value))
            return fmt::format(fmt::runtime(format), text->english());
        if (const auto* words = std::get_if<std::string>(&argument.value))
            return fmt::format(fmt::runtime(format), *words);
        if (const auto* number = std::get_if<double>(&argument.value))
            return fmt::format(fmt::runtime(format), *number);
        return fmt::format(fmt::runtime(format), std::get<std::int64_t>(argument.value));
    } catch (const fmt::format_error&) {  // a translation may have a wrong spec
        return fmt::format("{{:{}}}", spec);
    }
}

std::ostream& operator<<(std::ostream& out, const Text& text) {
    return out << text.english();
}

}  // namespace macula
