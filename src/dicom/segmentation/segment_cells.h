// What the cells of a segmentation's frames say.
#pragma once

#include <cstdint>

#include "dicom/segmentation/segmentation.h"

namespace macula::dicom {

// Half of fractionalMaximum and more is the segment.
class SegmentCells {
  public:
    explicit SegmentCells(const Segmentation& segmentation)
        : type_(segmentation.type),
          shift_(segmentation.format.highBit + 1 - segmentation.format.bitsStored),
          mask_((1u << segmentation.format.bitsStored) - 1u),
          maximum_(static_cast<unsigned>(segmentation.fractionalMaximum)) {}

    // The segment that a cell of the frame belongs to; 0 is none.
    std::uint16_t segmentOf(const Segmentation::Frame& frame, std::uint16_t cell) const {
        const unsigned value = (unsigned{cell} >> shift_) & mask_;
        switch (type_) {
            case SegmentationType::binary:
                return value != 0 ? frame.segment : std::uint16_t{0};
            case SegmentationType::fractional:
                return value > 0 && 2 * value >= maximum_ ? frame.segment : std::uint16_t{0};
            case SegmentationType::labelMap:
                break;
        }
        return static_cast<std::uint16_t>(value);
    }

  private:
    SegmentationType type_;
    int shift_;
    unsigned mask_;
    unsigned maximum_;
};

}  // namespace macula::dicom
