// Loads a stack as a Volume.
#pragma once

#include <functional>
#include <memory>

#include "base/progress.h"
#include "base/result.h"
#include "base/volume.h"
#include "dicom/stack/series.h"

namespace macula::dicom {

struct LoadOptions {
    // A decoding thread calls it at most once, with a volume of every fourth slice, as soon as these are
    // decoded; never for fewer than 16 slices. Must not throw, and must return soon; the other threads
    // continue meanwhile.
    std::function<void(std::shared_ptr<const Volume>)> onCoarse;
    // Gives PET and its windows in SUV by body weight where Stack::suvFactor is known; otherwise in the unit
    // of the images.
    bool inSuv = false;
};

// Decodes all frames on all cores, every fourth slice first, straight into the volume's only copy of the
// voxels. The volume is in 16 bits where these hold every value exactly, otherwise in float. A frame that
// cannot be decoded is treated as missing: its slice is interpolated, or cut off at the ends;
// provenance().messages report this. provenance().interpolatedSlices lists the interpolated slices. The unit
// is hounsfield for CT that declares it: value_unit.h. Fails with inputNotUsable when the stack is not a
// volume (its own message says why), when fewer than two or than half of the frames can be decoded, with
// outOfMemory, or, within 200 ms, cancelled.
Result<std::shared_ptr<const Volume>> loadVolume(const Series& series, const Stack& stack, Progress& progress,
                                                 const LoadOptions& options = {});

}  // namespace macula::dicom
