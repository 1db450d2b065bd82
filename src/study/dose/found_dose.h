// The doses that lie on a volume of a folder.
#pragma once

#include <cstddef>
#include <vector>

#include "base/text.h"
#include "dicom/dose/dose_facts.h"
#include "study/open/found_volumes.h"

namespace macula::study {

struct FoundDose {
    std::size_t volume = 0;  // in FoundVolumes::volumes()
    dicom::DoseFacts facts;

    bool operator==(const FoundDose&) const = default;
};

// The doses with the frame of reference of that volume, of a patient who may be the same: those of whole
// plans first, then in the order of the scan. None for a volume without a frame of reference, and for a dose.
// Reads the headers of doses and plans.
std::vector<FoundDose> dosesOn(const FoundVolumes& found, std::size_t volume);

// "Dose of a whole plan, 60 Gy prescribed in 30 fractions": what the files say, without a name.
Text doseText(const dicom::DoseFacts& facts);

// Sentences on what a person could mistake: a part of a plan, no prescription, values that are not in Gy.
std::vector<Text> doseNotes(const dicom::DoseFacts& facts);

}  // namespace macula::study
