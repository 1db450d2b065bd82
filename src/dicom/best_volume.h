// Chooses the volume to show when the user has not chosen one.
#pragma once

#include <span>
#include <string>

#include "base/text.h"
#include "dicom/scan.h"

namespace macula::dicom {

struct ChosenStack {
    const Series* series = nullptr;
    const Stack* stack = nullptr;
    Text why;  // a sentence for the user, also when there is nothing to show; no patient data

    explicit operator bool() const { return stack != nullptr; }
};

// The first volume by these criteria: original with 20 images or more; of these, axial; without interpolated
// slices; most voxels; first in the scan. Never one of `without`.
ChosenStack bestVolume(const Scan& scan, std::span<const Stack* const> without = {});
// The same within one series.
ChosenStack bestVolume(const Series& series);

}  // namespace macula::dicom
