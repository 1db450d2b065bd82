#include "toolkit/character_set.h"

#include <dcmtk/config/osconfig.h>
#include <dcmtk/ofstd/ofchrenc.h>

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <vector>

#include "base/parsing.h"

namespace macula {

namespace {

constexpr std::string_view kReplacement = "\xEF\xBF\xBD";  // U+FFFD

// Names of the C library's encodings, static so that they can be compared by address; null is ASCII.
using Encoding = const char*;
constexpr Encoding kUtf8 = "UTF-8";
constexpr Encoding kGb18030 = "GB18030";
constexpr Encoding kLatin1 = "ISO-8859-1";
constexpr Encoding kKatakana = "katakana";  // the upper half of JIS X 0201, which is converted here
constexpr Encoding kJapanese = "EUC-JP";    // holds JIS X 0208 and 0212
constexpr Encoding kKorean = "UHC";         // holds KS X 1001
constexpr Encoding kChinese = "GBK";        // holds GB 2312

struct Term {
    std::string_view number;  // of the ISO registry, as in ISO_IR 100
    Encoding upperHalf;       // G1 at the beginning, and after a delimiter
    char final;               // the last byte of the escape sequence that designates it as G1
};

constexpr std::array kTerms = std::to_array<Term>({
    {"100", kLatin1, 'A'},
    {"101", "ISO-8859-2", 'B'},
    {"109", "ISO-8859-3", 'C'},
    {"110", "ISO-8859-4", 'D'},
    {"144", "ISO-8859-5", 'L'},
    {"127", "ISO-8859-6", 'G'},
    {"126", "ISO-8859-7", 'F'},
    {"138", "ISO-8859-8", 'H'},
    {"148", "ISO-8859-9", 'M'},
    {"203", "ISO-8859-15", 'b'},
    {"166", "TIS-620", 'T'},
    {"13", kKatakana, '\0'},
    {"149", kKorean, '\0'},
    {"58", kChinese, '\0'},
    {"192", kUtf8, '\0'},
});

// The encoding of a defined term, also as it is misspelt: ISO IR 100, ISO-IR-100, ISO_IR100, UTF-8,
// ISO8859-1. Nothing when unknown.
std::optional<Encoding> encodingOfTerm(std::string_view term) {
    std::string name;
    for (const char c : term) {
        if (c >= 'a' && c <= 'z') name += static_cast<char>(c - 'a' + 'A');
        if ((c >= '0' && c <= '9') || (c >= 'A' && c <= 'Z')) name += c;
    }
    if (name.empty() || name == "ISOIR6" || name == "ISO2022IR6" || name == "ASCII") return nullptr;
    if (name == "GB18030" || name == "GBK" || name == "GB2312") return kGb18030;
    if (name == "UTF8") return kUtf8;
    if (name == "ISO88591" || name == "LATIN1") return kLatin1;
    for (const std::string_view prefix : {"ISOIR", "ISO2022IR"}) {
        if (!name.starts_with(prefix)) continue;
        const std::string_view number = std::string_view(name).substr(prefix.size());
        if (number == "87" || number == "159") return nullptr;  // only used through escape sequences
        for (const Term& row : kTerms) {
            if (row.number == number) return row.upperHalf;
        }
    }
    return {};
}

std::vector<std::string_view> termsOf(std::string_view declared) {
    std::vector<std::string_view> terms;
    while (true) {
        const std::size_t end = declared.find('\\');
        terms.push_back(trimmed(declared.substr(0, end)));
        if (end == std::string_view::npos) return terms;
        declared.remove_prefix(end + 1);
    }
}

bool isJapanese(std::string_view declared) {
    for (const std::string_view value : termsOf(declared)) {
        if (value.ends_with("IR 13") || value.ends_with("IR 87") || value.ends_with("IR 159")) return true;
    }
    return false;
}

// Converts the whole text or nothing. Opening a converter takes longer than most texts.
std::optional<std::string> converted(std::string_view bytes, Encoding from, Encoding to = kUtf8) {
    thread_local std::map<std::pair<std::string_view, std::string_view>, OFCharacterEncoding> converters;
    const auto [entry, isNew] = converters.try_emplace({from, to});
    if (isNew) entry->second.selectEncoding(from, to);
    OFString text;
    if (!entry->second || entry->second.convertString(bytes.data(), bytes.size(), text).bad()) return {};
    return std::string(text.data(), text.length());
}

std::optional<std::string> katakana(std::string_view bytes) {
    std::string result;
    for (const char c : bytes) {
        const auto byte = static_cast<unsigned char>(c);
        if (byte < 0xA1 || byte > 0xDF) return {};
        const unsigned code = 0xFF61u + (byte - 0xA1u);
        result += static_cast<char>(0xE0 | code >> 12);
        result += static_cast<char>(0x80 | (code >> 6 & 0x3F));
        result += static_cast<char>(0x80 | (code & 0x3F));
    }
    return result;
}

// Converts bytes of one encoding; nothing if it has no such bytes. For kKatakana ASCII is invalid too.
std::optional<std::string> convert(std::string_view bytes, Encoding from) {
    if (from == nullptr) return {};
    if (from == kKatakana) return katakana(bytes);
    if (from == kUtf8) return isValidUtf8(bytes) ? std::optional(std::string(bytes)) : std::nullopt;
    const bool isLatin = std::string_view(from).starts_with("ISO-8859");
    const auto isC1 = [](char c) { return (static_cast<unsigned char>(c) & 0xE0) == 0x80; };
    if (isLatin && std::any_of(bytes.begin(), bytes.end(), isC1)) return {};  // no characters: PS3.5 6.1.3
    return converted(bytes, from);
}

// Decodes text as Latin-1, the last resort, which cannot fail. The 32 codes that are not characters in
// Latin-1 are those of Windows, which is where such text comes from.
std::string latin1(std::string_view bytes) {
    std::string result;
    for (const char c : bytes) {
        if (static_cast<unsigned char>(c) < 0x80) {
            result += c;
            continue;
        }
        const auto one = converted({&c, 1}, "CP1252");
        result += one ? *one : std::string(kReplacement);
    }
    return result;
}

// Decodes text that is whole except for its last character, which was cut off when a value was cut to its
// greatest length. Only if other such characters precede it: a single odd byte at the end is a letter of
// another alphabet.
std::optional<std::string> cutOff(std::string_view bytes, Encoding encoding) {
    const auto isAscii = [](char c) { return static_cast<unsigned char>(c) < 0x80; };
    for (std::size_t less = 1; less <= 3 && less < bytes.size(); ++less) {
        const std::string_view rest = bytes.substr(0, bytes.size() - less);
        if (isAscii(bytes[rest.size()]) || std::all_of(rest.begin(), rest.end(), isAscii)) continue;
        if (auto text = convert(rest, encoding)) return *text + std::string(kReplacement);
    }
    return {};
}

// Text with escape sequences, PS3.5 6.1.2.5 and PS3.3 tables C.12-3 and C.12-4.
class EscapedText {
  public:
    EscapedText(std::string_view bytes, Encoding first, std::vector<Encoding> others, bool japanese,
                Delimiters delimiters)
        : bytes_(bytes),
          first_(first),
          others_(std::move(others)),
          japanese_(japanese),
          delimiters_(delimiters) {
        reset();
    }

