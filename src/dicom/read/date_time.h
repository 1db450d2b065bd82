// Dates and times of DICOM (PS3.5 6.2: DA, TM, DT), as leniently as real files need: missing minutes or
// seconds are 0, colons and dots of the old standard are accepted.
#pragma once

#include <optional>
#include <string_view>

namespace macula::dicom {

// "19", "1930", "193059.25", "19:30:59": seconds since midnight, 0 to 86401.
std::optional<double> secondsOfTime(std::string_view time);
// "20010105", "2001.01.05": days since 1970-01-01.
std::optional<long> daysOfDate(std::string_view date);
// "20010105193059.25+0100": seconds since 1970-01-01 in the file's own time zone; ignores the offset after +
// or -, because the caller compares times of one zone. Needs at least a day.
std::optional<double> secondsOfDateTime(std::string_view dateTime);
// "+0100", "-0330", as at the end of a DT or in TimezoneOffsetFromUTC: seconds east of Greenwich.
std::optional<double> secondsOfOffset(std::string_view offset);

// A point in time that a text gives, perhaps without a date. Moments are comparable only if both have a date,
// or neither. Text with an offset gives UTC, other text the zone of the scanner.
struct Moment {
    std::optional<long> day;  // of the date as written, since 1970-01-01; empty without a date
    double seconds = 0.0;     // since 1970-01-01, or since midnight
};

// A time, or a date and a time, either with an offset: "193059", "20010105193059.25+0100". Nothing without a
// time of day: a date alone does not order the images of a day.
std::optional<Moment> momentOf(std::string_view text);

}  // namespace macula::dicom
