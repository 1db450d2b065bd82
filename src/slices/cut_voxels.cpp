#include "slices/cut_voxels.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <vector>

#include "base/is_finite.h"
#include "slices/outline.h"

namespace macula::slices {

namespace {

constexpr double kFarthestMm = 1e9;     // beyond this, a double cannot distinguish voxels
constexpr double kHalfWayUp = 2e-6;     // in voxels; above rounding errors, and negligible
constexpr double kMereTouch = 1e-6;     // in voxels
constexpr double kOnTheEllipse = 1e-9;  // of a radius

double lengthOf(const glm::dvec3& vector) {
    return std::hypot(vector.x, vector.y, vector.z);  // without overflow
}

// The distance from the centre in radii: 1 on the ellipse.
double radiiFromCentre(const glm::dvec2& mm, const glm::dvec2& radiiMm) {
    return std::hypot(mm.x / radiiMm.x, mm.y / radiiMm.y);
}

using Polygon = std::vector<glm::dvec2>;  // convex

// The part of the polygon with dot(normal, point) <= offset (Sutherland-Hodgman).
Polygon clipped(const Polygon& polygon, const glm::dvec2& normal, double offset) {
    Polygon kept;
    kept.reserve(polygon.size() + 1);
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const glm::dvec2& from = polygon[i];
        const glm::dvec2& to = polygon[(i + 1) % polygon.size()];
        const double beyondFrom = glm::dot(normal, from) - offset;
        const double beyondTo = glm::dot(normal, to) - offset;
        if (beyondFrom <= 0.0) kept.push_back(from);
        if ((beyondFrom <= 0.0) != (beyondTo <= 0.0))
            kept.push_back(from + (beyondFrom / (beyondFrom - beyondTo)) * (to - from));
    }
    return kept;
}

// The plane of an ellipse or an outline among the voxels of a volume: (u, v), in mm from the centre along
// right and down, lies at centre + u * right + v * down in voxel coordinates.
class CutVoxels {
  public:
    // Nothing for an invalid shape, or one too far away.
    static std::optional<CutVoxels> of(const Ellipse& ellipse, const Volume& volume);
    static std::optional<CutVoxels> of(const Outline& outline, const glm::dvec3& normal,
                                       const Volume& volume);

    void forEach(const std::function<void(const glm::ivec3&)>& visit) const;

  private:
    struct Indices {
        int first = 0;
        int end = 0;
    };
    static std::optional<CutVoxels> of(const SlicePlane& plane, const glm::dvec2& radiiMm,
                                       const Volume& volume);
    Indices indices(double low, double high, int axis) const;
    Indices besideTheShape(int axis) const;
    std::optional<glm::ivec3> voxelAt(const glm::dvec2& mm) const;
    bool counts(const glm::ivec3& voxel) const;
    bool countsForOutline(const glm::ivec3& voxel, const glm::dvec2& middleMm) const;
    Polygon cutOf(const glm::ivec3& voxel, const glm::dvec2& middleMm) const;