    DecodedText decode() {
        while (at_ < bytes_.size()) step();
        flush();
        return std::move(result_);
    }

  private:
    enum class Lower { ascii, katakana, kanji, moreKanji };

    void reset() {
        lower_ = Lower::ascii;
        upper_ = first_;
    }

    void step() {
        const char c = bytes_[at_];
        const auto byte = static_cast<unsigned char>(c);
        if (c == '\x1B') {
            escape();
        } else if (byte < 0x20) {
            flush();
            result_.utf8 += c;
            reset();
            ++at_;
        } else if (byte >= 0x80) {
            upper();
        } else if (lower_ == Lower::kanji || lower_ == Lower::moreKanji) {
            kanji();
        } else if (lower_ == Lower::katakana && byte > 0x20 && byte < 0x60) {
            add(kKatakana, bytes_.substr(at_, 1), 0x80);
        } else {
            flush();
            result_.utf8 += c;
            ++at_;
            const bool isDelimiter = (c == '\\' && delimiters_ != Delimiters::none) ||
                                     ((c == '^' || c == '=') && delimiters_ == Delimiters::ofPersonNames);
            if (isDelimiter) reset();
        }
    }

    void kanji() {
        if (at_ + 1 >= bytes_.size() || bytes_[at_] == ' ') {
            // A blank between two escape sequences, or half a character.
            flush();
            if (bytes_[at_] == ' ') {
                result_.utf8 += ' ';
            } else {
                undecodable();
            }
            ++at_;
            return;
        }
        if (lower_ == Lower::moreKanji) add(kJapanese, "\x8F", 0, 0);
        add(kJapanese, bytes_.substr(at_, 2), 0x80);
    }

