#include "live/store/byte_size.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <utility>

#include "base/parsing.h"

namespace macula::live {

namespace {

constexpr double kMostBytes = 9e18;  // below 2^63, the limit of the database's integers

constexpr std::array<std::pair<std::string_view, double>, 9> kUnits{{{"b", 1.0},
                                                                     {"kb", 1e3},
                                                                     {"mb", 1e6},
                                                                     {"gb", 1e9},
                                                                     {"tb", 1e12},
                                                                     {"kib", 1024.0},
                                                                     {"mib", 1048576.0},
                                                                     {"gib", 1073741824.0},
                                                                     {"tib", 1099511627776.0}}};

std::string inSmallLetters(std::string_view text) {
    std::string small(text);
    std::ranges::transform(small, small.begin(),
                           [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return small;
}

}  // namespace

std::string sizeForPeople(std::uint64_t bytes) {
    if (bytes == 0) return "0 MB";
    if (bytes < 50'000) return "under 0.1 MB";
    const auto withUnit = [](double number, const char* unit) {
        return number < 9.95 ? fmt::format("{:.1f} {}", number, unit)
                             : fmt::format("{:.0f} {}", number, unit);
    };
    const double megabytes = static_cast<double>(bytes) / 1e6;
    return megabytes < 999.5 ? withUnit(megabytes, "MB") : withUnit(megabytes / 1e3, "GB");
}

std::optional<std::uint64_t> bytesOfText(std::string_view text) {
    text = trimmed(text);
    const std::size_t end = std::min(text.find_first_not_of("0123456789."), text.size());
    const std::string_view number = text.substr(0, end);
    const std::string unit = inSmallLetters(trimmed(text.substr(end)));
    const auto known = std::ranges::find(kUnits, unit, [](const auto& one) { return one.first; });
    const auto value = finiteNumber(number);
    if (known == kUnits.end() || !value || *value * known->second > kMostBytes) return {};
    return static_cast<std::uint64_t>(*value * known->second);
}

}  // namespace macula::live
