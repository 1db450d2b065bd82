#include "pipeline/volume/transfer_function.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace macula {

namespace {

constexpr double kMaxOpacity = 0.999;

// The piece of a curve that holds `value`: the last point at or below it, the next one, and how far between
// they are.
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

}  // namespace

double opacityAt(const TransferFunction& function, double value) {
    const Piece piece = pieceAt(function.opacity, value);
    return std::lerp(function.opacity[piece.from].opacity, function.opacity[piece.to].opacity,
                     piece.fraction);
}

glm::dvec3 colourAt(const TransferFunction& function, double value) {
    const Piece piece = pieceAt(function.colour, value);
    return glm::mix(function.colour[piece.from].colour, function.colour[piece.to].colour, piece.fraction);
}

double extinctionPerMm(const TransferFunction& function, double value) {
    const double opacity = std::clamp(opacityAt(function, value), 0.0, kMaxOpacity);
    return -std::log1p(-opacity) / function.unitDistanceMm * function.density;
}

Result<void> validate(const TransferFunction& function) {
    const auto fail = [&](std::string message) {
        return Error{ErrorCode::inputNotUsable, std::move(message), function.name, "Correct the preset."};
    };
    if (!isSortedAndFinite(function.opacity))
        return fail("The preset's opacity points are missing, not finite, or not sorted by value.");
    if (!isSortedAndFinite(function.colour))
        return fail("The preset's colour points are missing, not finite, or not sorted by value.");
    for (const OpacityPoint& point : function.opacity) {
        if (!isFraction(point.opacity)) return fail("An opacity of the preset lies outside 0 to 1.");
    }
    for (const ColourPoint& point : function.colour) {
        if (!isFraction(point.colour.r) || !isFraction(point.colour.g) || !isFraction(point.colour.b)) {
            return fail("A colour of the preset lies outside 0 to 1.");
        }
    }
    if (!(function.unitDistanceMm > 0.0 && std::isfinite(function.unitDistanceMm)))
        return fail("The preset's unit distance must be above 0 mm.");
    if (!(function.density >= 0.0 && std::isfinite(function.density)))
        return fail("The preset's density must be 0 or above.");
    if (!isFraction(function.albedo)) return fail("The preset's albedo must lie in 0 to 1.");
    if (!(std::abs(function.anisotropy) < 1.0))
        return fail("The preset's scattering anisotropy must lie between -1 and 1.");
    if (function.fitToVolume && !(function.fitToVolume->low < function.fitToVolume->high)) {
        return fail("The preset's range to fit to the volume is empty.");
    }
    return {};
}

bool suits(const TransferFunction& function, Unit unit) {
    return function.unit == unit ||
           (function.unit == Unit::raw && function.fitToVolume && unit != Unit::hounsfield);
}

TransferFunction fitted(const TransferFunction& function, const Volume& volume) {
    if (!function.fitToVolume) return function;
    constexpr double kLowPercentile = 0.02;
    constexpr double kHighPercentile = 0.98;

    // Foreground: above the mean of all voxels that are not padding. Air makes the lowest and largest peak of
    // every MR histogram, and the mean lies above it.
    std::vector<std::uint64_t> histogram(65536, 0);
    for (const std::uint16_t stored : volume.voxels()) ++histogram[stored];
    if (volume.padding()) {
        for (int v = volume.padding()->low; v <= volume.padding()->high; ++v) histogram[std::size_t(v)] = 0;
    }
    double count = 0.0;
    double sum = 0.0;
    for (std::size_t v = 0; v < histogram.size(); ++v) {
        count += double(histogram[v]);
        sum += double(histogram[v]) * double(v);
    }
    const auto threshold = static_cast<std::size_t>(count > 0.0 ? sum / count : 0.0);
    double foreground = 0.0;
    for (std::size_t v = threshold; v < histogram.size(); ++v) foreground += double(histogram[v]);
    const auto percentile = [&](double fraction) {
        double below = 0.0;
        std::size_t v = threshold;
        while (v + 1 < histogram.size() && (below += double(histogram[v])) < fraction * foreground) ++v;
        return volume.unitsFromStored()(double(v));
    };
    const double low = percentile(kLowPercentile);
    const double high = std::max(percentile(kHighPercentile), low + volume.unitsFromStored().slope);

    TransferFunction result = function;
    const auto stretch = [&](double value) {
        return low + (value - function.fitToVolume->low) /
                         (function.fitToVolume->high - function.fitToVolume->low) * (high - low);
    };
    for (OpacityPoint& point : result.opacity) point.value = stretch(point.value);
    for (ColourPoint& point : result.colour) point.value = stretch(point.value);
    result.fitToVolume.reset();
    return result;
}

}  // namespace macula
