// Where the slices of a volume lie on a localizer: a scout, a topogram.
#pragma once

#include <array>
#include <glm/glm.hpp>
#include <vector>

#include "base/volume.h"
#include "dicom/stack/geometry.h"

namespace macula::study {

// The corners of a slice as they are seen along the normal of the localizer's plane, in pixels of the image
// from the outer corner of its first one. Of slices across it they lie on a line.
struct SliceOnLocalizer {
    int slice = 0;  // of the volume, from 0
    std::array<glm::dvec2, 4> corners{};
};

// Each slice of the volume, in order. Both must be in one frame of reference. Empty where the slices are not
// across the localizer, within 45 degrees: they would hide it.
std::vector<SliceOnLocalizer> slicesOn(const dicom::ImagePlane& localizer, const Volume& volume);

// The slice in whose middle plane `mm` lies nearest; within the volume.
int sliceNearest(const glm::dvec3& mm, const Volume& volume);

}  // namespace macula::study
