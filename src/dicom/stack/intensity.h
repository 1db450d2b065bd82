// Converts pixel cells to the voxels of a Volume: bits and sign (PS3.5 8.1.1), rescale and modality LUT
// (PS3.3 C.11.1), padding (PS3.3 C.7.5.1.1.2). Pure functions; values are kept, never windowed, and
// MONOCHROME1 is not inverted (it says how to draw a value, not what it is).
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "base/progress.h"
#include "base/volume.h"

namespace macula::dicom {

enum class CellKind {
    integer,  // Pixel Data (7FE0,0010)
    float32,  // Float Pixel Data (7FE0,0008)
    float64,  // Double Float Pixel Data (7FE0,0009)
};

// How a pixel cell holds its value.
struct CellFormat {
    int bitsAllocated = 16;
    int bitsStored = 16;
    int highBit = 15;
    bool isSigned = false;
    CellKind kind = CellKind::integer;

    bool operator==(const CellFormat&) const = default;
};

// The format of floating-point cells, which have no stored bits.
CellFormat floatFormat(CellKind kind);

// Whether cells are integers of 1, 8, 16 or 32 bits allocated with the stored bits inside, or floatFormat.
bool isUsable(const CellFormat& format);

// Whether the cells of a usable format fit 16 bits. Other cells are read as numbers.
bool isNarrow(const CellFormat& format);

// Closed interval of raw values (after masking and sign extension).
struct RawRange {
    int low = 0;
    int high = 0;

    bool contains(double raw) const { return low <= raw && raw <= high; }
    bool operator==(const RawRange&) const = default;
};

// The raw values of PixelPaddingValue and PixelPaddingRangeLimit, given as 16-bit words in either order, as
// the standard allows.
RawRange paddingRange(const CellFormat& format, std::uint16_t valueWord,
                      std::optional<std::uint16_t> limitWord);

// Maps a raw value to entries[raw - firstMapped]; below and above the table to its first and last entry.
struct ModalityLut {
    int firstMapped = 0;
    std::vector<std::uint16_t> entries;  // not empty

    std::uint16_t operator()(std::int64_t raw) const;
    bool operator==(const ModalityLut&) const = default;
};

// Reads the modality LUT from LUTDescriptor (0028,3002) as its three words, and LUTData (0028,3006); entries
// of 8 bits may be one or two in a word. Nothing when descriptor and data do not fit.
std::shared_ptr<const ModalityLut> readModalityLut(const std::array<std::uint16_t, 3>& descriptor,
                                                   std::span<const std::uint16_t> data, bool pixelsAreSigned);

// One slice: value = modalityLut(raw) when there is one, otherwise slope * raw + intercept.
struct SliceIntensity {
    CellFormat format;
    double slope = 1.0;  // not 0; may be negative
    double intercept = 0.0;
    std::optional<RawRange> padding = {};
    std::optional<ValueRange> floatPadding = {};  // for floating-point cells: (0028,0122) to (0028,0125)
    std::shared_ptr<const ModalityLut> modalityLut = {};

    bool operator==(const SliceIntensity& other) const;
};

// Gives slices without padding that of the others, if those agree. Returns a sentence if it did so.
std::optional<Text> completePadding(std::span<SliceIntensity> slices);

// Unpacks in place, from narrow cells as in the file to "unpacked" values: raw when unsigned, raw + 32768
// when signed. Bits outside the stored ones (overlays, PS3.5 8.1.2) are dropped, except where the whole cell
// is a padding value that the stored bits cannot hold: masked, it would be a bright false value.
void unpackCells(const CellFormat& format, const std::optional<RawRange>& padding,
                 std::span<std::uint16_t> cells);

// Counts cells, as in the file, with bits set outside the stored ones of `format` that are not a sign
// extension: overlays (PS3.5 8.1.2), or values that need more bits, or lie lower. Ignores padding and the
// bits of `overlays`, which the file declares.
std::size_t cellsBeyondStoredBits(const CellFormat& format, const std::optional<RawRange>& padding,
                                  std::span<const std::uint16_t> cells, std::uint16_t overlays = 0);

// The padding of one slice among its unpacked values.
std::optional<StoredRange> unpackedPadding(const SliceIntensity& slice);

// How the unpacked values of one slice become stored values of the volume.
struct SliceMap {
    enum class Kind { keep, invert, linear };

    Kind kind = Kind::keep;
    // linear only: stored = scale * lut(raw) + shift, or scale * unpacked + shift without a LUT; 0 for
    // unpacked values in `padding`.
    std::int64_t scale = 1;
    std::int64_t shift = 0;
    std::optional<StoredRange> padding = {};
    std::shared_ptr<const ModalityLut> modalityLut = {};
    int lutOffset = 0;  // raw = unpacked - lutOffset
};

void applyMap(const SliceMap& map, std::span<std::uint16_t> unpacked);

// Maps to units, for voxels of float32, computing in double. Padding and values that float cannot hold become
// NaN. `numbers` are raw values of cells wider than 16 bits; returns how many of them are not padding and
// have no finite value.
void applyIntensity(const SliceIntensity& slice, std::span<const std::uint16_t> unpacked,
                    std::span<float> values);
std::size_t applyIntensity(const SliceIntensity& slice, std::span<const double> numbers,
                           std::span<float> values);

// The format of the volume: 16 bits where they hold every value exactly, otherwise float32.
struct IntensityPlan {
    VoxelFormat format = VoxelFormat::stored16;
    // stored16 only.
    UnitsFromStored unitsFromStored = {};
    std::optional<StoredRange> padding = {};
    std::vector<SliceMap> slices = {};  // one per slice
    // float32 only: set when every value is a whole number of these steps, so that `narrowed` may succeed.
    std::optional<UnitsFromStored> steps = {};
};

// The plan from the formats alone. Takes at least one slice, each with a usable format.
IntensityPlan planFromFormats(std::span<const SliceIntensity> slices);

struct NarrowedVoxels {
    UnitsFromStored unitsFromStored;
    std::optional<StoredRange> padding;
    std::vector<std::uint16_t> voxels;
};

// Converts float32 voxels, with NaN as padding, to 16 bits on all cores. Nothing when a value would change,
// or when cancelled.
std::optional<NarrowedVoxels> narrowed(std::span<const float> values, const UnitsFromStored& steps,
                                       const CancelToken& cancel = {});

}  // namespace macula::dicom
