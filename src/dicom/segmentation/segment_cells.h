// Decodes the cells of a segmentation's frames.
#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>
#include <vector>

#include "dicom/segmentation/segmentation.h"

namespace macula::dicom {

// In a fractional frame, values of at least half of fractionalMaximum belong to the segment.
class SegmentCells {
  public:
    explicit SegmentCells(const Segmentation& segmentation)
        : type_(segmentation.type),
          shift_(segmentation.format.highBit + 1 - segmentation.format.bitsStored),
          mask_((1u << segmentation.format.bitsStored) - 1u),
          maximum_(static_cast<unsigned>(segmentation.fractionalMaximum)),
          isBackground_(std::size_t(mask_) + 1) {
        for (const CellRange& range : segmentation.background)
            for (int value = std::max(range.first, 0); value <= range.last && unsigned(value) <= mask_;
                 ++value)
                isBackground_[std::size_t(value)] = true;
    }

    // The segment that a cell of the frame belongs to; nothing where it belongs to none. 0 is a segment like
    // others.
    std::optional<std::uint16_t> segmentOf(const Segmentation::Frame& frame, std::uint16_t cell) const {
        const unsigned value = (unsigned{cell} >> shift_) & mask_;
        switch (type_) {
            case SegmentationType::binary:
                return value != 0 ? std::optional(frame.segment) : std::nullopt;
            case SegmentationType::fractional:
                return value > 0 && 2 * value >= maximum_ ? std::optional(frame.segment) : std::nullopt;
            case SegmentationType::labelMap:
                break;
        }
        return isBackground_[value] ? std::nullopt : std::optional(static_cast<std::uint16_t>(value));
    }

  private:
    SegmentationType type_;
    int shift_;
    unsigned mask_;
    unsigned maximum_;
    std::vector<bool> isBackground_;  // for label maps, by value
};

}  // namespace macula::dicom
