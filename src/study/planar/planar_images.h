// The images of a folder that are shown as they are, not as a volume.
#pragma once

#include <cstddef>
#include <filesystem>
#include <vector>

#include "study/open/found_volumes.h"
#include "study/open/identity.h"

namespace macula::study {

// A stack without a volume. The FoundVolumes must outlive it.
struct PlanarSeries {
    const dicom::Study* study = nullptr;
    const dicom::Series* series = nullptr;
    const dicom::Stack* stack = nullptr;
};

bool canBeShownAsImages(const dicom::Stack& stack);

// In the order of the scan.
std::vector<PlanarSeries> planarSeriesOf(const FoundVolumes& found);
// What opening `source` shows: of an image its series, of a folder or a DICOMDIR the series with the most
// images of the newest study. stack is null without any, for a file that is no image, and for a folder of
// several patients.
PlanarSeries planarSeriesFor(const FoundVolumes& found, const std::filesystem::path& source);
// Whether the file is one of its images. False without a stack.
bool holds(const PlanarSeries& series, const std::filesystem::path& file);
// Of any stack with images, a volume or not; stack is null where it is not in the folder.
PlanarSeries seriesOf(const FoundVolumes& found, const dicom::Stack* stack);

Identity identityOf(const PlanarSeries& series);

// The frames of one file, which follow each other: a loop of ultrasound, or a single image.
struct PlanarLoop {
    std::size_t begin = 0;  // in Stack::frames
    std::size_t end = 0;
};
// Each frame of the stack is in one of them.
std::vector<PlanarLoop> loopsOf(const dicom::Stack& stack);

}  // namespace macula::study
