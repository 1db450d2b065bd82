#include "slices/slice_plane.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "base/is_finite.h"

namespace macula::slices {

namespace {

// Rounding must not decide between two equally near orientations.
constexpr double kClearly = 1e-9;

bool isUnitVector(const glm::dvec3& v, double tolerance) {
    return std::abs(glm::length(v) - 1.0) < tolerance;
}

// Unit vectors, because products of voxel sides may be too small for a double.
std::array<glm::dvec3, 3> voxelDirections(const Volume& volume) {
    const glm::dmat4& m = volume.worldFromVoxel();
    const auto direction = [&](int axis) { return glm::dvec3(m[axis]) / glm::length(glm::dvec3(m[axis])); };
    return {direction(0), direction(1), direction(2)};
}

glm::dvec3 perpendicular(const glm::dvec3& a, const glm::dvec3& b) {
    const glm::dvec3 across = glm::cross(a, b);
    return across / glm::length(across);
}

// In the order of cornersOf.
std::array<glm::dvec3, 8> cornersMm(const Volume& volume) {
    auto corners = cornersOf({glm::dvec3(-0.5), glm::dvec3(volume.size()) - 0.5});
    for (glm::dvec3& corner : corners) corner = transformPoint(volume.worldFromVoxel(), corner);
    return corners;
}

// How far points are from the middle of the picture, along right and down.
class PictureReach {
  public:
    explicit PictureReach(const SlicePlane& plane) : plane_(plane) {}

    void include(const glm::dvec3& mm) {
        const glm::dvec3 from = mm - plane_.centreMm;
        reachMm_ = glm::max(reachMm_,
                            glm::abs(glm::dvec2(glm::dot(from, plane_.right), glm::dot(from, plane_.down))));
    }
    double mmPerPixel(const glm::ivec2& sizePx) const {
        const glm::dvec2 scales = 2.0 * reachMm_ / glm::dvec2(sizePx);
        return std::max(scales.x, scales.y);
    }

