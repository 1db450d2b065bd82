// Pseudonyms that keep deidentified objects of one patient and study together, without revealing whose.
#pragma once

#include <string>

#include "dicom/read/patient.h"

namespace macula::dicom {

struct Pseudonym {
    std::string patientId;  // "MACULA-" and 32 hexadecimal digits
    std::string studyInstanceUid;
};

// Random, so that nobody can derive it from a known patient; the same for the same patient and study while
// the program runs, so that an archive keeps their objects together. If neither ID nor name identify a
// patient, each study gets its own. Thread-safe.
Pseudonym pseudonymOf(const PatientIdentity& patient, const std::string& studyInstanceUid);

// A pseudonym that nothing else has.
Pseudonym newPseudonym();

}  // namespace macula::dicom
