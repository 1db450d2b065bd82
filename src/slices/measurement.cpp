#include "slices/measurement.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "slices/cut_voxels.h"
#include "slices/interpolated.h"
#include "slices/outline.h"
#include "slices/overloaded.h"

namespace macula::slices {

namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kParallelDeg = 1.0;

// Without overflow; NaN if a number is not finite.
double lengthOf(const glm::dvec3& vector) {
    const double length = std::hypot(vector.x, vector.y, vector.z);
    return std::isfinite(length) ? length : kNaN;
}

double angleBetweenDeg(const glm::dvec3& first, const glm::dvec3& second) {
    const glm::dvec3 a = first / lengthOf(first);  // NaN when it has no length
    const glm::dvec3 b = second / lengthOf(second);
    // With atan2: an arc cosine would lose half of its digits near 0 and 180 degrees.
    return glm::degrees(std::atan2(lengthOf(glm::cross(a, b)), glm::dot(a, b)));
}

// Welford's sums: the mean of large values with a small deviation keeps its digits.
class Sums {
  public:
    void add(const Volume& volume, const glm::ivec3& voxel) {
        if (volume.isPadding(voxel.x, voxel.y, voxel.z)) return;
        const double value = volume.value(voxel.x, voxel.y, voxel.z);
        if (!std::isfinite(value)) return;
        ++values_.voxels;
        if (isInterpolated(volume, voxel.z)) ++values_.interpolated;
        const double before = value - values_.mean;
        values_.mean += before / double(values_.voxels);
        squares_ += before * (value - values_.mean);
        values_.low = values_.voxels == 1 ? value : std::min(values_.low, value);
        values_.high = values_.voxels == 1 ? value : std::max(values_.high, value);
    }
    std::optional<AreaValues> result(double areaMm2) const {
        if (values_.voxels == 0) return std::nullopt;
        AreaValues values = values_;
        values.areaMm2 = areaMm2;
        values.deviation = values.voxels > 1 ? std::sqrt(squares_ / double(values.voxels - 1)) : kNaN;
        return values;
    }

  private:
    AreaValues values_;
    double squares_ = 0.0;
};

}  // namespace

std::string_view kindOf(const Measurement& measurement) {
    return std::visit(
        Overloaded{[](const Distance&) { return "distance"; }, [](const Angle&) { return "angle"; },
                   [](const Ellipse&) { return "ellipse"; },
                   [](const Bidirectional&) { return "bidirectional"; },
                   [](const CobbAngle&) { return "cobb angle"; }, [](const Arrow&) { return "arrow"; },
                   [](const Outline&) { return "outline"; }, [](const OpenLine&) { return "line"; }},
        measurement.shape);
}

std::vector<glm::dvec3> pointsOf(const Measurement& measurement) {
    using Points = std::vector<glm::dvec3>;
    return std::visit(
        Overloaded{[](const Distance& d) { return Points(d.endsMm.begin(), d.endsMm.end()); },
                   [](const Angle& a) { return Points(a.pointsMm.begin(), a.pointsMm.end()); },
                   [](const Ellipse& e) {
                       const glm::dvec3& centre = e.plane.centreMm;
                       return Points{centre, centre + e.radiiMm.x * e.plane.right,
                                     centre + e.radiiMm.y * e.plane.down};
                   },
                   [](const Bidirectional& b) {
                       return Points{b.firstMm[0], b.firstMm[1], b.secondMm[0], b.secondMm[1]};
                   },
                   [](const CobbAngle& c) { return Points(c.pointsMm.begin(), c.pointsMm.end()); },
                   [](const Arrow& a) {
                       return Points{a.tipMm, a.tailMm};
                   },
                   [](const Outline& o) { return o.pointsMm; }, [](const OpenLine& l) { return l.pointsMm; }},
        measurement.shape);
}

double lengthMm(const Distance& distance) {
    return lengthOf(distance.endsMm[1] - distance.endsMm[0]);
}

double lengthMm(const OpenLine& line) {
    if (line.pointsMm.size() < 2) return kNaN;
    double length = 0.0;
    for (std::size_t i = 1; i < line.pointsMm.size(); ++i)
        length += lengthOf(line.pointsMm[i] - line.pointsMm[i - 1]);
    return std::isfinite(length) ? length : kNaN;
}

double angleDeg(const Angle& angle) {
    return angleBetweenDeg(angle.pointsMm[0] - angle.pointsMm[1], angle.pointsMm[2] - angle.pointsMm[1]);
}

