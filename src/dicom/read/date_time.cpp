#include "dicom/read/date_time.h"

#include <charconv>
#include <chrono>
#include <string>

namespace macula::dicom {

namespace {

std::string_view trimmed(std::string_view text) {
    while (!text.empty() && (text.front() == ' ' || text.front() == '\0')) text.remove_prefix(1);
    while (!text.empty() && (text.back() == ' ' || text.back() == '\0')) text.remove_suffix(1);
    return text;
}

// All of `digits`, which are digits only.
std::optional<int> number(std::string_view digits) {
    int value = 0;
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
    if (digits.empty() || digits.front() == '-' || error != std::errc() ||
        end != digits.data() + digits.size()) {
        return {};
    }
    return value;
}

}  // namespace

std::optional<double> secondsOfTime(std::string_view time) {
    std::string digits;
    for (const char c : trimmed(time)) {
        if (c != ':') digits += c;
    }
    const std::size_t point = digits.find('.');
    const std::string_view whole = std::string_view(digits).substr(0, point);
    if (whole.size() != 2 && whole.size() != 4 && whole.size() != 6) return {};
    if (point != std::string::npos && whole.size() != 6) return {};
    const auto part = [&](std::size_t at) { return at < whole.size() ? number(whole.substr(at, 2)) : 0; };
    const auto hours = part(0);
    const auto minutes = part(2);
    const auto seconds = part(4);
    if (!hours || !minutes || !seconds || *hours > 23 || *minutes > 59 || *seconds > 60) return {};
    double fraction = 0.0;
    if (point != std::string::npos && point + 1 < digits.size()) {
        double unit = 0.1;
        for (const char c : digits.substr(point + 1)) {
            if (c < '0' || c > '9') return {};
            fraction += unit * (c - '0');
            unit /= 10.0;
        }
    }
    return 3600.0 * *hours + 60.0 * *minutes + *seconds + fraction;
}

std::optional<long> daysOfDate(std::string_view date) {
    date = trimmed(date);
    std::string digits;
    for (const char c : date) {
        if (c != '.') digits += c;
    }
    if (digits.size() != 8) return {};
    const std::string_view d = digits;
    const auto year = number(d.substr(0, 4));
    const auto month = number(d.substr(4, 2));
    const auto day = number(d.substr(6, 2));
    if (!year || !month || !day) return {};
    const std::chrono::year_month_day ymd{std::chrono::year(*year),
                                          std::chrono::month(static_cast<unsigned>(*month)),
                                          std::chrono::day(static_cast<unsigned>(*day))};
    if (!ymd.ok()) return {};
    return std::chrono::sys_days(ymd).time_since_epoch().count();
}

std::optional<double> secondsOfDateTime(std::string_view dateTime) {
    dateTime = trimmed(dateTime);
    dateTime = dateTime.substr(0, dateTime.find_first_of("+-"));
    if (dateTime.size() < 8) return {};
    const auto days = daysOfDate(dateTime.substr(0, 8));
    const auto seconds = dateTime.size() > 8 ? secondsOfTime(dateTime.substr(8)) : 0.0;
    if (!days || !seconds) return {};
    return 86400.0 * double(*days) + *seconds;
}

std::optional<double> secondsOfEither(std::string_view text) {
    constexpr std::size_t kMostOfTime = 6;  // HHMMSS
    return text.find_first_not_of("0123456789") <= kMostOfTime || text.size() <= kMostOfTime
               ? secondsOfTime(text)
               : secondsOfDateTime(text);
}

}  // namespace macula::dicom
