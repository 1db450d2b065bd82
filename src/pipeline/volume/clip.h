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

// One of the eight octants around a point, in the direction `towards`, whose components are 1 or -1 (L, P and
// S are positive).
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

// Shows voxels by the segment that they belong to. If the map has another grid than the volume, the nearest
// label counts; voxels outside its grid belong to no segment.
struct Mask {
    std::shared_ptr<const LabelMap> labels = {};
    std::vector<std::uint16_t> numbers = {};  // of segments; empty: all but 0
    Keep keep = Keep::inside;
    // Replaces the three members above: which voxels are shown, of exactly this volume.
    std::shared_ptr<const MaskBits> bits = {};
    // For the remarks of a picture, what the mask hides: "table left out". No patient data.
    Text remark = {};

    bool operator==(const Mask&) const = default;
};

// A point is shown if all parts together show it.
struct Clip {
    static constexpr std::size_t kMostPlanes = 6;

    std::optional<OrientedBox> box;
    Keep ofBox = Keep::inside;
    std::vector<HalfSpace> planes;  // at most kMostPlanes
    std::optional<Octant> cut;      // the octant that is removed
    std::optional<Ball> ball;
    Keep ofBall = Keep::inside;
    std::optional<Mask> mask;

    // Removed matter is hidden only from the eye; it casts shadow and reflects light as before.
    bool removedCastsShadow = false;
    // The faces of the clip show grey values through this window, opaque above its low end.
    std::optional<DisplayWindow> greyFaces;
    // At and below that end faces are black; if false, clear, and show what lies behind.
    bool facesBelowWindowAreBlack = false;

    bool hasShape() const { return box || !planes.empty() || cut || ball; }
    bool isNothing() const { return !hasShape() && !mask; }

    bool operator==(const Clip&) const = default;  // labels and bits: same objects
};

// The half-spaces whose intersection is the box, or the octant.
std::array<HalfSpace, 6> sidesOf(const OrientedBox& box);
std::array<HalfSpace, 3> sidesOf(const Octant& octant);

// Fails with usage if a number is not finite, a size is not positive, axes are not orthonormal to 1e-6, or
// there are too many planes.
Result<void> validate(const Clip& clip);

// Whether the shape shows nothing of this box, given in any coordinate frame; ignores the mask. Conservative:
// may return false although nothing is shown.
bool removesAll(const Clip& clip, const glm::dmat4& worldFromFrame, const Box& boxInFrame);

// Whether the shape shows all of this box. Conservative likewise; ignores the mask.
bool removesNothing(const Clip& clip, const glm::dmat4& worldFromFrame, const Box& boxInFrame);

// Whether box, planes, corner and ball show the point; ignores the mask.
bool shows(const Clip& clip, const glm::dvec3& pointMm);

}  // namespace macula
