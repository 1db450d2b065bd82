// Separates the patient's voxels in a CT from those of the table and of other objects next to the patient.
#pragma once

#include <string_view>
#include <vector>

#include "base/label_map.h"
#include "base/message.h"
#include "base/progress.h"
#include "base/result.h"
#include "base/volume.h"

namespace macula::segment {

// How certain it is that no removed voxel belongs to the patient. `none`: not at all, and nothing is removed.
enum class Confidence { none, moderate, high };
std::string_view nameOf(Confidence confidence);

struct PatientMask {
    LabelMap map;                   // on the volume's grid; kPatient or 0; its messages are those below
    std::vector<Message> messages;  // what was removed, or why nothing was: docs/table-removal.md
    bool tableFound = false;
    int removedParts = 0;  // connected parts of at least 1 mL
    double removedMl = 0.0;
    double patientMl = 0.0;  // with lungs and bowel gas
    Confidence confidence = Confidence::none;

    static constexpr std::uint16_t kPatient = 1;
};

// Errors: usage for a volume that is not in HU; cancelled; outOfMemory. When there is nothing to remove, or
// it is unclear what to remove, all voxels count as the patient's. The volume itself never changes: to show
// the table again, the caller only omits the mask.
Result<PatientMask> findPatient(const Volume& volume, Progress& progress);

}  // namespace macula::segment
