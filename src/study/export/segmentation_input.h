// From a series of segmentation objects to a label map.
#pragma once

#include "base/label_map.h"
#include "base/progress.h"
#include "base/result.h"
#include "dicom/scan.h"

namespace macula::app {

// Whether the series holds segmentations, and no images.
bool isSegmentationSeries(const dicom::Series& series);

struct SegmentationInput {
    LabelMap map;
    bool onItsSeries = false;  // on the grid of the series it was drawn on; else on one of its own
    bool hasImages = false;    // that series is there, and is a volume
};

// The `number`th of its segmentations, from 1; 0 means the only one. On the grid of the images it was drawn
// on, when the folder has them and they are a volume.
Result<SegmentationInput> loadSegmentation(const dicom::Scan& scan, const dicom::Series& series,
                                           std::size_t number, Progress& progress);

}  // namespace macula::app