    void upper() {
        Encoding encoding = upper_;
        if (encoding == nullptr) {
            // The escape sequence was not repeated after a delimiter, or is missing altogether.
            encoding = lastUpper_;
            for (const Encoding other : others_) {
                if (encoding == nullptr) encoding = other;
            }
            result_.fallback = true;
        }
        if (encoding == nullptr) {
            flush();
            undecodable();
            ++at_;
            return;
        }
        const bool twoBytes = encoding == kKorean || encoding == kChinese || encoding == kGb18030;
        add(encoding, bytes_.substr(at_, twoBytes ? 2 : 1), 0);
    }

    void escape() {
        flush();
        struct Sequence {
            std::string_view bytes;
            std::optional<Lower> lower;
            Encoding upper = nullptr;
        };
        static constexpr std::array kSequences = std::to_array<Sequence>({
            {"(B", Lower::ascii},
            {"(J", Lower::ascii},  // JIS X 0201, which differs in two signs that DICOM uses as in ASCII
            {"(I", Lower::katakana},
            {"$B", Lower::kanji},
            {"$@", Lower::kanji},
            {"$(D", Lower::moreKanji},
            {")I", {}, kKatakana},
            {"$)C", {}, kKorean},
            {"$)A", {}, kChinese},
        });
        const std::string_view rest = bytes_.substr(at_ + 1);
        for (const Sequence& sequence : kSequences) {
            if (!rest.starts_with(sequence.bytes)) continue;
            if (sequence.lower) {
                lower_ = *sequence.lower;
                if (lower_ != Lower::ascii && !japanese_) result_.fallback = true;
            }
            if (sequence.upper != nullptr) designate(sequence.upper);
            at_ += 1 + sequence.bytes.size();
            return;
        }
        for (const Term& term : kTerms) {
            if (rest.size() < 2 || rest[0] != '-' || term.final == '\0' || rest[1] != term.final) continue;
            designate(term.upperHalf);
            at_ += 3;
            return;
        }
        result_.fallback = true;  // an unknown sequence: not shown, and what follows is uncertain
        ++at_;
    }

    void designate(Encoding upper) {
        upper_ = lastUpper_ = upper;
        const bool isDeclared = upper == first_ || upper == kKatakana ||
                                std::find(others_.begin(), others_.end(), upper) != others_.end();
        if (!isDeclared) result_.fallback = true;
    }

    void add(Encoding encoding, std::string_view bytes, unsigned char high) {
        add(encoding, bytes, high, bytes.size());
    }
    void add(Encoding encoding, std::string_view bytes, unsigned char high, std::size_t taken) {
        if (encoding != runEncoding_) flush();
        runEncoding_ = encoding;
        for (const char c : bytes) run_ += static_cast<char>(static_cast<unsigned char>(c) | high);
        at_ += taken;
    }

    void flush() {
        if (run_.empty()) return;
        if (const auto text = convert(run_, runEncoding_)) {
            result_.utf8 += *text;
        } else {
            undecodable();
        }
        run_.clear();
        runEncoding_ = nullptr;
    }