  private:
    SlicePlane plane_;
    glm::dvec2 reachMm_{0.0};
};

}  // namespace

bool SlicePlane::isUsable() const {
    constexpr double kTolerance = 1e-3;
    return isFinite(centreMm) && isUnitVector(right, kTolerance) && isUnitVector(down, kTolerance) &&
           std::abs(glm::dot(right, down)) < kTolerance;
}

glm::dquat leastTurn(const glm::dvec3& from, const glm::dvec3& to, const glm::dvec3& ifOpposite) {
    constexpr double kOpposite = 1e-12;
    const double cosine = glm::dot(from, to);
    if (1.0 + cosine < kOpposite) return {0.0, ifOpposite};
    return glm::normalize(glm::dquat(1.0 + cosine, glm::cross(from, to)));
}

SlicePlane tilted(const SlicePlane& plane, const glm::dquat& turn) {
    const glm::dvec3 from = plane.normal();
    glm::dvec3 to = turn * from;
    if (glm::dot(from, to) < 0.0) to = -to;
    const glm::dquat tilt = leastTurn(from, to, plane.down);
    const glm::dvec3 right = glm::normalize(tilt * plane.right);
    return {.centreMm = plane.centreMm, .right = right, .down = perpendicular(glm::normalize(to), right)};
}

SlicePlane planeOf(Orientation orientation, const glm::dvec3& centreMm) {
    const glm::dvec3 left{1.0, 0.0, 0.0};
    const glm::dvec3 posterior{0.0, 1.0, 0.0};
    const glm::dvec3 inferior{0.0, 0.0, -1.0};
    switch (orientation) {
        case Orientation::axial:
            break;
        case Orientation::coronal:
            return {.centreMm = centreMm, .right = left, .down = inferior};
        case Orientation::sagittal:
            return {.centreMm = centreMm, .right = posterior, .down = inferior};
    }
    return {.centreMm = centreMm, .right = left, .down = posterior};
}

Orientation acquiredOrientation(const Volume& volume) {
    const auto directions = voxelDirections(volume);
    const glm::dvec3 across = perpendicular(directions[0], directions[1]);
    Orientation nearest = Orientation::axial;
    double most = 0.0;
    for (const Orientation orientation : {Orientation::axial, Orientation::coronal, Orientation::sagittal}) {
        const double along = std::abs(glm::dot(across, planeOf(orientation, {}).normal()));
        if (along <= most + kClearly) continue;
        most = along;
        nearest = orientation;
    }
    return nearest;
}

SlicePlane acquiredPlane(const Volume& volume, const glm::dvec3& centreMm) {
    const auto directions = voxelDirections(volume);
    const glm::dvec3 i = directions[0];
    const glm::dvec3 j = glm::cross(perpendicular(i, directions[1]), i);
    const SlicePlane standard = planeOf(acquiredOrientation(volume), centreMm);

    SlicePlane nearest = standard;
    double most = std::numeric_limits<double>::lowest();
    for (const auto& [right, down] : {std::pair{i, j}, std::pair{j, i}}) {
        for (const double rightSign : {1.0, -1.0}) {
            for (const double downSign : {1.0, -1.0}) {
                const SlicePlane plane{
                    .centreMm = centreMm, .right = rightSign * right, .down = downSign * down};
                if (glm::dot(plane.normal(), standard.normal()) <= 0.0) continue;  // mirrored
                const double alike =
                    glm::dot(plane.right, standard.right) + glm::dot(plane.down, standard.down);
                if (alike <= most + kClearly) continue;
                most = alike;
                nearest = plane;
            }
        }
    }
    return nearest;
}

glm::dvec3 SliceFrame::worldFromPicture(const glm::dvec2& px) const {
    const glm::dvec2 fromMiddleMm = (px - 0.5 * glm::dvec2(sizePx)) * mmPerPixel;
    return plane.centreMm + fromMiddleMm.x * plane.right + fromMiddleMm.y * plane.down;
}

glm::dvec2 SliceFrame::pictureFromWorld(const glm::dvec3& mm) const {
    const glm::dvec3 from = mm - plane.centreMm;
    return glm::dvec2(glm::dot(from, plane.right), glm::dot(from, plane.down)) / mmPerPixel +
           0.5 * glm::dvec2(sizePx);
}

double SliceFrame::distanceMm(const glm::dvec3& mm) const {
    return glm::dot(mm - plane.centreMm, plane.normal());
}

bool SliceFrame::isUsable() const {
    return plane.isUsable() && std::isfinite(mmPerPixel) && mmPerPixel > 0.0;
}

DepthRange depthsMm(const Volume& volume, const SlicePlane& plane) {
    const SliceFrame frame{.plane = plane};
    DepthRange depths{std::numeric_limits<double>::max(), std::numeric_limits<double>::lowest()};
    for (const glm::dvec3& corner : cornersMm(volume)) {
        depths.lowMm = std::min(depths.lowMm, frame.distanceMm(corner));
        depths.highMm = std::max(depths.highMm, frame.distanceMm(corner));
    }
    return depths;
}

double fittedMmPerPixel(const Volume& volume, const SlicePlane& plane, const glm::ivec2& sizePx) {
    if (!plane.isUsable() || sizePx.x < 1 || sizePx.y < 1) return 1.0;
    const auto corners = cornersMm(volume);
    const SliceFrame frame{.plane = plane};

    // The corners of the section are where the plane meets the volume's edges.
    PictureReach met(plane);
    for (unsigned low = 0; low < corners.size(); ++low) {
        for (const unsigned axis : {1U, 2U, 4U}) {
            const unsigned high = low | axis;
            if (high == low) continue;
            const double lowMm = frame.distanceMm(corners[low]);
            const double highMm = frame.distanceMm(corners[high]);
            if ((lowMm > 0.0 && highMm > 0.0) || (lowMm < 0.0 && highMm < 0.0)) continue;
            const double share = lowMm == highMm ? 0.0 : lowMm / (lowMm - highMm);
            met.include(corners[low] + share * (corners[high] - corners[low]));
        }
    }
    if (met.mmPerPixel(sizePx) > 0.0) return met.mmPerPixel(sizePx);

    PictureReach all(plane);
    for (const glm::dvec3& corner : corners) all.include(corner);
    return all.mmPerPixel(sizePx);
}

double stepMm(const Volume& volume, const SlicePlane& plane) {
    constexpr double kParallel = 1e-3;
    const glm::dvec3 sides = volume.spacingMm();
    const auto directions = voxelDirections(volume);
    if (plane.isUsable()) {
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const glm::dvec3 across = perpendicular(directions[(axis + 1) % 3], directions[(axis + 2) % 3]);
            if (glm::length(glm::cross(across, plane.normal())) < kParallel)
                return std::abs(glm::dot(across, directions[axis])) * sides[int(axis)];
        }
    }
    return std::min({sides.x, sides.y, sides.z});
}

}  // namespace macula::slices
