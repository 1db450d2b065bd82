#include "study/list/search_text.h"

#include <algorithm>
#include <array>
#include <cstdint>

namespace macula::study {

namespace {

// U+00C0 to U+017F; digits stand for pairs of letters, and * and / for × and ÷.
constexpr std::string_view kLatin =
    "aaaaaa1ceeeeiiii"
    "dnooooo*ouuuuy43"
    "aaaaaa1ceeeeiiii"
    "dnooooo/ouuuuy4y"
    "aaaaaaccccccccdd"
    "ddeeeeeeeeeegggg"
    "gggghhhhiiiiiiii"
    "ii55jjkkklllllll"
    "lllnnnnnnnnnoooo"
    "oo22rrrrrrssssss"
    "ssttttttuuuuuuuu"
    "uuuuwwyyyzzzzzzs";
constexpr char32_t kFirstLatin = 0xC0;
static_assert(kLatin.size() == 0x180 - kFirstLatin);

struct Range {
    char32_t first;
    char32_t last;
    char32_t to;
};

// Letters with diacritics in other ranges: Vietnamese, Romanian, Pinyin, Greek and Cyrillic.
constexpr std::array kRanges = std::to_array<Range>({
    {0x1A0, 0x1A1, 'o'},   {0x1AF, 0x1B0, 'u'},   {0x1CD, 0x1CE, 'a'},   {0x1CF, 0x1D0, 'i'},
    {0x1D1, 0x1D2, 'o'},   {0x1D3, 0x1DC, 'u'},   {0x218, 0x219, 's'},   {0x21A, 0x21B, 't'},
    {0x386, 0x386, 0x3B1}, {0x388, 0x388, 0x3B5}, {0x389, 0x389, 0x3B7}, {0x38A, 0x38A, 0x3B9},
    {0x38C, 0x38C, 0x3BF}, {0x38E, 0x38E, 0x3C5}, {0x38F, 0x38F, 0x3C9}, {0x390, 0x390, 0x3B9},
    {0x3AA, 0x3AA, 0x3B9}, {0x3AB, 0x3AB, 0x3C5}, {0x3AC, 0x3AC, 0x3B1}, {0x3AD, 0x3AD, 0x3B5},
    {0x3AE, 0x3AE, 0x3B7}, {0x3AF, 0x3AF, 0x3B9}, {0x3B0, 0x3B0, 0x3C5}, {0x3C2, 0x3C2, 0x3C3},
    {0x3CA, 0x3CA, 0x3B9}, {0x3CB, 0x3CB, 0x3C5}, {0x3CC, 0x3CC, 0x3BF}, {0x3CD, 0x3CD, 0x3C5},
    {0x3CE, 0x3CE, 0x3C9}, {0x439, 0x439, 0x438}, {0x450, 0x451, 0x435}, {0x453, 0x453, 0x433},
    {0x457, 0x457, 0x456}, {0x45C, 0x45C, 0x43A}, {0x45D, 0x45D, 0x438}, {0x45E, 0x45E, 0x443},
    {0x1EA0, 0x1EB7, 'a'}, {0x1EB8, 0x1EC7, 'e'}, {0x1EC8, 0x1ECB, 'i'}, {0x1ECC, 0x1EE3, 'o'},
    {0x1EE4, 0x1EF1, 'u'}, {0x1EF2, 0x1EF9, 'y'}, {0xA0, 0xA0, ' '},     {0x3000, 0x3000, ' '},
});

// The character at the start of `text`, and its length; not valid for a byte that begins no character.
struct Character {
    char32_t code = 0;
    std::size_t bytes = 1;
    bool isValid = false;
};

Character firstOf(std::string_view text) {
    const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
    const unsigned lead = byte(0);
    if (lead < 0x80) return {lead, 1, true};
    const std::size_t bytes = lead >= 0xF0 ? 4 : lead >= 0xE0 ? 3 : 2;
    if (lead < 0xC2 || lead > 0xF4 || text.size() < bytes) return {};
    char32_t code = lead & (0x7Fu >> bytes);
    for (std::size_t i = 1; i < bytes; ++i) {
        if ((byte(i) & 0xC0u) != 0x80u) return {};
        code = code << 6 | (byte(i) & 0x3Fu);
    }
    return {code, bytes, true};
}

void append(std::string& text, char32_t code) {
    const auto put = [&](char32_t byte) { text += static_cast<char>(static_cast<unsigned char>(byte)); };
    const auto more = [&](int shift) { put(0x80 | (code >> shift & 0x3F)); };
    if (code < 0x80) return put(code);
    if (code < 0x800) return put(0xC0 | code >> 6), more(0);
    if (code < 0x10000) return put(0xE0 | code >> 12), more(6), more(0);
    put(0xF0 | code >> 18);
    for (const int shift : {12, 6, 0}) more(shift);
}

char32_t inLowerCase(char32_t code) {
    if (code >= 0xFF01 && code <= 0xFF5E) code -= 0xFEE0;  // full-width ASCII
    if (code >= 'A' && code <= 'Z') return code + 0x20;
    if (code >= 0x391 && code <= 0x3A9) return code + 0x20;  // Greek
    if (code >= 0x400 && code <= 0x40F) return code + 0x50;  // Cyrillic
    if (code >= 0x410 && code <= 0x42F) return code + 0x20;
    return code;
}

void appendFolded(std::string& text, char32_t code) {
    if (code >= 0x300 && code <= 0x36F) return;  // combining diacritics
    if (code >= kFirstLatin && code < kFirstLatin + kLatin.size()) {
        switch (const char letter = kLatin[code - kFirstLatin]) {
            case '1':
                text += "ae";
                return;
            case '2':
                text += "oe";
                return;
            case '3':
                text += "ss";
                return;
            case '4':
                text += "th";
                return;
            case '5':
                text += "ij";
                return;
            case '*':
            case '/':
                append(text, code);
                return;
            default:
                text += letter;
                return;
        }
    }
    code = inLowerCase(code);
    for (const Range& range : kRanges) {
        if (range.first <= code && code <= range.last) return append(text, range.to);
    }
    append(text, code);
}

bool separates(char c) {
    return std::string_view(" \t\r\n\v\f,^=").find(c) != std::string_view::npos;
}

}  // namespace

std::string foldedForSearch(std::string_view utf8) {
    std::string text;
    text.reserve(utf8.size());
    while (!utf8.empty()) {
        const Character character = firstOf(utf8);
        if (character.isValid) {
            appendFolded(text, character.code);
        } else {
            text += utf8.front();
        }
        utf8.remove_prefix(character.bytes);
    }
    return text;
}

std::vector<std::string> searchWords(std::string_view typed) {
    const std::string text = foldedForSearch(typed);
    std::vector<std::string> words;
    for (auto at = text.begin(); at != text.end();) {
        at = std::find_if_not(at, text.end(), separates);
        const auto end = std::find_if(at, text.end(), separates);
        if (at != end) words.emplace_back(at, end);
        at = end;
    }
    return words;
}

bool holdsAll(std::string_view folded, const std::vector<std::string>& words) {
    return std::all_of(words.begin(), words.end(),
                       [&](const std::string& word) { return folded.find(word) != std::string_view::npos; });
}

}  // namespace macula::study
