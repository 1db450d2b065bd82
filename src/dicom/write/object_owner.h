// Writes the owner of an object: patient and study of an image, or nobody. Only for the writers of this
// folder.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "base/result.h"
#include "dicom/read/patient.h"
#include "dicom/write/secondary_capture.h"

class DcmDataset;  // of DCMTK

namespace macula::dicom {

// Local date and time, as scanners write them.
struct Now {
    std::string date = "19700101";
    std::string time = "000000";

    Now();
};

// The image that patient and study are taken from.
struct Origin {
    std::string modality = "OT";  // other
    std::string sopClassUid;
    std::string sopInstanceUid;
    std::string bodyPart;  // Body Part Examined
};

// Copies patient, study and character set of that image. Fails with inputNotUsable when it cannot be read, is
// another instance, or has no study (`where` is its path, which may name a patient); or outputNotWritable.
Result<Origin> copyOwner(DcmDataset& to, const SecondaryCapture::Source& source);

// Writes a made-up patient with a new study. Returns whether it succeeded.
bool writeNobody(DcmDataset& to);

// Writes a pseudonym: a new patient ID and a new study, shared by all objects of that patient and study that
// the program writes while it runs (pseudonymOf). If there is no source, or it cannot be read, nothing else
// has them. The origin gives only the body part; nothing on failure.
std::optional<Origin> writePseudonym(DcmDataset& to, const std::optional<SecondaryCapture::Source>& source);

// Keeps deidentified objects of one patient and study together, without revealing whose.
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

// Whether a patient may be recognised by the face, even without a name: for Recognizable Visual Features
// (PS3.3 C.7.6.1). False only if Body Part Examined (0018,0015), `bodyPart`, is in the trunk below the chest
// or in a leg, and the length shown along the patient, `heightMm`, is at most 600 mm. An unknown part or
// length may include a head.
bool mayShowFace(std::string_view bodyPart, std::optional<double> heightMm);

}  // namespace macula::dicom
