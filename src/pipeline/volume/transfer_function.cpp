#include "pipeline/volume/transfer_function.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "pipeline/volume/voxel_gradient.h"

namespace macula {

namespace {

constexpr double kMaxOpacity = 0.999;

// The piece of a curve that contains `value`: the last point at or below it, the next one, and the position
// between them.
struct Piece {
    std::size_t from = 0;
    std::size_t to = 0;
    double fraction = 0.0;
};

template <class Point>
Piece pieceAt(const std::vector<Point>& points, double value) {
    const auto above = std::upper_bound(points.begin(), points.end(), value,
                                        [](double v, const Point& point) { return v < point.value; });
    if (above == points.begin()) return {};
    const auto to = static_cast<std::size_t>(above - points.begin());
    const std::size_t from = to - 1;
    if (above == points.end()) return {from, from, 0.0};
    return {from, to, (value - points[from].value) / (points[to].value - points[from].value)};
}

double heightAt(const std::vector<OpacityPoint>& points, double value) {
    const Piece piece = pieceAt(points, value);
    const OpacityPoint& from = points[piece.from];
    return std::lerp(from.opacity, points[piece.to].opacity,
                     blendedFraction(piece.fraction, from.midpoint, from.sharpness));
}

template <class Point>
bool isSortedAndFinite(const std::vector<Point>& points) {
    return !points.empty() &&
           std::all_of(points.begin(), points.end(), [](const Point& p) { return std::isfinite(p.value); }) &&
           std::is_sorted(points.begin(), points.end(),
                          [](const Point& a, const Point& b) { return a.value < b.value; });
}

bool isFraction(double x) {
    return x >= 0.0 && x <= 1.0;
}

bool isInRange(const OpacityPoint& point) {
    return isFraction(point.opacity) && isFraction(point.midpoint) && isFraction(point.sharpness);
}

bool isInRange(const ColourPoint& point) {
    return isFraction(point.colour.r) && isFraction(point.colour.g) && isFraction(point.colour.b) &&
           isFraction(point.midpoint) && isFraction(point.sharpness);
}

template <class Point>
bool areInRange(const std::vector<Point>& points) {
    return std::all_of(points.begin(), points.end(), [](const Point& point) { return isInRange(point); });
}

bool isPositive(double x) {
    return x > 0.0 && std::isfinite(x);
}

// Empty if the curves of steep matter and its gradient are usable.
Text faultOf(const SteepMatter& steep) {
    if (!isPositive(steep.gradientPerMm))
        return Text("The preset's gradient of steep matter must be above 0.");
    if (steep.opacity.empty() && steep.colour.empty()) return {};
    if (!isSortedAndFinite(steep.opacity) || !isSortedAndFinite(steep.colour))
        return Text(
            "The preset's curves of steep matter need points of opacity and of colour, finite and sorted "
            "by value.");
    if (!areInRange(steep.opacity) || !areInRange(steep.colour))
        return Text(
            "An opacity of the preset's steep matter, a colour, a midpoint or a sharpness lies outside 0 "
            "to 1.");
    return {};
}

}  // namespace

double opacityAt(const TransferFunction& function, double value) {
    return heightAt(function.opacity, value);
}

double gradientOpacityAt(const TransferFunction& function, double unitsPerVoxel) {
    return function.gradientOpacity.empty() ? 1.0 : heightAt(function.gradientOpacity, unitsPerVoxel);
}

bool usesGradientOpacity(const TransferFunction& function) {
    // A curve never leaves the heights of its points, so it is 1 everywhere if it is 1 at 0 and at each later
    // point.
    return gradientOpacityAt(function, 0.0) != 1.0 ||
           std::any_of(function.gradientOpacity.begin(), function.gradientOpacity.end(),
                       [](const OpacityPoint& point) { return point.value >= 0.0 && point.opacity != 1.0; });
}

glm::dvec3 colourAt(const TransferFunction& function, double value) {
    const std::vector<ColourPoint>& points = function.colour;
    if (function.colourSpace == ColourSpace::step) {
        const auto end = std::lower_bound(points.begin(), points.end(), value,
                                          [](const ColourPoint& point, double v) { return point.value < v; });
        return end == points.end() ? points.back().colour : end->colour;
    }
    const Piece piece = pieceAt(points, value);
    const ColourPoint& from = points[piece.from];
    // In Moreland's colour space VTK applies only the warp, without the Hermite curve.
    const double fraction = function.colourSpace == ColourSpace::diverging
                                ? warpedFraction(piece.fraction, from.midpoint, from.sharpness)
                                : blendedFraction(piece.fraction, from.midpoint, from.sharpness);
    if (fraction <= 0.0 || piece.from == piece.to) return from.colour;
    return mixColours(function.colourSpace, from.colour, points[piece.to].colour, fraction);
}

bool usesSteepCurves(const TransferFunction& function) {
    return !function.steep.opacity.empty();
}

double steepPartAt(const TransferFunction& function, double gradientPerMm) {
    return steepPart(gradientPerMm, function.steep.gradientPerMm);
}

TransferFunction withCurvesSwapped(TransferFunction function) {
    std::swap(function.opacity, function.steep.opacity);
    std::swap(function.colour, function.steep.colour);
    return function;
}

double extinctionPerMm(const TransferFunction& function, double value) {
    const double opacity = std::clamp(opacityAt(function, value), 0.0, kMaxOpacity);
    return -std::log1p(-opacity) / function.unitDistanceMm * function.density;
}

Result<void> validate(const TransferFunction& function) {
    const auto fail = [&](Text message) {
        return Error{ErrorCode::inputNotUsable, std::move(message), function.name,
                     Text("Correct the preset.")};
    };
    if (!isSortedAndFinite(function.opacity))
        return fail(Text("The preset's opacity points are missing, not finite, or not sorted by value."));
    if (!isSortedAndFinite(function.colour))
        return fail(Text("The preset's colour points are missing, not finite, or not sorted by value."));
    if (!function.gradientOpacity.empty() && !isSortedAndFinite(function.gradientOpacity))
        return fail(Text("The preset's gradient opacity points are not finite or not sorted by value."));
    if (!areInRange(function.opacity) || !areInRange(function.gradientOpacity))
        return fail(Text("An opacity of the preset, a midpoint or a sharpness lies outside 0 to 1."));
    if (!areInRange(function.colour))
        return fail(Text("A colour of the preset, a midpoint or a sharpness lies outside 0 to 1."));
    if (Text fault = faultOf(function.steep); !fault.empty()) return fail(std::move(fault));
    if (!isPositive(function.unitDistanceMm))
        return fail(Text("The preset's unit distance must be above 0 mm."));
    if (!(function.density >= 0.0 && std::isfinite(function.density)))
        return fail(Text("The preset's density must be 0 or above."));
    if (!isFraction(function.albedo)) return fail(Text("The preset's albedo must lie in 0 to 1."));
    if (!(std::abs(function.anisotropy) <= kMostScatteringAnisotropy))
        return fail(Text("The preset's scattering anisotropy must lie between -0.99 and 0.99."));
    const Surface& surface = function.surface;
    if (!isFraction(surface.weight) || !isFraction(surface.reflectance) || !isFraction(surface.roughness) ||
        surface.roughness < kLeastRoughness)
        return fail(Text(
            "The preset's surface weight or reflectance lies outside 0 to 1, or its roughness outside 0.1 to "
            "1."));
    if (!isPositive(surface.gradientPerMm))
        return fail(Text("The preset's surface gradient must be above 0."));
    if (function.fitToVolume && !(function.fitToVolume->low < function.fitToVolume->high)) {
        return fail(Text("The preset's range to fit to the volume is empty."));
    }
    return {};
}

bool suits(const TransferFunction& function, Unit unit) {
    if (function.unit == unit) return true;
    if (!function.fitToVolume) return false;
    return function.fitToVolume->to == TransferFunction::Fit::To::valueRange ||
           (function.unit == Unit::raw && unit != Unit::hounsfield);
}

namespace {
constexpr double kLine = 0.01;  // sharpness below it is a line,
constexpr double kStep = 0.99;  // and above it a step
}  // namespace

double warpedFraction(double u, double midpoint, double sharpness) {
    midpoint = std::clamp(midpoint, 0.00001, 0.99999);
    u = u < midpoint ? 0.5 * u / midpoint : 0.5 + 0.5 * (u - midpoint) / (1.0 - midpoint);
    if (sharpness > kStep) return u < 0.5 ? 0.0 : 1.0;
    if (sharpness < kLine) return u;
    const double power = 1.0 + 10.0 * sharpness;
    return u < 0.5 ? 0.5 * std::pow(2.0 * u, power) : 1.0 - 0.5 * std::pow(2.0 * (1.0 - u), power);
}

double blendedFraction(double u, double midpoint, double sharpness) {
    const double s = warpedFraction(u, midpoint, sharpness);
    if (sharpness > kStep || sharpness < kLine) return s;
    // Between heights 0 and 1 the slope of both tangents is 1 - sharpness.
    const double tangents = (1.0 - sharpness) * (2.0 * s * s * s - 3.0 * s * s + s);
    return std::clamp(3.0 * s * s - 2.0 * s * s * s + tangents, 0.0, 1.0);
}

}  // namespace macula
