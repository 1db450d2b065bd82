// Whose an object is that Macula writes: patient and study of an image, or nobody's. For the writers of this
// room alone.
#pragma once

#include <string>

#include "base/result.h"
#include "dicom/secondary_capture.h"

class DcmDataset;  // of DCMTK

namespace macula::dicom {

// Local, as scanners write them.
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
};

// Patient and study of that image, character sets and all. What the source is told by never goes into the
// error: it may name a patient. inputNotUsable when it cannot be read, is another instance, or has no study.
Result<Origin> copyOwner(DcmDataset& to, const SecondaryCapture::Source& source);

// Nobody, in a study of its own: a patient left out, or one that a program made up. Whether it could be done.
bool writeNobody(DcmDataset& to, bool isDeidentified);

}  // namespace macula::dicom
