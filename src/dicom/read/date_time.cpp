#include "dicom/read/date_time.h"

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dcvrda.h>
#include <dcmtk/dcmdata/dcvrtm.h>

#include <chrono>

#include "dicom/read/values.h"

namespace macula::dicom {

std::optional<double> secondsOfTime(std::string_view time) {
    time = trimmed(time);
    if (time.ends_with('.')) time.remove_suffix(1);  // DCMTK requires a fraction after it
    OFTime parsed;
    if (DcmTime::getOFTimeFromString(time.data(), time.size(), parsed).bad()) return {};
    return parsed.getTimeInSeconds(/*useTimeZone=*/false, /*normalize=*/false);
}

std::optional<long> daysOfDate(std::string_view date) {
    date = trimmed(date);
    OFDate parsed;
    if (DcmDate::getOFDateFromString(date.data(), date.size(), parsed).bad()) return {};
    const std::chrono::year_month_day ymd{std::chrono::year(int(parsed.getYear())),
                                          std::chrono::month(parsed.getMonth()),
                                          std::chrono::day(parsed.getDay())};
    if (!ymd.ok()) return {};  // DCMTK accepts a 31st of February
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

std::optional<double> secondsOfOffset(std::string_view offset) {
    offset = trimmed(offset);
    constexpr std::size_t kLength = 5;  // a sign, hours, minutes
    if (offset.size() != kLength || (offset[0] != '+' && offset[0] != '-')) return {};
    if (offset.find_first_not_of("0123456789", 1) != std::string_view::npos) return {};
    const auto digit = [&](std::size_t at) { return double(offset[at] - '0'); };
    const double minutes = 60.0 * (10.0 * digit(1) + digit(2)) + 10.0 * digit(3) + digit(4);
    return (offset[0] == '-' ? -60.0 : 60.0) * minutes;
}

std::optional<Moment> momentOf(std::string_view text) {
    text = trimmed(text);
    const std::size_t sign = text.find_first_of("+-");
    const double east =
        sign == std::string_view::npos ? 0.0 : secondsOfOffset(text.substr(sign)).value_or(0.0);
    text = text.substr(0, sign);
    constexpr std::size_t kMostOfTime = 6;  // HHMMSS
    constexpr std::size_t kDate = 8;        // YYYYMMDD
    if (text.find_first_not_of("0123456789") <= kMostOfTime || text.size() <= kMostOfTime) {
        const auto seconds = secondsOfTime(text);
        if (!seconds) return {};
        return Moment{{}, *seconds - east};
    }
    if (text.size() <= kDate) return {};
    const auto day = daysOfDate(text.substr(0, kDate));
    const auto seconds = secondsOfDateTime(text);
    if (!day || !seconds) return {};
    return Moment{day, *seconds - east};
}

}  // namespace macula::dicom
