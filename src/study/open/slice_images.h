// Which image each slice of a volume shows.
#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "base/volume.h"
#include "dicom/stack/stack.h"

namespace macula::study {

struct SliceImage {
    glm::dvec3 positionMm{0.0};           // of the centre of its first voxel, patient LPS
    const dicom::Frame* frame = nullptr;  // of the stack; null where the slice was interpolated
};

// One for each slice of the volume, which was loaded from the stack. Images that could not be read at either
// end of the stack are not in the volume; those in between are interpolated there.
std::vector<SliceImage> imagesOfSlices(const Volume& volume, const dicom::Stack& stack);

}  // namespace macula::study
