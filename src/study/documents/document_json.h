// Documents for other programs, as JSON.
#pragma once

#include <nlohmann/json.hpp>

#include "dicom/documents/document.h"

namespace macula::study {

// All of it, with codes, numbers, points in pixels or mm and references by UID; sentences are in English. It
// names the patient.
nlohmann::ordered_json toJson(const dicom::StudyDocument& document);

}  // namespace macula::study
