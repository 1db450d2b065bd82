// Which voxels of a CT are of the patient, and which of the table and other things beside the patient.
#pragma once

#include <string_view>
#include <vector>

#include "base/label_map.h"
#include "base/message.h"
#include "base/progress.h"
#include "base/result.h"
#include "base/volume.h"

namespace macula::segment {

// How sure it is that what is removed is not of the patient. `none`: not sure at all, and nothing is removed.
enum class Confidence { none, moderate, high };
std::string_view nameOf(Confidence confidence);

struct PatientMask {
    LabelMap map;                   // on the volume's grid; kPatient or 0; its messages are those below
    std::vector<Message> messages;  // what was removed, or why nothing was: docs/table-removal.md
    bool tableFound = false;
    int removedParts = 0;  // connected, of 1 mL and more
    double removedMl = 0.0;
    double patientMl = 0.0;  // with lungs and bowel gas
    Confidence confidence = Confidence::none;

    static constexpr std::uint16_t kPatient = 1;
};

// Fails with usage for a volume that is not in HU, with cancelled, and with outOfMemory. When there is
// nothing to remove, or it is not clear what, every voxel is the patient's. The volume itself is never
// changed: who shows the table again only has to leave the mask away.
Result<PatientMask> findPatient(const Volume& volume, Progress& progress);

}  // namespace macula::segment
