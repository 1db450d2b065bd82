// Loads a DICOM segmentation as a label map.
#pragma once

#include "base/label_map.h"
#include "base/progress.h"
#include "base/result.h"
#include "dicom/scan.h"

namespace macula::study {

// Whether the series holds segmentations, and no images.
bool isSegmentationSeries(const dicom::Series& series);

struct SegmentationOnGrid {
    LabelMap map;
    bool onItsSeries = false;  // on the grid of the series it was drawn on; otherwise on its own grid
    bool hasImages = false;    // the scan has a volume of that series
};

// Loads segmentation `number` of the series, from 1; 0: the only one. Uses the grid of the images it was
// drawn on if the scan has these as a volume and the segmentation fits. usage for a wrong `number`.
Result<SegmentationOnGrid> loadSegmentation(const dicom::Scan& scan, const dicom::Series& series,
                                            std::size_t number, Progress& progress);

}  // namespace macula::study
