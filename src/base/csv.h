// Fields of comma-separated values (RFC 4180).
#pragma once

#include <string>
#include <string_view>

namespace macula {

// Quoted where it has to be.
inline std::string csvField(std::string_view text) {
    if (text.find_first_of(",\"\r\n") == std::string_view::npos) return std::string(text);
    std::string quoted = "\"";
    for (const char c : text) {
        if (c == '"') quoted += c;
        quoted += c;
    }
    return quoted + '"';
}

// What a person typed, with an apostrophe before what a spreadsheet would take for a formula: it recognises
// one by its first character, some after blanks, and also within quotes.
inline std::string csvWords(std::string_view text) {
    const std::size_t first = text.find_first_not_of(' ');
    const bool isFormula =
        first != std::string_view::npos && std::string_view("=+-@\t\r\n").find(text[first]) != text.npos;
    return csvField((isFormula ? "'" : "") + std::string(text));
}

}  // namespace macula
