// A text for a person, which can be said in any language: an English format and what is put into it.
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

// How a value is kept: numbers as std::int64_t or double, a Text as it is, all else as std::string. A float
// has other digits as a double, so callers convert it themselves.
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
// What fmt checks a format against: a Text is said before it is put in.
template <class T>
using Checked = std::conditional_t<std::is_same_v<Kept<T>, Text>, std::string, Kept<T>>;

}  // namespace detail

// The format is the key of translations: src/viewer/translations has a row for each. Places are those of fmt,
// numbered or by name; a translation may put them in another order. A text without arguments has no places,
// and braces stand for themselves. No patient data in formats, which go into the program's text files, nor in
// what is said of an error.
class Text {
  public:
    Text() = default;
    explicit Text(const char* words);  // a literal
    template <class First, class... Rest>
    explicit Text(fmt::format_string<detail::Checked<First>, detail::Checked<Rest>...> format, First&& first,
                  Rest&&... rest);

    // A format that is not known where this is compiled, of a catalogue.
    static Text of(std::string_view format, std::vector<TextArgument> arguments);
    // Words that are in no language of ours: a name, a title of a file, what a library says.
    static Text verbatim(std::string_view words);
    // Several, with what stands between: ", " or a space.
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
    std::string name;  // empty: by its place in the list
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

// Puts what `say` makes of each argument into the places of a format. `spec` is what stands behind the colon
// there, as in "{:.1f}". A place without an argument is left as it stands, since a translation may be wrong.
using SayArgument = std::function<std::string(const TextArgument&, std::string_view spec)>;
std::string filled(std::string_view format, std::span<const TextArgument> arguments, const SayArgument& say);

// An argument in English; in other languages a number too, but for its decimal sign.
std::string englishOf(const TextArgument& argument, std::string_view spec);

std::ostream& operator<<(std::ostream& out, const Text& text);  // in English

}  // namespace macula
