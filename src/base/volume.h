// The grid of scalar values from which everything is rendered.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "base/frames.h"
#include "base/message.h"
#include "base/result.h"
#include "base/text.h"

namespace macula {

enum class Unit {
    hounsfield,
    raw,  // the scanner's own numbers (MR); no physical meaning across studies
    becquerelsPerMillilitre,
    suvBodyWeight,  // standardised uptake value by body weight, g/mL; people say SUV
    other,          // another physical unit: see Volume::unitName
};

// The symbol of a unit, for a person: "HU"; empty for raw and other.
std::string_view unitSymbol(Unit unit);
// The name of a unit, for a sentence. Most names are symbols; a few are English words, which this makes
// translatable.
Text unitText(std::string_view name);

// How the voxels are stored.
enum class VoxelFormat {
    stored16,  // 16-bit stored values with a linear map to units
    float32,   // the values themselves
};

// value = slope * stored + intercept. slope > 0.
struct UnitsFromStored {
    double slope = 1.0;
    double intercept = 0.0;

    double operator()(double stored) const { return slope * stored + intercept; }
    bool operator==(const UnitsFromStored&) const = default;
};

// Closed interval of stored values.
struct StoredRange {
    std::uint16_t low = 0;
    std::uint16_t high = 0;

    bool contains(std::uint16_t stored) const { return low <= stored && stored <= high; }
    bool operator==(const StoredRange&) const = default;
};

// Closed interval of values, in units.
struct ValueRange {
    double low = 0.0;
    double high = 0.0;

    bool operator==(const ValueRange&) const = default;
};

// Closed interval of slices (k).
struct SliceRange {
    int first = 0;
    int last = 0;

    bool operator==(const SliceRange&) const = default;
};

// A display window that the scanner proposes (PS3.3 C.11.2).
struct DisplayWindow {
    double center = 0.0;  // in units
    double width = 1.0;
    std::string explanation;  // "LUNG"; may be empty
    std::string function;     // VOILUTFunction: "LINEAR", "LINEAR_EXACT", "SIGMOID"; LINEAR when empty

    bool operator==(const DisplayWindow&) const = default;
};

// Where a volume comes from, and what its loader had to assume. May name a patient: never logged.
struct Provenance {
    std::string studyInstanceUid;
    std::string seriesInstanceUid;
    std::string description;             // SeriesDescription, or the generator of the volume
    std::vector<Text> assumptions;       // sentences, each naming what was missing and what was used instead
    std::vector<Message> messages = {};  // what loading found
    std::vector<SliceRange> interpolatedSlices = {};  // ascending; slices without an image of their own
    // Whether the pixel spacing is calibrated (PS3.3 10.7); else lengths, areas and volumes are estimates.
    bool isCalibrated = true;
};

struct VolumeOptions {
    glm::ivec3 size{0};  // voxels along (i, j, k) = (column, row, slice)
    glm::dmat4 worldFromVoxel{
        1.0};  // voxel (i, j, k) to patient LPS mm; may be oblique, anisotropic, sheared
    UnitsFromStored unitsFromStored;  // applies to every voxel; float32: the identity
    Unit unit = Unit::raw;
    std::string modality;                // DICOM Modality (0008,0060)
    std::optional<StoredRange> padding;  // stored values that mean "outside the scan" (PS3.3 C.7.5.1.1.2)
    Provenance provenance;
    std::optional<float> floatPadding =
        {};                     // float32: this value means "outside the scan", as NaN always does
    std::string unitName = {};  // if it differs from unitSymbol(unit)
    std::vector<DisplayWindow> windows = {};
    std::string bodyPart = {};  // DICOM Body Part Examined (0018,0015), if all images agree; else empty
};

// Immutable grid of values, i fastest, then j, then k: 16-bit stored values with a linear map to units where
// the data allow that exactly, else float32. Shared by reference (std::shared_ptr<const Volume>); safe to
// read from any thread.
class Volume {
  public:
    // Takes the voxels over, without copying. Fails with inputNotUsable when a size is below 1, the number of
    // voxels is not size.x * size.y * size.z, the affine is not invertible, or the slope is not positive and
    // finite.
    static Result<Volume> create(VolumeOptions options, std::vector<std::uint16_t> voxels);
    // The same for float32; the options' map must be the identity, their `padding` empty. An infinite voxel
    // is not a measurement, and becomes NaN, which is padding.
    static Result<Volume> createFloat(VolumeOptions options, std::vector<float> voxels);

    VoxelFormat format() const { return format_; }
    glm::ivec3 size() const { return options_.size; }
    std::size_t voxelCount() const;
    const glm::dmat4& worldFromVoxel() const { return options_.worldFromVoxel; }
    UnitsFromStored unitsFromStored() const { return options_.unitsFromStored; }
    Unit unit() const { return options_.unit; }
    std::string unitName() const;  // for a person; empty for raw
    const std::string& modality() const { return options_.modality; }
    const std::string& bodyPart() const { return options_.bodyPart; }
    const std::optional<StoredRange>& padding() const { return options_.padding; }
    const std::optional<float>& floatPadding() const { return options_.floatPadding; }
    const std::vector<DisplayWindow>& windows() const { return options_.windows; }
    const Provenance& provenance() const { return options_.provenance; }

    std::span<const std::uint16_t> voxels() const;    // stored16 only
    std::span<const float> floatVoxels() const;       // float32 only
    std::uint16_t stored(int i, int j, int k) const;  // stored16 only
    // The value in units. For padding it is the file's own value; in volumes whose slices differ in padding
    // or map it is NaN, or one number below all other values.
    double value(int i, int j, int k) const;
    bool isPadding(int i, int j, int k) const;

    // Smallest and largest value that is not padding; finite; nothing when every voxel is padding.
    const std::optional<ValueRange>& valueRange() const { return valueRange_; }
    // The same in stored values, stored16 only; {0, 0} when every voxel is padding.
    StoredRange storedRange() const;
    // The stored value as which padding is drawn, stored16 only: that of air (-1000 HU), which may lie
    // outside 0 to 65535; for units other than HU, the smallest value.
    int airStored() const;

    glm::dvec3 spacingMm() const;  // distances between neighbouring voxels along i, j and k
    Box worldBox() const;          // around all voxels, half a voxel beyond the outer centres

  private:
    Volume(VolumeOptions options, std::vector<std::uint16_t> voxels);
    Volume(VolumeOptions options, std::vector<float> voxels);

    std::size_t indexOf(int i, int j, int k) const;
    bool isPadding(float voxel) const;

    VolumeOptions options_;
    VoxelFormat format_ = VoxelFormat::stored16;
    std::vector<std::uint16_t> voxels_;
    std::vector<float> floatVoxels_;
    StoredRange storedRange_;
    std::optional<ValueRange> valueRange_;
};

// The volume for drawing, which needs 16 bits: the volume itself when it has them, else a quantised copy that
// may clamp a few values to the range of the others; its assumptions then say so (base/quantised.h). Not for
// measurements. May throw std::bad_alloc.
std::shared_ptr<const Volume> in16Bits(std::shared_ptr<const Volume> volume);

}  // namespace macula
