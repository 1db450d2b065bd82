#include "dicom/read/values.h"

#include <fmt/format.h>

#include <bit>
#include <cstring>

namespace macula::dicom {

namespace {

template <class T>
T numberAt(std::string_view bytes, bool bigEndian) {
    std::uint64_t bits = 0;
    for (std::size_t i = 0; i < sizeof(T); ++i) {
        const std::size_t from = bigEndian ? i : sizeof(T) - 1 - i;
        bits = bits << 8 | static_cast<unsigned char>(bytes[from]);
    }
    if constexpr (sizeof(T) == 8) return std::bit_cast<T>(bits);
    if constexpr (sizeof(T) == 4) return std::bit_cast<T>(static_cast<std::uint32_t>(bits));
    if constexpr (sizeof(T) == 2) return std::bit_cast<T>(static_cast<std::uint16_t>(bits));
}

template <class T>
std::vector<double> numbersAs(std::string_view bytes, bool bigEndian) {
    std::vector<double> values;
    if (bytes.size() % sizeof(T) != 0) return values;
    values.reserve(bytes.size() / sizeof(T));
    for (std::size_t at = 0; at < bytes.size(); at += sizeof(T))
        values.push_back(static_cast<double>(numberAt<T>(bytes.substr(at, sizeof(T)), bigEndian)));
    return values;
}

}  // namespace

bool isTextVr(Vr vr) {
    switch (vr) {
        case vrOf("AE"):
        case vrOf("AS"):
        case vrOf("CS"):
        case vrOf("DA"):
        case vrOf("DS"):
        case vrOf("DT"):
        case vrOf("IS"):
        case vrOf("TM"):
        case vrOf("UI"):
        case vrOf("UR"):
            return true;
        default:
            return usesCharacterSet(vr);
    }
}

bool usesCharacterSet(Vr vr) {
    switch (vr) {
        case vrOf("LO"):
        case vrOf("LT"):
        case vrOf("PN"):
        case vrOf("SH"):
        case vrOf("ST"):
        case vrOf("UC"):
        case vrOf("UT"):
            return true;
        default:
            return false;
    }
}

std::vector<std::string_view> splitAtBackslash(std::string_view text) {
    std::vector<std::string_view> parts;
    for (std::size_t begin = 0;;) {
        const std::size_t end = text.find('\\', begin);
        parts.push_back(trimmed(text.substr(begin, end == std::string_view::npos ? end : end - begin)));
        if (end == std::string_view::npos) return parts;
        begin = end + 1;
    }
}

std::vector<double> binaryNumbers(Vr vr, std::string_view bytes, bool bigEndian) {
    switch (vr) {
        case vrOf("US"):
            return numbersAs<std::uint16_t>(bytes, bigEndian);
        case vrOf("SS"):
            return numbersAs<std::int16_t>(bytes, bigEndian);
        case vrOf("UL"):
            return numbersAs<std::uint32_t>(bytes, bigEndian);
        case vrOf("SL"):
            return numbersAs<std::int32_t>(bytes, bigEndian);
        case vrOf("UV"):
            return numbersAs<std::uint64_t>(bytes, bigEndian);
        case vrOf("SV"):
            return numbersAs<std::int64_t>(bytes, bigEndian);
        case vrOf("FL"):
        case vrOf("OF"):
            return numbersAs<float>(bytes, bigEndian);
        case vrOf("FD"):
        case vrOf("OD"):
            return numbersAs<double>(bytes, bigEndian);
        default:
            return {};
    }
}

std::vector<std::uint16_t> binaryWords(Vr vr, std::string_view bytes, bool bigEndian) {
    const bool ofBytes = vr == vrOf("OB") || vr == 0;
    if (!ofBytes && vr != vrOf("US") && vr != vrOf("SS") && vr != vrOf("OW") && vr != kVrUnsignedOrSigned)
        return {};
    std::vector<std::uint16_t> words(bytes.size() / 2);
    for (std::size_t i = 0; i < words.size(); ++i)
        words[i] = numberAt<std::uint16_t>(bytes.substr(2 * i, 2), bigEndian && !ofBytes);
    return words;
}

std::string textOfBinary(Vr vr, std::string_view bytes, bool bigEndian) {
    std::string text;
    if (vr == vrOf("AT")) {
        for (std::size_t at = 0; at + 4 <= bytes.size(); at += 4) {
            if (!text.empty()) text += '\\';
            text += fmt::format("({:04X},{:04X})", numberAt<std::uint16_t>(bytes.substr(at, 2), bigEndian),
                                numberAt<std::uint16_t>(bytes.substr(at + 2, 2), bigEndian));
        }
        return text;
    }
    const bool single = vr == vrOf("FL") || vr == vrOf("OF");
    for (const double value : binaryNumbers(vr, bytes, bigEndian)) {
        if (!text.empty()) text += '\\';
        text += single ? fmt::format("{}", static_cast<float>(value)) : fmt::format("{}", value);
    }
    return text;
}

bool isUid(std::string_view text) {
    constexpr std::size_t kMostBytes = 64;
    return !text.empty() && text.size() <= kMostBytes &&
           text.find_first_not_of("0123456789.") == std::string_view::npos && text.front() != '.';
}

}  // namespace macula::dicom