    glm::ivec3 size_{0};
    glm::dmat4 worldFromVoxel_{1.0};
    glm::dvec3 centreMm_{0.0}, rightMm_{0.0}, downMm_{0.0};  // unit vectors
    glm::dvec2 radiiMm_{0.0};               // of an outline, half of the sides of the box around it
    std::optional<InsideOf> outline_;       // nothing: an ellipse
    std::optional<glm::dvec2> centroidMm_;  // of an outline
    glm::dvec3 centre_{0.0}, right_{0.0}, down_{0.0};  // the same in voxels
    glm::dvec3 normal_{0.0};
    int across_ = 0;              // the voxel axis closest to the plane's normal
    double voxelRadiusMm_ = 0.0;  // from the middle of a voxel to its farthest corner
};

std::optional<CutVoxels> CutVoxels::of(const Ellipse& ellipse, const Volume& volume) {
    return of(ellipse.plane, ellipse.radiiMm, volume);
}

std::optional<CutVoxels> CutVoxels::of(const Outline& outline, const glm::dvec3& normal,
                                       const Volume& volume) {
    auto flat = flatOutline(outline, normal);
    if (!flat) return std::nullopt;
    glm::dvec2 low = flat->points.front();
    glm::dvec2 high = low;
    for (const glm::dvec2& mm : flat->points) {
        low = glm::min(low, mm);
        high = glm::max(high, mm);
    }
    const glm::dvec2 middle = 0.5 * (low + high);
    flat->plane.centreMm += middle.x * flat->plane.right + middle.y * flat->plane.down;
    for (glm::dvec2& mm : flat->points) mm -= middle;
    auto cut = of(flat->plane, 0.5 * (high - low), volume);
    if (!cut) return std::nullopt;
    cut->outline_.emplace(flat->points);
    cut->centroidMm_ = centroidOf(std::span<const glm::dvec2>(flat->points));
    return cut;
}

std::optional<CutVoxels> CutVoxels::of(const SlicePlane& plane, const glm::dvec2& radiiMm,
                                       const Volume& volume) {
    CutVoxels cut;
    cut.size_ = volume.size();
    cut.worldFromVoxel_ = volume.worldFromVoxel();
    cut.centreMm_ = plane.centreMm;
    cut.rightMm_ = plane.right / lengthOf(plane.right);
    cut.downMm_ = plane.down - glm::dot(plane.down, cut.rightMm_) * cut.rightMm_;
    cut.downMm_ /= lengthOf(cut.downMm_);
    cut.radiiMm_ = radiiMm;

    const glm::dmat4 voxelFromWorld = glm::inverse(cut.worldFromVoxel_);
    cut.centre_ = transformPoint(voxelFromWorld, cut.centreMm_);
    cut.right_ = transformVector(voxelFromWorld, cut.rightMm_);
    cut.down_ = transformVector(voxelFromWorld, cut.downMm_);
    cut.normal_ = glm::cross(cut.right_, cut.down_);
    const glm::dvec3 slope = glm::abs(cut.normal_);
    cut.across_ = slope.x >= slope.y && slope.x >= slope.z ? 0 : slope.y >= slope.z ? 1 : 2;
    const bool hasExtent =
        radiiMm.x > 0.0 && radiiMm.y > 0.0 && std::isfinite(radiiMm.x) && std::isfinite(radiiMm.y);
    if (!hasExtent || !(lengthOf(cut.centreMm_) <= kFarthestMm) || !isFinite(cut.centre_) ||
        !isFinite(cut.right_) || !isFinite(cut.down_) || !isFinite(cut.normal_) ||
        !(slope[cut.across_] > 0.0))
        return std::nullopt;
    cut.centre_[cut.across_] += kHalfWayUp;

    const std::array<glm::dvec3, 4> corners{
        {{0.5, 0.5, 0.5}, {0.5, 0.5, -0.5}, {0.5, -0.5, 0.5}, {-0.5, 0.5, 0.5}}};
    for (const glm::dvec3& corner : corners)
        cut.voxelRadiusMm_ =
            std::max(cut.voxelRadiusMm_, lengthOf(transformVector(cut.worldFromVoxel_, corner)));
    return cut;
}

// The indices along an axis whose voxels reach into [low, high], clamped to the volume, however large the
// numbers are.
CutVoxels::Indices CutVoxels::indices(double low, double high, int axis) const {
    const auto inVolume = [&](double index) {
        return index > 0.0 ? int(std::min(index, double(size_[axis]))) : 0;
    };
    return {inVolume(std::ceil(low - 0.5)), inVolume(std::ceil(high + 0.5))};
}

CutVoxels::Indices CutVoxels::besideTheShape(int axis) const {
    const double alongRight = radiiMm_.x * right_[axis];
    const double alongDown = radiiMm_.y * down_[axis];
    const double reach =
        outline_ ? std::abs(alongRight) + std::abs(alongDown) : std::hypot(alongRight, alongDown);
    return indices(centre_[axis] - reach, centre_[axis] + reach, axis);
}

// The voxel around a point of the plane; nothing outside the volume.
std::optional<glm::ivec3> CutVoxels::voxelAt(const glm::dvec2& mm) const {
    const glm::dvec3 at = centre_ + mm.x * right_ + mm.y * down_;
    const glm::ivec3 voxel(glm::clamp(glm::floor(at + 0.5), glm::dvec3(-1.0), glm::dvec3(size_)));
    const bool isInVolume =
        glm::all(glm::greaterThanEqual(voxel, glm::ivec3(0))) && glm::all(glm::lessThan(voxel, size_));
    return isInVolume ? std::optional(voxel) : std::nullopt;
}

void CutVoxels::forEach(const std::function<void(const glm::ivec3&)>& visit) const {
    const std::optional<glm::ivec3> middle = outline_ ? std::nullopt : voxelAt({0.0, 0.0});
    if (middle) visit(*middle);
    bool hasVisited = middle.has_value();

    // Over a column of voxels along `across_` the plane rises by at most a voxel in each direction, so it
    // cuts at most three of the column.
    const int p = (across_ + 1) % 3;
    const int q = (across_ + 2) % 3;
    const double slopeP = -normal_[p] / normal_[across_];
    const double slopeQ = -normal_[q] / normal_[across_];
    const double rise = 0.5 * (std::abs(slopeP) + std::abs(slopeQ));
    const double reach = rise - std::min(kMereTouch, 0.5 * rise);
    const Indices besideP = besideTheShape(p);
    const Indices besideQ = besideTheShape(q);
    glm::ivec3 voxel;
    for (voxel[q] = besideQ.first; voxel[q] < besideQ.end; ++voxel[q]) {
        for (voxel[p] = besideP.first; voxel[p] < besideP.end; ++voxel[p]) {
            const double at =
                centre_[across_] + slopeP * (voxel[p] - centre_[p]) + slopeQ * (voxel[q] - centre_[q]);
            const Indices column = indices(at - reach, at + reach, across_);
            for (voxel[across_] = column.first; voxel[across_] < column.end; ++voxel[across_])
                if (voxel != middle && counts(voxel)) {
                    visit(voxel);
                    hasVisited = true;
                }
        }
    }
    if (hasVisited || !outline_ || !centroidMm_ || !(*outline_)(*centroidMm_)) return;
    if (const auto around = voxelAt(*centroidMm_)) visit(*around);
}

// Whether a voxel that the plane cuts counts for the shape.
bool CutVoxels::counts(const glm::ivec3& voxel) const {
    const glm::dvec3 fromCentreMm = transformPoint(worldFromVoxel_, glm::dvec3(voxel)) - centreMm_;
    const glm::dvec2 middleMm(glm::dot(fromCentreMm, rightMm_), glm::dot(fromCentreMm, downMm_));
    if (outline_) return countsForOutline(voxel, middleMm);
    // Most voxels lie wholly inside the ellipse, or wholly outside: only the others need their cut.
    const double middle = radiiFromCentre(middleMm, radiiMm_);
    const double reach = voxelRadiusMm_ / std::min(radiiMm_.x, radiiMm_.y);
    if (middle + reach <= 1.0) return true;
    if (middle - reach > 1.0 + kOnTheEllipse) return false;
    const auto centroid = centroidOf(cutOf(voxel, middleMm));
    return centroid && radiiFromCentre(*centroid, radiiMm_) <= 1.0 + kOnTheEllipse;
}

bool CutVoxels::countsForOutline(const glm::ivec3& voxel, const glm::dvec2& middleMm) const {
    const glm::dvec2 farthest = radiiMm_ + voxelRadiusMm_;
    if (std::abs(middleMm.x) > farthest.x || std::abs(middleMm.y) > farthest.y) return false;
    const auto centroid = centroidOf(cutOf(voxel, middleMm));
    return centroid && (*outline_)(*centroid);
}

// The plane's cut through a voxel, in (u, v). `middleMm` is the point of the plane that is nearest to the
// voxel's middle.
Polygon CutVoxels::cutOf(const glm::ivec3& voxel, const glm::dvec2& middleMm) const {
    const double r = voxelRadiusMm_;  // no point of the voxel is farther from its middle
    Polygon cut{middleMm + glm::dvec2(-r, -r), middleMm + glm::dvec2(r, -r), middleMm + glm::dvec2(r, r),
                middleMm + glm::dvec2(-r, r)};
    for (int axis = 0; axis < 3; ++axis) {
        const glm::dvec2 along(right_[axis], down_[axis]);
        const double middle = double(voxel[axis]) - centre_[axis];
        cut = clipped(cut, along, middle + 0.5);
        cut = clipped(cut, -along, 0.5 - middle);
    }
    return cut;
}

}  // namespace

void forEachCutVoxel(const Ellipse& ellipse, const Volume& volume,
                     const std::function<void(const glm::ivec3&)>& visit) {
    if (const auto cut = CutVoxels::of(ellipse, volume)) cut->forEach(visit);
}

void forEachCutVoxel(const Outline& outline, const glm::dvec3& normal, const Volume& volume,
                     const std::function<void(const glm::ivec3&)>& visit) {
    if (const auto cut = CutVoxels::of(outline, normal, volume)) cut->forEach(visit);
}

}  // namespace macula::slices
