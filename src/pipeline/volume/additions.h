// What a picture shows together with a volume: a second volume with its own transfer function, and coloured
// segments. shaders/lib/mixture.glsl mixes them.
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

// A second volume, shown within the box of the first. Its gradient opacity is ignored, and its phase function
// is that of the first.
struct DrawnSecondVolume {
    std::shared_ptr<const Volume> volume;  // stored16
    // Used as it is: fit it to `volume` before (fitted).
    std::shared_ptr<const TransferFunction> function;
    glm::dmat4 secondFromVolumeMm{1.0};  // LPS to LPS, mm: the registration; 1: the same frame

    bool operator==(const DrawnSecondVolume&) const = default;  // same objects
};

// The colour of each voxel of a volume, within the smallest box that contains all coloured ones.
struct TintBox {
    glm::ivec3 volumeSize{0};
    glm::ivec3 low{0};
    glm::ivec3 size{0};
    std::vector<std::uint8_t> voxels;  // of the box, x fastest; 0: no colour, else 1 + its index
};

struct SegmentTints {
    static constexpr std::size_t kMostColours = 255;

    struct Colour {
        glm::vec3 rgb{1.0f};   // sRGB-encoded, 0 to 1
        float opacity = 1.0f;  // 0 to 1: factor of the extinction of the volume's matter

        bool operator==(const Colour&) const = default;
    };
    std::shared_ptr<const TintBox> box;
    std::vector<Colour> colours;

    bool operator==(const SegmentTints&) const = default;  // same box object
};

struct Additions {
    std::optional<DrawnSecondVolume> second;
    std::optional<SegmentTints> tints;  // of the volume; colours at least one voxel
    Text remark = {};                   // on pictures with these: "with PT"; no patient data

    bool isNothing() const { return !second && !tints; }
    bool operator==(const Additions&) const = default;
};

// Fails with usage if a transform cannot be inverted, a colour or an opacity is out of range, or tints belong
// to another volume; with inputNotUsable as validate of the function does. `valid` are known to be valid for
// that volume: a box of segments that both share is not checked again.
Result<void> validate(const Additions& additions, const Volume& volume, const Additions& valid = {});

// Whether they differ at most in coloured segments. Then majorants, outlines and voxels on the device stay
// valid: a segment removes extinction, and never adds any.
bool isSameMatter(const Additions& a, const Additions& b);

// From voxels of the volume to voxels of the second one, with integers at centres.
glm::dmat4 secondVoxelFromVoxel(const DrawnSecondVolume& second, const Volume& volume);

// The medium of the second volume, on its own grid of bricks and with its own majorants.
struct SecondMedium {
    BrickGrid grid;
    Medium medium;
};
SecondMedium makeSecondMedium(const DrawnSecondVolume& second);

// By brick of the volume: a majorant of the extinction of the second volume in it, 0 if it has none there;
// for makeMedium. Uses all cores.
std::vector<float> boundsInVolume(const DrawnSecondVolume& second, const SecondMedium& made,
                                  const Volume& volume, const BrickGrid& grid);
// Both steps together; empty without a second volume.
std::vector<float> addedBounds(const Additions& additions, const Volume& volume, const BrickGrid& grid);

// What shaders read: albedo and extinction of the second volume by entry, then albedo and extinction factor
// of each colour. Empty without additions.
std::vector<glm::vec4> additionTable(const Additions& additions);

// TraceParams::stepsPerEntry for the second volume.
double stepsPerEntryOf(const DrawnSecondVolume& second);

// The second volume's extinction at single points, on the host.
class SecondExtinction {
  public:
    SecondExtinction(const DrawnSecondVolume& second, const Volume& volume);

    // Per mm; 0 outside the second volume. The point is in voxels of the volume, with integers at centres.
    double at(const glm::dvec3& voxel) const;

  private:
    std::shared_ptr<const Volume> second_;
    std::vector<glm::vec4> optics_;  // by entry
    glm::dmat4 secondFromVoxel_;
};

}  // namespace macula
