// Which part of a volume is shown. World frame: patient LPS, mm.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/frames.h"
#include "base/label_map.h"
#include "base/result.h"
#include "base/volume.h"

namespace macula {

enum class Keep { inside, outside };

struct OrientedBox {
    glm::dvec3 centreMm{0.0};
    glm::dmat3 axes{1.0};  // columns: orthonormal
    glm::dvec3 halfSizeMm{1.0};

    bool operator==(const OrientedBox&) const = default;
};

// Keeps the points with dot(normal, p) >= offsetMm; normal is a unit vector.
struct HalfSpace {
    glm::dvec3 normal{0.0, 1.0, 0.0};
    double offsetMm = 0.0;

    bool operator==(const HalfSpace&) const = default;
};

// One of the eight parts around a point: that to which `towards` leads, each component 1 or -1 (L, P, S are
// positive).
struct Octant {
    glm::dvec3 pointMm{0.0};
    glm::dvec3 towards{1.0, -1.0, 1.0};

    bool operator==(const Octant&) const = default;
};

struct Ball {
    glm::dvec3 centreMm{0.0};
    double radiusMm = 1.0;

    bool operator==(const Ball&) const = default;
};

struct MaskBits;

// Shows voxels by the segment they belong to. On another grid than the volume's the nearest label counts;
// what lies outside of the map's grid belongs to nothing.
struct Mask {
    std::shared_ptr<const LabelMap> labels = {};
    std::vector<std::uint16_t> numbers = {};  // of segments; empty: any but 0
    Keep keep = Keep::inside;
    // Instead of the three above: which voxels of the volume are shown. Of no other volume.
    std::shared_ptr<const MaskBits> bits = {};
    // What a picture lacks because of it, in a few words for its remarks: "table left out". No patient data.
    Text remark = {};

    bool operator==(const Mask&) const = default;
};

// Everything together: what is shown is what each part leaves.
struct Clip {
    static constexpr std::size_t kMostPlanes = 6;

    std::optional<OrientedBox> box;
    Keep ofBox = Keep::inside;
    std::vector<HalfSpace> planes;  // at most kMostPlanes
    std::optional<Octant> cut;      // is removed
    std::optional<Ball> ball;
    Keep ofBall = Keep::inside;
    std::optional<Mask> mask;

    // What is removed is hidden from the eye only, and shades and reflects as before.
    bool removedCastsShadow = false;
    // The faces of the clip show the values themselves through this window, opaque above its low end.
    std::optional<DisplayWindow> greyFaces;
    // At and below that end they are black; else clear, and show what lies deeper.
    bool facesBelowWindowAreBlack = false;

    bool hasShape() const { return box || !planes.empty() || cut || ball; }
    bool isNothing() const { return !hasShape() && !mask; }

    bool operator==(const Clip&) const = default;  // of masks: the same one
};

// The half-spaces whose intersection the box or the octant is.
std::array<HalfSpace, 6> sidesOf(const OrientedBox& box);
std::array<HalfSpace, 3> sidesOf(const Octant& octant);

// Fails with usage when a number is not finite, a size is not positive, axes are not orthonormal to 1e-6, or
// there are too many planes.
Result<void> validate(const Clip& clip);

// Nothing of this box (of any frame) is shown, whatever the mask says. Conservative: may be false of boxes of
// which nothing is.
bool removesAll(const Clip& clip, const glm::dmat4& worldFromFrame, const Box& boxInFrame);

// All of this box is shown. Conservative likewise.
bool removesNothing(const Clip& clip, const glm::dmat4& worldFromFrame, const Box& boxInFrame);

// Whether the point is shown, as far as box, planes, corner and ball go.
bool shows(const Clip& clip, const glm::dvec3& pointMm);

}  // namespace macula
