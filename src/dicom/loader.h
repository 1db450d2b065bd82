// From a stack to a Volume.
#pragma once

#include <functional>
#include <memory>

#include "base/progress.h"
#include "base/result.h"
#include "base/volume.h"
#include "dicom/stack/series.h"

namespace macula::dicom {

struct LoadOptions {
    // Called at most once, from a thread that decodes, with a volume of every fourth slice as soon as these
    // are there; not for fewer than 16 slices. Must not throw, and must return soon: the other threads go on
    // meanwhile.
    std::function<void(std::shared_ptr<const Volume>)> onCoarse;
    // PET in SUV by body weight, with its windows, where Stack::suvFactor is known; else as the images have
    // it.
    bool inSuv = false;
};

// Decodes all frames on all cores, every fourth slice first, straight into the volume's only copy of the
// voxels. The volume is in 16 bits where these hold every value exactly, else in float. A frame that cannot
// be decoded is dropped as if it had never been there: interpolated, or cut off at the ends;
// provenance().messages say so. Slices between frames are interpolated, and listed in
// provenance().interpolatedSlices. The unit is hounsfield for CT that says so: value_unit.h. Fails with
// inputNotUsable when the stack is no volume (its own message says why), when fewer than two or than half of
// the frames can be decoded, with outOfMemory, or, within 200 ms, cancelled.
Result<std::shared_ptr<const Volume>> loadVolume(const Series& series, const Stack& stack, Progress& progress,
                                                 const LoadOptions& options = {});

}  // namespace macula::dicom