double angleDeg(const CobbAngle& angle) {
    constexpr double kHalfTurn = 180.0;
    const double drawn =
        angleBetweenDeg(angle.pointsMm[1] - angle.pointsMm[0], angle.pointsMm[3] - angle.pointsMm[2]);
    return drawn > 0.5 * kHalfTurn ? kHalfTurn - drawn : drawn;
}

Axes axesOf(const Bidirectional& lesion) {
    const double first = lengthOf(lesion.firstMm[1] - lesion.firstMm[0]);
    const double second = lengthOf(lesion.secondMm[1] - lesion.secondMm[0]);
    if (!std::isfinite(first + second)) return {kNaN, kNaN};
    return {std::max(first, second), std::min(first, second)};
}

double areaMm2(const Ellipse& ellipse) {
    const double area = std::numbers::pi * ellipse.radiiMm.x * ellipse.radiiMm.y;
    return std::isfinite(area) ? area : kNaN;
}

double areaMm2(const Outline& outline) {
    const auto flat = flatOutline(outline);
    return flat && !crossesItself(flat->points) ? std::abs(signedArea(flat->points)) : kNaN;
}

std::optional<AreaValues> valuesIn(const Ellipse& ellipse, const Volume& volume) {
    Sums sums;
    forEachCutVoxel(ellipse, volume, [&](const glm::ivec3& voxel) { sums.add(volume, voxel); });
    return sums.result(areaMm2(ellipse));
}

std::optional<AreaValues> valuesIn(const Outline& outline, const glm::dvec3& normal, const Volume& volume) {
    const double area = areaMm2(outline);
    if (!(area > 0.0)) return std::nullopt;
    Sums sums;
    forEachCutVoxel(outline, normal, volume, [&](const glm::ivec3& voxel) { sums.add(volume, voxel); });
    return sums.result(area);
}

std::optional<AreaValues> valuesIn(const Measurement& measurement, const Volume& volume) {
    if (const auto* ellipse = std::get_if<Ellipse>(&measurement.shape)) return valuesIn(*ellipse, volume);
    if (const auto* outline = std::get_if<Outline>(&measurement.shape))
        return valuesIn(*outline, measurement.normal, volume);
    return std::nullopt;
}

bool liesIn(const Measurement& measurement, const SlicePlane& plane, double toleranceMm) {
    const auto* ellipse = std::get_if<Ellipse>(&measurement.shape);
    const glm::dvec3 drawnOn = ellipse ? ellipse->plane.normal() : measurement.normal;
    const glm::dvec3 normal = plane.normal() / lengthOf(plane.normal());
    const double cosine = glm::dot(drawnOn / lengthOf(drawnOn), normal);
    // NaN compares as false: an invalid measurement lies in no plane.
    if (!(std::abs(cosine) >= std::cos(glm::radians(kParallelDeg)))) return false;
    const auto distanceMm = [&](const glm::dvec3& mm) {
        return std::abs(glm::dot(mm - plane.centreMm, normal));
    };
    if (ellipse) {
        const double rimMm = std::hypot(ellipse->radiiMm.x * glm::dot(ellipse->plane.right, normal),
                                        ellipse->radiiMm.y * glm::dot(ellipse->plane.down, normal));
        return distanceMm(ellipse->plane.centreMm) + rimMm <= toleranceMm;
    }
    return std::ranges::all_of(pointsOf(measurement),
                               [&](const glm::dvec3& mm) { return distanceMm(mm) <= toleranceMm; });
}

std::optional<int> sliceOf(const Measurement& measurement, const Volume& volume) {
    const glm::dmat4 voxelFromWorld = glm::inverse(volume.worldFromVoxel());
    std::vector<glm::dvec3> points = pointsOf(measurement);
    if (std::holds_alternative<Ellipse>(measurement.shape)) {  // also the opposite ends
        points.push_back(2.0 * points[0] - points[1]);
        points.push_back(2.0 * points[0] - points[2]);
    }
    std::optional<int> slice;
    for (const glm::dvec3& mm : points) {
        constexpr double kRounding = 1e-6;
        const double at = std::round(transformPoint(voxelFromWorld, mm).z - kRounding);
        if (!(at >= 0.0 && at < volume.size().z) || (slice && *slice != int(at))) return std::nullopt;
        slice = int(at);
    }
    return slice;
}

bool hasSize(const Measurement& measurement) {
    return !std::holds_alternative<Angle>(measurement.shape) &&
           !std::holds_alternative<CobbAngle>(measurement.shape) &&
           !std::holds_alternative<Arrow>(measurement.shape);
}

bool hasArea(const Measurement& measurement) {
    return std::holds_alternative<Ellipse>(measurement.shape) ||
           std::holds_alternative<Outline>(measurement.shape);
}

}  // namespace macula::slices
