// The frames of a segmentation that is written. Only for the writers of this folder.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "dicom/write/segmentation_writer.h"

namespace macula::dicom {

// Segment by segment, from the first slice to the last; a segment has a frame where it has a voxel.
class SegmentFrames {
  public:
    struct Frame {
        std::size_t segment = 0;  // among those written, from 0
        int slice = 0;
    };
    // Each voxel lies in the grid.
    explicit SegmentFrames(const WrittenSegmentation& segmentation);

    std::span<const Frame> frames() const { return frames_; }
    bool doOverlap() const { return doOverlap_; }  // whether a voxel is in two segments
    double bytesOfCells() const;
    // A bit for each cell, the first in the lowest bit of the first byte, without gaps between frames (PS3.5
    // 8.1.1); an even number of bytes.
    std::vector<std::uint8_t> cells() const;

  private:
    const WrittenSegmentation& segmentation_;
    std::vector<Frame> frames_;
    std::vector<std::size_t> firstOf_;  // the first frame of each segment
    bool doOverlap_ = false;
};

}  // namespace macula::dicom
