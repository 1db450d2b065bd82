// Segmentation objects (PS3.3 A.51 and A.87): label maps that were drawn on a series.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "base/label_map.h"
#include "base/progress.h"
#include "base/result.h"
#include "dicom/stack/geometry.h"
#include "dicom/stack/intensity.h"

namespace macula::dicom {

enum class SegmentationType {
    binary,      // a frame marks where one segment is
    fractional,  // a frame gives the share of one segment in each pixel, or its probability
    labelMap,    // a frame holds segment numbers
};

// A range of cell values that includes both ends.
struct CellRange {
    int first = 0;
    int last = 0;

    bool contains(int value) const { return value >= first && value <= last; }
    bool operator==(const CellRange&) const = default;
};

// The header of a segmentation. Paths, UIDs and labels may name a patient: never logged.
struct Segmentation {
    std::filesystem::path file;
    std::string seriesInstanceUid;
    std::string frameOfReferenceUid;
    std::vector<std::string> referencedSeriesUids;  // the series that it was drawn on; usually one
    SegmentationType type = SegmentationType::binary;
    std::string transferSyntaxUid;
    int columns = 0;
    int rows = 0;
    CellFormat format;
    int fractionalMaximum = 255;    // fractional only: the value that means 1
    std::vector<Segment> segments;  // by number
    struct Frame {
        ImagePlane plane;
        std::uint16_t segment = 0;  // 0 for a label map
    };
    std::vector<Frame> frames;
    // Of a label map: the numbers that mean no segment. These are Pixel Padding Value, those of segments
    // described as background, and 0 when no segment has that number.
    std::vector<CellRange> background = {};
    // Described segments whose number is a padding value: they have no pixels in the frames.
    std::vector<std::uint16_t> paddedSegments = {};
    double spacingMm = 0.0;  // between frames, from the header; 0 when it gives none
    std::string sopInstanceUid = {};
    std::string contentLabel = {};  // for a person; may be empty
};

// Fails with inputNotUsable when the file is not a segmentation, or does not say where its frames lie or what
// they hold.
Result<Segmentation> readSegmentation(const std::filesystem::path& file);

// Loads the segmentation on the grid of the series it was drawn on, without resampling: fails with
// inputNotUsable when a frame is more than a hundredth of a voxel off that grid, wherever it begins. The
// frame's axes may be any of the grid's, in either direction. Where segments overlap, the one in the later
// frame wins; messages of the label map count such voxels, and those outside of the grid. At least half of
// fractionalMaximum is the segment. In the result 0 means no segment: a segment 0 gets another number, which
// a message states. `slicePositionsMm` are the true positions of the grid's slices, one each, when they are
// not quite even (stack.h: slicePositionsMm): a frame in one of these planes belongs to that slice.
Result<LabelMap> loadSegmentation(const Segmentation& segmentation, const glm::dmat4& worldFromVoxel,
                                  glm::ivec3 size, Progress& progress,
                                  std::span<const glm::dvec3> slicePositionsMm = {});

// Loads the segmentation on its own grid, the smallest that holds all frames, for when the series is absent.
// Its slice axis goes from the lowest frame to the highest, so that a sheared stack stays sheared.
Result<LabelMap> loadSegmentation(const Segmentation& segmentation, Progress& progress);

// Converts a CIELab colour, as three words (PS3.3 C.10.7.1.1), to sRGB.
std::array<std::uint8_t, 3> rgbOfCieLab(const std::array<std::uint16_t, 3>& words);

}  // namespace macula::dicom
