// The dose in all regions of a volume: what its structure sets and segmentations outline.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/progress.h"
#include "base/result.h"
#include "base/text.h"
#include "base/volume.h"
#include "dicom/dose/dose_facts.h"
#include "study/dose/region_dose.h"
#include "study/open/found_volumes.h"

namespace macula::study {

// Labels are for the screen; they may name a patient.
struct RegionInDose {
    std::string set;                    // the title of its structure set or segmentation
    std::string label;                  // of the region
    std::array<std::uint8_t, 3> rgb{};  // sRGB
    std::optional<double> volumeMl;     // as LoadedSegment
    RegionDose dose;
};

// What 100 percent of a dose are.
struct DoseReference {
    enum class Of {
        prescription,  // the highest of its plan
        maximum,       // of the whole dose
        choice,        // of a person
    };
    double value = 0.0;  // in the unit of the dose; above 0
    Of of = Of::maximum;

    bool operator==(const DoseReference&) const = default;
};

struct DoseReport {
    std::string unit;  // of all doses: "Gy", or Volume::unitName
    bool isInGy = false;
    std::optional<DoseReference> reference;  // nothing for a dose without a value above 0
    std::vector<RegionInDose> regions;       // in the order of their files
    std::vector<Text> notes;  // sentences, without patient data: what was assumed, and what is missing
};

// The prescription where the facts have one, else the maximum. Nothing if no value is above 0.
std::optional<DoseReference> usualReference(const std::optional<dicom::DoseFacts>& facts, const Volume& dose);

struct DoseOnVolume {
    const FoundVolumes& found;
    std::size_t on = 0;                    // the volume, in FoundVolumes::volumes()
    const Volume& grid;                    // its voxels
    std::size_t dose = 0;                  // in FoundVolumes::volumes()
    std::shared_ptr<const Volume> values;  // of the dose: OpenedStudy::measured
};
// Regions without voxels in the volume are listed too. Fails with cancelled, outOfMemory, and inputNotUsable
// if the volume has no region or the dose lies in another frame of reference.
Result<DoseReport> reportDose(const DoseOnVolume& of, Progress& progress);

}  // namespace macula::study
