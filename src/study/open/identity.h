// Whose images a picture is made from, in words.
#pragma once

#include <string>
#include <vector>

namespace macula::app {

// For the screen only: all of it may name a patient, and none of it goes to a log, a file or an error. UTF-8;
// what is empty is not in the images.
struct Identity {
    std::string patientName;  // components separated by ^, representations by = (PS3.5 6.2.1)
    std::string patientId;
    std::string birthDate;  // YYYYMMDD, as the two below are written in the files
    std::string sex;
    std::string studyDate;
    std::string studyDescription;
    std::string series;                 // "Series 3: Thorax 1.0", or what else it is
    bool isOfNobody = false;            // nobody's images: made up by a program
    std::string studyInstanceUid = {};  // a study is of one patient; never shown

    bool operator==(const Identity&) const = default;
};

// A line each for the patient, the ID with birth date and sex, the study, and the series. What identifies a
// patient and is missing is said to be; of what is nobody's, the series alone.
std::vector<std::string> linesOf(const Identity& identity);

// The same in one line, without birth date and sex: for the title of a window.
std::string titleOf(const Identity& identity);

// "DOE^JOHN^^^=…" as "DOE, JOHN". All representations, the first one first.
std::string nameForPeople(const std::string& personName);
// "20200304" as "2020-03-04"; anything else as it is.
std::string dateForPeople(const std::string& date);

}  // namespace macula::app
