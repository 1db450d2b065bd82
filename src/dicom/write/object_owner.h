// Whose an object is that Macula writes: patient and study of an image, or nobody's. For the writers of this
// room alone.
#pragma once

#include <optional>
#include <string>

#include "base/result.h"
#include "dicom/write/secondary_capture.h"

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
    std::string bodyPart;  // Body Part Examined
};

// Patient and study of that image, character sets and all. What the source is told by never goes into the
// error: it may name a patient. inputNotUsable when it cannot be read, is another instance, or has no study.
Result<Origin> copyOwner(DcmDataset& to, const SecondaryCapture::Source& source);

// Nobody, in a study of its own, that a program made up. Whether it could be done.
bool writeNobody(DcmDataset& to);

// A patient left out: under a new ID, and in a new study, of which are all objects of that patient and that
// study that the program writes while it runs (pseudonymOf). Where nothing is told of the image, or it can no
// longer be read, under ones that nothing else has. The origin tells what kind of image it is, and no UIDs;
// nothing where it could not be written.
std::optional<Origin> writePseudonym(DcmDataset& to, const std::optional<SecondaryCapture::Source>& source);

}  // namespace macula::dicom
