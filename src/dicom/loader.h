// From a series to a Volume.
#pragma once

#include <memory>
#include <string>

#include "base/progress.h"
#include "base/result.h"
#include "base/volume.h"
#include "dicom/scan.h"

namespace macula::dicom {

// Decodes all slices on all cores, straight into the volume's only copy of the voxels. Values are slope *
// stored + intercept of each slice; the unit is hounsfield for CT, unless RescaleType names another. Fails
// with inputNotUsable when the series is no volume (its own message says why) or a slice cannot be decoded,
// outOfMemory, or, within 200 ms, cancelled.
Result<std::shared_ptr<const Volume>> loadVolume(const Series& series, Progress& progress);

// The series to show when nobody chose: of those that can be shown, no localizer if there is anything else,
// then an original one of 20 slices or more before all others, then the one with most voxels. Null when no
// series can be shown. `why`, if given, gets a sentence for the user in either case, without patient data.
const Series* bestSeries(const Scan& scan, std::string* why = nullptr);

}  // namespace macula::dicom
