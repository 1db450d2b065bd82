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
    binary,      // a frame tells of one segment where it is
    fractional,  // a frame tells of one segment how much of it there is, or how likely
    labelMap,    // a frame holds segment numbers
};

// From the first to the last, both included.
struct CellRange {
    int first = 0;
    int last = 0;

    bool contains(int value) const { return value >= first && value <= last; }
    bool operator==(const CellRange&) const = default;
};

// What the header says. Paths, UIDs and labels may name a patient: never logged.
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
    int fractionalMaximum = 255;    // fractional only: the value that stands for all of it
    std::vector<Segment> segments;  // by number
    struct Frame {
        ImagePlane plane;
        std::uint16_t segment = 0;  // 0 for a label map
    };
    std::vector<Frame> frames;
    // Of a label map: the numbers that stand for no segment. Those of Pixel Padding Value, those of segments
    // that are said to be background, and 0 where no segment of that number is described.
    std::vector<CellRange> background = {};
    // Segments that are described under a number of the padding: nothing in the frames is of them.
    std::vector<std::uint16_t> paddedSegments = {};
    double spacingMm = 0.0;  // between frames as the header says; 0 when it does not
    std::string sopInstanceUid = {};
    std::string contentLabel = {};  // of the whole of it, for a person; may be empty
};

// Fails with inputNotUsable when the file is no segmentation, or does not say where its frames lie or what
// they hold.
Result<Segmentation> readSegmentation(const std::filesystem::path& file);

// On the grid of the series it was drawn on, without any resampling: fails with inputNotUsable when a frame
// does not lie on that grid to a hundredth of a voxel, wherever it begins. The frame's axes may be any of the
// grid's, in either direction. Where segments overlap, the one in the later frame wins; messages of the label
// map tell how many voxels that concerns, and how many lie outside of the grid. Half of fractionalMaximum and
// more is the segment. In a label map 0 is none of the segments: a segment of number 0 gets another one
// there, and a message says which. `slicePositionsMm` are where the slices of the grid really lie, one each,
// when they are not quite even (stack.h: slicePositionsMm): a frame in one of these planes is of that slice.
Result<LabelMap> loadSegmentation(const Segmentation& segmentation, const glm::dmat4& worldFromVoxel,
                                  glm::ivec3 size, Progress& progress,
                                  std::span<const glm::dvec3> slicePositionsMm = {});

// On a grid of its own, the smallest that holds all frames: for when the series is not there. Its slice axis
// goes from the lowest frame to the highest, so that a sheared stack stays sheared.
Result<LabelMap> loadSegmentation(const Segmentation& segmentation, Progress& progress);

// PS3.3 C.10.7.1.1: a CIELab colour as three words, to sRGB.
std::array<std::uint8_t, 3> rgbOfCieLab(const std::array<std::uint16_t, 3>& words);

}  // namespace macula::dicom
