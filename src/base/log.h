// The log, for the people who run and support Macula. Patient data never enters it: paths, names and
// identifiers are wrapped in Sensitive, which prints a short digest instead, so that two lines about the same
// thing can still be matched.
#pragma once

#include <fmt/format.h>

#include <functional>
#include <string>
#include <string_view>

namespace macula::log {

enum class Level { debug, info, warning, error, off };

// The level at start is that of MACULA_LOG=debug|info|warning|error|off, or `warning`. Lines go to stderr, or
// to the sink. Thread-safe.
void setLevel(Level level);
void write(Level level, std::string_view line);
// Writes, at any level, something that the reader of a result must know. stderr gets the line without a time,
// the sink as level info.
void announce(std::string_view line);

// Receives the log instead of stderr, for a host program that uses Macula as a library and owns stderr. Any
// thread may call it, never two at once; it must not log or throw. Empty: the log goes to stderr.
using Sink = std::function<void(Level level, std::string_view line)>;
void setSink(Sink sink);
bool hasSink();

// Text that may name a patient: a path, a description, a UID. Formats as "<8 hex digits>", the same for the
// same text in one run of the program; each run has a new random key, so the digest cannot be looked up
// afterwards.
struct Sensitive {
    std::string_view text;
};
std::string redact(std::string_view text);

template <class... Args>
void debug(fmt::format_string<Args...> format, Args&&... args) {
    write(Level::debug, fmt::format(format, std::forward<Args>(args)...));
}
template <class... Args>
void info(fmt::format_string<Args...> format, Args&&... args) {
    write(Level::info, fmt::format(format, std::forward<Args>(args)...));
}
template <class... Args>
void warning(fmt::format_string<Args...> format, Args&&... args) {
    write(Level::warning, fmt::format(format, std::forward<Args>(args)...));
}
template <class... Args>
void error(fmt::format_string<Args...> format, Args&&... args) {
    write(Level::error, fmt::format(format, std::forward<Args>(args)...));
}

}  // namespace macula::log

template <>
struct fmt::formatter<macula::log::Sensitive> : fmt::formatter<std::string_view> {
    template <class Context>
    auto format(const macula::log::Sensitive& value, Context& context) const {
        return fmt::format_to(context.out(), "<{}>", macula::log::redact(value.text));
    }
};
