// Finds where in its cell a value lies. HighBit says so (PS3.5 8.1.1), but some writers set it wrongly.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <set>
#include <span>

#include "base/progress.h"
#include "dicom/stack/intensity.h"
#include "dicom/stack/stack.h"

namespace macula::dicom {

// The cells of some images that share a format with bits below the stored ones.
class CellAlignment {
  public:
    // `declared` must be narrow (isNarrow).
    CellAlignment(const CellFormat& declared, std::uint16_t overlays);

    // Ignores padding.
    void add(std::span<const std::uint16_t> cells, const std::optional<RawRange>& padding);

    // Whether values lie in the lowest bits although HighBit puts them higher: the bits below vary as only
    // those of values do, and no value needs more bits than are stored. Read as declared, the values would be
    // a fraction of what they are. An overlay in the low bits does not qualify, because it has few patterns.
    bool isAtTheLowEnd() const;

    const CellFormat& declared() const { return declared_; }
    // The declared format, with its stored bits from the lowest on.
    CellFormat atTheLowEnd() const;

  private:
    CellFormat declared_;
    unsigned low_ = 0;  // mask of the bits below the stored ones
    std::uint16_t overlays_ = 0;
    std::set<unsigned> patterns_;        // different values of the low bits
    std::array<std::size_t, 16> set_{};  // cells that have the bit
    std::size_t cells_ = 0;              // cells that are not 0
    std::size_t beyond_ = 0;             // cells that do not fit when read from the low end
};

// Checks images whose format leaves bits below the stored ones, unless they are at most a tenth of all
// (decoding finds those: FrameDecoder::cellsBeyondStoredBits), and corrects the formats of those whose values
// lie at the low end. Returns how many it corrected. Reads some of the images, and ignores unreadable ones.
// May throw std::bad_alloc.
std::size_t alignCells(const Stack& stack, std::span<SliceIntensity> intensities, const CancelToken& cancel);

}  // namespace macula::dicom
