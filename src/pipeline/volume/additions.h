// What is shown beside a volume in the same picture: a second volume with a curve of its own, and segments
// with colours. How they mix is in shaders/lib/mixture.glsl.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/frames.h"
#include "base/message.h"
#include "base/result.h"
#include "base/volume.h"
#include "pipeline/volume/brick_grid.h"
#include "pipeline/volume/medium.h"
#include "pipeline/volume/transfer_function.h"

namespace macula {

// Shown as far as the box of the volume reaches. Its gradient opacity counts for nothing, and its phase
// function is that of the volume.
struct DrawnSecondVolume {
    std::shared_ptr<const Volume> volume;  // stored16
    // Used as it is: fit it to that volume before (fitted).
    std::shared_ptr<const TransferFunction> function;
    glm::dmat4 secondFromVolumeMm{1.0};  // LPS to LPS, mm: a registration; 1: one frame

    bool operator==(const DrawnSecondVolume&) const = default;  // of the same objects
};

// Which colour each voxel of a volume has, within the smallest box that holds all that have any.
struct TintBox {
    glm::ivec3 volumeSize{0};
    glm::ivec3 low{0};
    glm::ivec3 size{0};
    std::vector<std::uint8_t> voxels;  // of the box, x fastest; 0: none, else 1 + index of the colour
};

struct SegmentTints {
    static constexpr std::size_t kMostColours = 255;

    struct Colour {
        glm::vec3 rgb{1.0f};   // sRGB-encoded, 0 to 1
        float opacity = 1.0f;  // 0 to 1: what is left of the extinction of the volume's matter

        bool operator==(const Colour&) const = default;
    };
    std::shared_ptr<const TintBox> box;
    std::vector<Colour> colours;

    bool operator==(const SegmentTints&) const = default;  // of the same box
};

struct Additions {
    std::optional<DrawnSecondVolume> second;
    std::optional<SegmentTints> tints;  // of the volume; never of no voxel
    Text remark = {};                   // of pictures with these: "with PT"; no patient data

    bool isNothing() const { return !second && !tints; }
    bool operator==(const Additions&) const = default;
};

// usage when a transform cannot be inverted, a colour or an opacity is not one, or tints are not of that
// volume; inputNotUsable as validate of the function. `valid` are of that volume and known to be valid: a box
// of segments that is theirs is not gone through again.
Result<void> validate(const Additions& additions, const Volume& volume, const Additions& valid = {});

// Whether they differ in coloured segments at most, wherever these lie, so that bounds, outlines and voxels
// on the device are the same: a segment takes extinction away and never adds any.
bool isSameMatter(const Additions& a, const Additions& b);

// With integers at voxel centres, from the volume to the second one.
glm::dmat4 secondVoxelFromVoxel(const DrawnSecondVolume& second, const Volume& volume);

// The second volume by itself, on its own grid and with bounds of its own.
struct SecondMedium {
    BrickGrid grid;
    Medium medium;
};
SecondMedium makeSecondMedium(const DrawnSecondVolume& second);

// By brick of the volume: a bound of the extinction that the second volume has anywhere in it, 0 where it has
// none; for makeMedium. On all cores.
std::vector<float> boundsInVolume(const DrawnSecondVolume& second, const SecondMedium& made,
                                  const Volume& volume, const BrickGrid& grid);
// All of that at once; empty where there is no second volume.
std::vector<float> addedBounds(const Additions& additions, const Volume& volume, const BrickGrid& grid);

// What shaders read: albedo and extinction of the second volume by entry, then of each colour the albedo and
// the factor of extinction. Empty for nothing.
std::vector<glm::vec4> additionTable(const Additions& additions);

// See TraceParams::stepsPerEntry.
double stepsPerEntryOf(const DrawnSecondVolume& second);

// The second volume's extinction at single points, on the host.
class SecondExtinction {
  public:
    SecondExtinction(const DrawnSecondVolume& second, const Volume& volume);

    // Per mm; 0 outside of it. The point is in voxels of the volume, integers at centres.
    double at(const glm::dvec3& voxel) const;

  private:
    std::shared_ptr<const Volume> second_;
    std::vector<glm::vec4> optics_;  // by entry
    glm::dmat4 secondFromVoxel_;
};

}  // namespace macula
