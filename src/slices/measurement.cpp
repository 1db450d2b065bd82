#include "slices/measurement.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "slices/cut_voxels.h"
#include "slices/interpolated.h"

namespace macula::slices {

namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kParallelDeg = 1.0;

template <class... Cases>
struct Overloaded : Cases... {
    using Cases::operator()...;
};
template <class... Cases>
Overloaded(Cases...) -> Overloaded<Cases...>;

// Without overflow; NaN if a number is not finite.
double lengthOf(const glm::dvec3& vector) {
    const double length = std::hypot(vector.x, vector.y, vector.z);
    return std::isfinite(length) ? length : kNaN;
}

// Welford's sums: the mean of large values with a small deviation keeps its digits.
class Sums {
  public:
    void add(double value, bool isInterpolated) {
        ++values_.voxels;
        if (isInterpolated) ++values_.interpolated;
        const double before = value - values_.mean;
        values_.mean += before / double(values_.voxels);
        squares_ += before * (value - values_.mean);
        values_.low = values_.voxels == 1 ? value : std::min(values_.low, value);
        values_.high = values_.voxels == 1 ? value : std::max(values_.high, value);
    }
    EllipseValues result() const {
        EllipseValues values = values_;
        values.deviation = values.voxels > 1 ? std::sqrt(squares_ / double(values.voxels - 1)) : kNaN;
        return values;
    }

  private:
    EllipseValues values_;
    double squares_ = 0.0;
};

// Decimals so that the largest of the numbers has three significant digits.
int decimalsFor(double largest) {
    if (!(std::abs(largest) > 0.0) || !std::isfinite(largest)) return 0;
    return int(std::clamp(2.0 - std::floor(std::log10(std::abs(largest))), 0.0, 9.0));
}

constexpr const char* kNotDefined = "–";

// "12.3", or "12.3 mm" with the unit " mm".
std::string numberText(double value, int decimals, std::string_view unit = {}) {
    constexpr double kLongest = 1e7;
    if (!std::isfinite(value)) return kNotDefined;
    std::string text =
        std::abs(value) >= kLongest ? fmt::format("{:.4g}", value) : fmt::format("{:.{}f}", value, decimals);
    const bool isMinusZero = text.front() == '-' && text.find_first_of("123456789") == std::string::npos;
    if (isMinusZero) text.erase(0, 1);
    return text.append(unit);
}

// The text of a length or an area, marked as an estimate unless it is not defined.
std::string sizeText(double size, int decimals, std::string_view unit, const Volume& volume) {
    std::string text = numberText(size, decimals, unit);
    const bool isEstimate = !volume.provenance().isCalibrated && std::isfinite(size);
    return isEstimate ? "≈ " + text : text;
}

std::string textOfEllipse(const Ellipse& ellipse, const Volume& volume) {
    const double area = areaMm2(ellipse);
    const std::string areaText = sizeText(area, decimalsFor(area), " mm²", volume);
    const auto values = valuesIn(ellipse, volume);
    if (!values) return fmt::format("{}, {}", kNotDefined, areaText);
    const int decimals = volume.unit() == Unit::hounsfield
                             ? 0
                             : decimalsFor(std::max(std::abs(values->low), std::abs(values->high)));
    std::string text = numberText(values->mean, decimals);
    if (values->voxels > 1) text += " ± " + numberText(values->deviation, decimals);
    if (const std::string unit = volume.unitName(); !unit.empty()) text += " " + unit;
    // "min" and "max" are the same in all languages of the window.
    return fmt::format("{}, min {}, max {}, {}", text, numberText(values->low, decimals),
                       numberText(values->high, decimals), areaText);
}

}  // namespace

std::string_view kindOf(const Measurement& measurement) {
    return std::visit(
        Overloaded{[](const Distance&) { return "distance"; }, [](const Angle&) { return "angle"; },
                   [](const Ellipse&) { return "ellipse"; }},
        measurement.shape);
}

std::vector<glm::dvec3> pointsOf(const Measurement& measurement) {
    using Points = std::vector<glm::dvec3>;
    return std::visit(Overloaded{[](const Distance& d) { return Points(d.endsMm.begin(), d.endsMm.end()); },
                                 [](const Angle& a) { return Points(a.pointsMm.begin(), a.pointsMm.end()); },
                                 [](const Ellipse& e) {
                                     const glm::dvec3& centre = e.plane.centreMm;
                                     return Points{centre, centre + e.radiiMm.x * e.plane.right,
                                                   centre + e.radiiMm.y * e.plane.down};
                                 }},
                      measurement.shape);
}

double lengthMm(const Distance& distance) {
    return lengthOf(distance.endsMm[1] - distance.endsMm[0]);
}

double angleDeg(const Angle& angle) {
    const glm::dvec3 toFirst = angle.pointsMm[0] - angle.pointsMm[1];
    const glm::dvec3 toLast = angle.pointsMm[2] - angle.pointsMm[1];
    const glm::dvec3 a = toFirst / lengthOf(toFirst);  // NaN when it has no length
    const glm::dvec3 b = toLast / lengthOf(toLast);
    // With atan2: an arc cosine would lose half of its digits near 0 and 180 degrees.
    return glm::degrees(std::atan2(lengthOf(glm::cross(a, b)), glm::dot(a, b)));
}

double areaMm2(const Ellipse& ellipse) {
    const double area = std::numbers::pi * ellipse.radiiMm.x * ellipse.radiiMm.y;
    return std::isfinite(area) ? area : kNaN;
}

std::optional<EllipseValues> valuesIn(const Ellipse& ellipse, const Volume& volume) {
    Sums sums;
    forEachCutVoxel(ellipse, volume, [&](const glm::ivec3& voxel) {
        if (volume.isPadding(voxel.x, voxel.y, voxel.z)) return;
        const double value = volume.value(voxel.x, voxel.y, voxel.z);
        if (std::isfinite(value)) sums.add(value, isInterpolated(volume, voxel.z));
    });
    EllipseValues values = sums.result();
    if (values.voxels == 0) return std::nullopt;
    values.areaMm2 = areaMm2(ellipse);
    return values;
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
    return !std::holds_alternative<Angle>(measurement.shape);
}

std::string textOf(const Measurement& measurement, const Volume& volume) {
    return std::visit(Overloaded{[&](const Distance& d) { return sizeText(lengthMm(d), 1, " mm", volume); },
                                 [](const Angle& a) { return numberText(angleDeg(a), 1, "°"); },
                                 [&](const Ellipse& e) { return textOfEllipse(e, volume); }},
                      measurement.shape);
}

}  // namespace macula::slices
