// From a series to a Volume.
#pragma once

#include <memory>

#include "base/progress.h"
#include "base/result.h"
#include "base/volume.h"
#include "dicom/series.h"

namespace macula::dicom {

// Decodes all slices on all cores, straight into the volume's only copy of the voxels. Values are slope *
// stored + intercept of each slice; the unit is hounsfield for CT, unless RescaleType names another. Fails
// with inputNotUsable when the series is no volume (its own message says why) or a slice cannot be decoded,
// outOfMemory, or, within 200 ms, cancelled.
Result<std::shared_ptr<const Volume>> loadVolume(const Series& series, const Stack& stack,
                                                 Progress& progress);

}  // namespace macula::dicom
