// From pixel cells to the 16-bit stored values of a Volume: bits and sign (PS3.5 8.1.1), rescale (PS3.3
// C.11.1), padding (PS3.3 C.7.5.1.1.2). Pure functions; values are kept, never windowed, and MONOCHROME1 is
// not inverted (it says how to draw a value, not what it is).
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "base/volume.h"

namespace macula::dicom {

// How a pixel cell holds its value.
struct CellFormat {
    int bitsAllocated = 16;
    int bitsStored = 16;
    int highBit = 15;
    bool isSigned = false;

    bool operator==(const CellFormat&) const = default;
};

// 8 or 16 bits allocated, and the stored bits inside them.
bool isUsable(const CellFormat& format);

// Closed interval of raw values (after masking and sign extension).
struct RawRange {
    int low = 0;
    int high = 0;

    bool operator==(const RawRange&) const = default;
};

// PixelPaddingValue and PixelPaddingRangeLimit as 16-bit words, to raw values; in either order, as the
// standard allows.
RawRange paddingRange(const CellFormat& format, std::uint16_t valueWord,
                      std::optional<std::uint16_t> limitWord);

// One slice: value = slope * raw + intercept.
struct SliceIntensity {
    CellFormat format;
    double slope = 1.0;  // not 0; may be negative
    double intercept = 0.0;
    std::optional<RawRange> padding;

    bool operator==(const SliceIntensity&) const = default;
};

// In place, from cells as in the file to "unpacked" values: raw when unsigned, raw + 32768 when signed. Bits
// outside the stored ones (overlays, PS3.5 8.1.2) are dropped.
void unpackCells(const CellFormat& format, std::span<std::uint16_t> cells);

// How the unpacked values of one slice become stored values of the volume.
struct SliceMap {
    enum class Kind { keep, invert, linear };

    Kind kind = Kind::keep;
    double scale = 1.0;  // linear: stored = round(scale * unpacked + shift)
    double shift = 0.0;
    std::optional<StoredRange> padding;  // linear: these unpacked values become stored 0
};

void applyMap(const SliceMap& map, std::span<std::uint16_t> unpacked);

struct IntensityPlan {
    UnitsFromStored unitsFromStored;
    std::optional<StoredRange> padding;
    std::vector<SliceMap> slices;  // one per slice
    std::vector<std::string> assumptions;
};

// True when all slices have one format and one linear map, so that the plan needs no look at the pixels:
// values are then exact.
bool isUniform(std::span<const SliceIntensity> slices);

// For uniform slices.
IntensityPlan uniformPlan(std::span<const SliceIntensity> slices);

// For slices that differ. `unpackedRanges` are each slice's smallest and largest unpacked value that is no
// padding. Exact when one 16-bit map can hold every value; otherwise quantised over the range of the values,
// and the largest error is stated in `assumptions`.
IntensityPlan mixedPlan(std::span<const SliceIntensity> slices, std::span<const StoredRange> unpackedRanges);

// The padding of one slice among its unpacked values; nothing when it declares none, or none its cells could
// hold.
std::optional<StoredRange> unpackedPadding(const SliceIntensity& slice);

}  // namespace macula::dicom
