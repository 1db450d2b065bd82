#include "dicom/character_set.h"

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dcspchrs.h>
#include <iconv.h>

#include <algorithm>
#include <optional>

namespace macula::dicom {

namespace {

std::string utf8FromLatin1(std::string_view text) {
    std::string result;
    for (const char c : text) {
        const auto byte = static_cast<unsigned char>(c);
        if (byte < 0x80) {
            result += c;
        } else {
            result += static_cast<char>(0xC0 | (byte >> 6));
            result += static_cast<char>(0x80 | (byte & 0x3F));
        }
    }
    return result;
}

// Japanese in JIS X 0208, which DCMTK cannot convert with the iconv of the GNU C library: it asks for the
// bare character set, and glibc has only the encoding around it. The escape sequences are the same (PS3.5
// annex H).
std::optional<std::string> utf8FromIso2022Jp(std::string_view text) {
    const iconv_t converter = iconv_open("UTF-8", "ISO-2022-JP-2");
    if (converter == reinterpret_cast<iconv_t>(-1)) return {};
    std::string input(text);
    std::string output(4 * text.size() + 16, '\0');
    char* from = input.data();
    char* to = output.data();
    std::size_t fromLeft = input.size();
    std::size_t toLeft = output.size();
    const std::size_t failed = iconv(converter, &from, &fromLeft, &to, &toLeft);
    iconv_close(converter);
    if (failed == static_cast<std::size_t>(-1)) return {};
    output.resize(output.size() - toLeft);
    return output;
}

}  // namespace

std::string utf8Of(std::string_view text, std::string_view declared) {
    const auto needsConversion = [](char c) { return static_cast<unsigned char>(c) >= 0x80 || c == '\x1B'; };
    if (std::none_of(text.begin(), text.end(), needsConversion)) return std::string(text);
    if (declared == "ISO_IR 192") return std::string(text);
    DcmSpecificCharacterSet converter;
    OFString converted;
    if (!declared.empty() && converter.selectCharacterSet(std::string(declared).c_str()).good() &&
        converter.convertString(OFString(text.data(), text.size()), converted, "\\^=").good()) {
        return std::string(converted.c_str(), converted.size());
    }
    if (declared.find("ISO 2022 IR 87") != std::string_view::npos) {
        if (auto japanese = utf8FromIso2022Jp(text)) return *japanese;
    }
    // Unknown or missing character set: legible in most of the West, and valid UTF-8.
    return utf8FromLatin1(text);
}

}  // namespace macula::dicom
