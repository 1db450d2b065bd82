// The scalar grid everything is rendered from.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "base/frames.h"
#include "base/result.h"

namespace macula {

enum class Unit {
    hounsfield,
    raw
};  // raw: the scanner's own numbers (MR); no physical meaning across studies

// value = slope * stored + intercept. slope > 0.
struct UnitsFromStored {
    double slope = 1.0;
    double intercept = 0.0;

    double operator()(double stored) const { return slope * stored + intercept; }
};

// Closed interval of stored values.
struct StoredRange {
    std::uint16_t low = 0;
    std::uint16_t high = 0;

    bool contains(std::uint16_t stored) const { return low <= stored && stored <= high; }
};

// Where a volume comes from and what had to be assumed to make it. May name a patient: never logged.
struct Provenance {
    std::string studyInstanceUid;
    std::string seriesInstanceUid;
    std::string description;  // SeriesDescription, or what generated it
    std::vector<std::string>
        assumptions;  // sentences, each naming what was missing and what was taken instead
};

struct VolumeOptions {
    glm::ivec3 size{0};  // voxels along (i, j, k) = (column, row, slice)
    glm::dmat4 worldFromVoxel{
        1.0};  // voxel (i, j, k) to patient LPS mm; may be oblique, anisotropic, sheared
    UnitsFromStored unitsFromStored;  // applies to every voxel
    Unit unit = Unit::raw;
    std::string modality;                // DICOM Modality (0008,0060)
    std::optional<StoredRange> padding;  // stored values that mean "outside the scan" (PS3.3 C.7.5.1.1.2)
    Provenance provenance;
};

// Immutable grid of 16-bit stored values with a linear map to units, i fastest, then j, then k. Shared by
// reference (std::shared_ptr<const Volume>); safe to read from any thread.
class Volume {
  public:
    // Takes the voxels over, without copying. Fails with inputNotUsable when a size is below 1, the number of
    // voxels is not size.x * size.y * size.z, the affine is not invertible, or the slope is not positive and
    // finite.
    static Result<Volume> create(VolumeOptions options, std::vector<std::uint16_t> voxels);

    glm::ivec3 size() const { return options_.size; }
    const glm::dmat4& worldFromVoxel() const { return options_.worldFromVoxel; }
    UnitsFromStored unitsFromStored() const { return options_.unitsFromStored; }
    Unit unit() const { return options_.unit; }
    const std::string& modality() const { return options_.modality; }
    const std::optional<StoredRange>& padding() const { return options_.padding; }
    const Provenance& provenance() const { return options_.provenance; }

    std::span<const std::uint16_t> voxels() const { return voxels_; }
    std::uint16_t stored(int i, int j, int k) const;
    double value(int i, int j, int k) const { return options_.unitsFromStored(stored(i, j, k)); }

    // Smallest and largest stored value that is not padding; {0, 0} when every voxel is padding.
    StoredRange storedRange() const { return storedRange_; }
    // What padding is drawn as: the stored value of air (-1000 HU), which may lie outside 0 to 65535, or the
    // smallest value for other units.
    int airStored() const;

    glm::dvec3 spacingMm() const;  // lengths of the voxel axes
    Box worldBox() const;          // of all voxels, half a voxel beyond the outer centres

  private:
    Volume(VolumeOptions options, std::vector<std::uint16_t> voxels);

    VolumeOptions options_;
    std::vector<std::uint16_t> voxels_;
    StoredRange storedRange_;
};

}  // namespace macula
