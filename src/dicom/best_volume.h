// What to show when nobody chose.
#pragma once

#include <span>
#include <string>

#include "dicom/scan.h"

namespace macula::dicom {

struct Choice {
    const Series* series = nullptr;
    const Stack* stack = nullptr;
    std::string why;  // a sentence for the user, also when nothing can be shown; no patient data

    explicit operator bool() const { return stack != nullptr; }
};

// The volume that comes first by: an original axial one of 20 slices or more; then one without interpolated
// slices; then the one with most voxels; then the first in the scan. Those of `without` are not chosen.
Choice bestVolume(const Scan& scan, std::span<const Stack* const> without = {});
// The same within one series.
Choice bestVolume(const Series& series);

}  // namespace macula::dicom
