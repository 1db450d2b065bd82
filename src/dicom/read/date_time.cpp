#include "dicom/read/date_time.h"

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dcvrda.h>
#include <dcmtk/dcmdata/dcvrtm.h>

#include <chrono>

#include "dicom/read/values.h"

namespace macula::dicom {

std::optional<double> secondsOfTime(std::string_view time) {
    time = trimmed(time);
    if (time.ends_with('.')) time.remove_suffix(1);  // DCMTK wants a fraction after it
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
    if (!ymd.ok()) return {};  // a 31st of February is one to DCMTK
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
