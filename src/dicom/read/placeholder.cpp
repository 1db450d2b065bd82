#include "dicom/read/placeholder.h"

#include <algorithm>
#include <array>
#include <string>
#include <vector>

namespace macula::dicom {

namespace {

// In lower case, letters and digits only: English words that programs write, and those of other languages.
constexpr std::array<std::string_view, 50> kOfNobody{
    "anon",          "anonym",       "anonyme",      "anonymes",     "anonymi",       "anonymise",
    "anonymised",    "anonymisiert", "anonymized",   "anonymizado",  "anonymizzato",  "anonymous",
    "anonymus",      "anonimo",      "anonimizado",  "anonimizzato", "blank",         "blinded",
    "deid",          "deident",      "deidentified", "deleted",      "desconocido",   "empty",
    "hidden",        "inconnu",      "masked",       "na",           "nil",           "nobody",
    "noid",          "noname",       "none",         "nopatientid",  "nopatientname", "notavailable",
    "notapplicable", "notgiven",     "notknown",     "null",         "redacted",      "removed",
    "sconosciuto",   "unbekannt",    "undefined",    "unidentified", "unknown",       "unnamed",
    "unspecified",   "withheld"};

// Words that name nobody either, and accompany those above: "Patient^Anonymous".
constexpr std::array<std::string_view, 8> kBesideThem{"id",  "mr",      "mrs",    "name",
                                                      "mrn", "patient", "person", "subject"};

template <std::size_t Count>
bool isOneOf(const std::array<std::string_view, Count>& words, std::string_view word) {
    return std::ranges::find(words, word) != words.end();
}

// Splits text into words of letters and digits; everything beyond ASCII counts as a letter.
std::vector<std::string> wordsOf(std::string_view text) {
    std::vector<std::string> words(1);
    for (const char c : text) {
        const bool isUpper = c >= 'A' && c <= 'Z';
        const bool isKept = isUpper || (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || (c & 0x80) != 0;
        if (isKept)
            words.back() += isUpper ? char(c - 'A' + 'a') : c;
        else if (!words.back().empty())
            words.emplace_back();
    }
    if (words.back().empty()) words.pop_back();
    return words;
}

// "0", "000-000", "XXXX", "x^x".
bool isFiller(std::string_view text) {
    return text.find_first_not_of('0') == std::string_view::npos ||
           text.find_first_not_of('x') == std::string_view::npos;
}

}  // namespace

bool isPlaceholder(std::string_view text) {
    const std::vector<std::string> words = wordsOf(text);
    std::string all;
    for (const std::string& word : words) all += word;
    if (isFiller(all) || isOneOf(kOfNobody, all)) return true;  // an empty text is filler too
    return std::ranges::all_of(words, [](const std::string& word) {
        return isOneOf(kOfNobody, word) || isOneOf(kBesideThem, word);
    });
}

bool isPlaceholderDate(std::string_view date) {
    std::string digits;
    for (const char c : date)
        if (c != '.' && c != ' ' && c != '\0') digits += c;
    const auto isDigit = [](char c) { return c >= '0' && c <= '9'; };
    if (digits.size() != 8 || !std::ranges::all_of(digits, isDigit)) return true;
    constexpr std::string_view kNobodyIsOlder = "18800101";
    return digits < kNobodyIsOlder || digits == "18991230" || digits == "18991231" || digits == "19000101" ||
           digits.substr(4, 2) == "00" || digits.substr(4, 2) > "12" || digits.substr(6) == "00" ||
           digits.substr(6) > "31" || digits >= "99990101";
}

}  // namespace macula::dicom
