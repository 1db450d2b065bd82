#include "dicom/write/decimal_string.h"

#include <fmt/format.h>

namespace macula::dicom {

namespace {

constexpr std::size_t kMostCharacters = 16;

}  // namespace

std::string decimalString(double value) {
    if (value == 0.0) return "0";  // and no "-0"
    for (int digits = 17; digits > 1; --digits) {
        std::string text = fmt::format("{:.{}g}", value, digits);
        if (text.size() <= kMostCharacters) return text;
    }
    return fmt::format("{:.2g}", value);
}

}  // namespace macula::dicom
