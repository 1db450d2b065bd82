// The patient, study and series of a picture as text.
#pragma once

#include <string>
#include <vector>

#include "base/text.h"

namespace macula::study {

// For the screen only: every field may name a patient, and none may be written to a log, a file or an error.
// UTF-8; a field is empty where the images lack it.
struct Identity {
    std::string patientName;  // components separated by ^, representations by = (PS3.5 6.2.1)
    std::string patientId;
    std::string birthDate;  // YYYYMMDD as in the files, and so is studyDate
    std::string sex;
    std::string studyDate;
    std::string studyDescription;
    Text series;                        // "CT, series 3: Thorax", "File brain.nii"
    bool isOfNobody = false;            // made up by a program, of no patient
    std::string studyInstanceUid = {};  // a study belongs to one patient; never shown

    bool operator==(const Identity&) const = default;
};

// One line each: the name; the ID with birth date and sex; the study; the series. A line says so if name, ID
// or study date is missing. Images of nobody have only the line of the series.
std::vector<Text> linesOf(const Identity& identity);

// The same in one line, without birth date and sex: for the title of a window.
Text titleOf(const Identity& identity);

// "DOE^JOHN^^^=…" as "DOE, JOHN". Representations follow in their order, repeats left out.
std::string nameForPeople(const std::string& personName);
// "20200304" as "2020-03-04"; anything else as it is.
std::string dateForPeople(const std::string& date);

}  // namespace macula::study
