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
// "20010105193059.25+0100": seconds since 1970-01-01 in the file's own time zone; what follows + or - is left
// out, because times are only compared within one file. Needs at least a day.
std::optional<double> secondsOfDateTime(std::string_view dateTime);
// Either of them, for the order of images: a date with a time, or a time alone.
std::optional<double> secondsOfEither(std::string_view text);

}  // namespace macula::dicom
