// A text for a person, which can be translated: an English format and its arguments.
#pragma once

#include <fmt/core.h>

#include <concepts>
#include <cstdint>
#include <functional>
#include <iosfwd>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

namespace macula {

struct TextArgument;
class Text;

namespace detail {

// How an argument is stored: numbers as std::int64_t or double, a Text as it is, everything else as
// std::string. A float would print other digits as a double, so callers convert it themselves.
template <class T>
struct KeptAs {
    static_assert(!std::is_same_v<T, float> && !std::is_same_v<T, bool> && !std::is_same_v<T, char>);
    using Type = std::string;
};
template <std::integral T>
requires(!std::is_same_v<T, bool> && !std::is_same_v<T, char>) struct KeptAs<T> {
    using Type = std::int64_t;
};
template <>
struct KeptAs<double> {
    using Type = double;
};
template <>
struct KeptAs<Text> {
    using Type = Text;
};
template <class T>
using Kept = typename KeptAs<std::remove_cvref_t<T>>::Type;
// The types that fmt checks a format against: a Text counts as a string, since it is put into words first.
template <class T>
using Checked = std::conditional_t<std::is_same_v<Kept<T>, Text>, std::string, Kept<T>>;

}  // namespace detail

// The format is the key of translations: src/viewer/translations has a row for each. Placeholders are those
// of fmt, numbered or named; a translation may reorder them. A text without arguments has no placeholders,
// and its braces stand for themselves. Formats must hold no patient data, because they go into the program's
// text files; neither must the texts of an error.
class Text {
  public:
    Text() = default;
    explicit Text(const char* words);  // a literal
    template <class First, class... Rest>
    explicit Text(fmt::format_string<detail::Checked<First>, detail::Checked<Rest>...> format, First&& first,
                  Rest&&... rest);

    // For a format that is not known at compile time, such as one from a catalogue.
    static Text of(std::string_view format, std::vector<TextArgument> arguments);
    // Words that are never translated: a name, the title of a file, a message from a library.
    static Text verbatim(std::string_view words);
    // Joins the texts that are not empty, with ", " or a space, say, between them.
    static Text joined(std::vector<Text> texts, std::string_view between);

    const std::string& format() const { return format_; }
    const std::vector<TextArgument>& arguments() const { return arguments_; }
    bool empty() const { return format_.empty(); }

    std::string english() const;

    bool operator==(const Text& other) const;
    bool operator==(std::string_view english) const { return this->english() == english; }

  private:
    std::string format_;
    std::vector<TextArgument> arguments_;
};

struct TextArgument {
    std::string name;  // empty: the argument is found by its position in the list
    std::variant<std::int64_t, double, std::string, Text> value;

    bool operator==(const TextArgument&) const = default;
};

template <class First, class... Rest>
Text::Text(fmt::format_string<detail::Checked<First>, detail::Checked<Rest>...> format, First&& first,
           Rest&&... rest)
    : format_(fmt::string_view(format).data(), fmt::string_view(format).size()) {
    arguments_.reserve(1 + sizeof...(rest));
    arguments_.push_back({{}, detail::Kept<First>(std::forward<First>(first))});
    (arguments_.push_back({{}, detail::Kept<Rest>(std::forward<Rest>(rest))}), ...);
}

// Replaces each placeholder of a format by what `say` returns for its argument. `spec` is the part of the
// placeholder after the colon, as in "{:.1f}". A placeholder without an argument is left as it stands, since
// a translation may be wrong.
using SayArgument = std::function<std::string(const TextArgument&, std::string_view spec)>;
std::string filled(std::string_view format, std::span<const TextArgument> arguments, const SayArgument& say);

// An argument in English. Other languages use this for numbers too, and change only the decimal sign.
std::string englishOf(const TextArgument& argument, std::string_view spec);

std::ostream& operator<<(std::ostream& out, const Text& text);  // in English

}  // namespace macula
