// Whose a deidentified object is: of one patient and one study with others, and nobody can tell of whom.
#pragma once

#include <string>

#include "dicom/read/patient.h"

namespace macula::dicom {

struct Pseudonym {
    std::string patientId;  // "MACULA-" and 32 hexadecimal digits
    std::string studyInstanceUid;
};

// By chance, so that who knows a patient cannot find out which it is; the same for the same patient and the
// same study for as long as the program runs, so that an archive files what belongs together. Where neither
// ID nor name say whose it is, each study is of a patient of its own. Thread-safe.
Pseudonym pseudonymOf(const PatientIdentity& patient, const std::string& studyInstanceUid);

// Of nobody else.
Pseudonym newPseudonym();

}  // namespace macula::dicom
