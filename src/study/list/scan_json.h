// What `macula info --json` prints; docs/dicom.md describes it.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "dicom/best_volume.h"

namespace macula::study {

enum class PatientData { leaveOut, include };  // names, IDs, dates, descriptions of studies, paths of files

// The value of a label, unless it is a date, a time of day or a UID.
std::string shownValue(const dicom::StackLabel& label);

nlohmann::ordered_json toJson(const Message& message);
nlohmann::ordered_json toJson(const dicom::Scan& scan, const dicom::ChosenStack& best,
                              PatientData patientData);

}  // namespace macula::study