    void undecodable() {
        if (!result_.utf8.ends_with(kReplacement)) result_.utf8 += kReplacement;
        result_.fallback = true;
    }

    std::string_view bytes_;
    Encoding first_;
    std::vector<Encoding> others_;
    bool japanese_;
    Delimiters delimiters_;
    std::size_t at_ = 0;
    Lower lower_ = Lower::ascii;
    Encoding upper_ = nullptr;      // G1 now
    Encoding lastUpper_ = nullptr;  // the last that an escape sequence designated
    Encoding runEncoding_ = nullptr;
    std::string run_;
    DecodedText result_;
};

DecodedText decode(std::string_view bytes, std::string_view declared, Delimiters delimiters) {
    // Converting goes once over all terms for each text; no real file declares a dozen.
    constexpr std::size_t kLongestDeclaration = 256;
    declared = declared.substr(0, kLongestDeclaration);
    const auto terms = termsOf(declared);
    const std::optional<Encoding> first = encodingOfTerm(terms.front());
    std::vector<Encoding> others;
    for (std::size_t i = 1; i < terms.size(); ++i) {
        if (const auto encoding = encodingOfTerm(terms[i]); encoding && *encoding != nullptr)
            others.push_back(*encoding);
    }
    if (bytes.find('\x1B') != std::string_view::npos)
        return EscapedText(bytes, first.value_or(nullptr), others, isJapanese(declared), delimiters).decode();
    // Text is not valid UTF-8 by accident: as Latin-1 it would be capital letters, each followed by signs
    // such as 1/4.
    if (first == kLatin1 && isValidUtf8(bytes)) return {std::string(bytes), true};
    const Encoding encoding = first.value_or(nullptr);
    if (encoding == kKatakana || encoding == kKorean || encoding == kChinese) {
        // Lower and upper half mixed, which the converters of the C library do not all allow.
        auto text = EscapedText(bytes, encoding, others, isJapanese(declared), delimiters).decode();
        if (!text.fallback) return text;
    } else if (encoding != nullptr) {
        if (auto text = convert(bytes, encoding)) return {*text, false};
        if (encoding == kUtf8 || encoding == kGb18030) {
            if (auto text = cutOff(bytes, encoding)) return {*text, true};
        }
    }
    if (isValidUtf8(bytes)) return {std::string(bytes), true};
    // The usual mistakes in Japanese text: no escape sequences, or the encoding of another operating system.
    if (isJapanese(declared)) {
        if (auto text = convert(bytes, "CP932")) return {*text, true};
    }
    for (const Encoding other : others) {
        if (other == kUtf8) continue;
        if (auto text = convert(bytes, other)) return {*text, true};
    }
    return {latin1(bytes), true};
}

// Removes control characters, which could change what a terminal or a log shows.
void dropControls(std::string& text) {
    const auto isUpperControl = [&](std::size_t i) {  // U+0080 to U+009F
        return text[i] == '\xC2' && i + 1 < text.size() && static_cast<unsigned char>(text[i + 1]) < 0xA0;
    };
    std::string kept;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const auto c = static_cast<unsigned char>(text[i]);
        if (isUpperControl(i)) {
            ++i;
        } else if ((c >= ' ' && c != 0x7F) || c == '\n' || c == '\r' || c == '\t' || c == '\f') {
            kept += text[i];
        }
    }
    text = std::move(kept);
}

}  // namespace

DecodedText decodeText(std::string_view bytes, std::string_view declared, Delimiters delimiters) {
    const auto isPlain = [](char c) { return c >= ' ' && c < 0x7F; };
    if (std::all_of(bytes.begin(), bytes.end(), isPlain)) return {std::string(bytes), false};
    DecodedText text;
    if (std::none_of(bytes.begin(), bytes.end(),
                     [](char c) { return static_cast<unsigned char>(c) >= 0x80 || c == '\x1B'; })) {
        text.utf8 = bytes;
    } else {
        text = decode(bytes, declared, delimiters);
    }
    dropControls(text.utf8);
    return text;
}

}  // namespace macula
