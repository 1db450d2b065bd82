#include "scene/transfer/edited_transfer.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>
#include <vector>

#include "base/check.h"
#include "presets/vtk_curve.h"

namespace macula::scene {

namespace {

constexpr double kLargest = presets::kLargestValue;
constexpr double kLargestFactor = 1e6;  // the largest factor of one stretch

double inRange(double value) {
    return std::clamp(value, -kLargest, kLargest);
}

template <class Point>
void moveTo(std::vector<Point>& points, std::size_t index, double value) {
    MACULA_CHECK(index < points.size());
    if (!std::isfinite(value)) return;
    const double low = index > 0 ? points[index - 1].value : std::min(-kLargest, points[index].value);
    const double high =
        index + 1 < points.size() ? points[index + 1].value : std::max(kLargest, points[index].value);
    points[index].value = std::clamp(value, low, high);
}

template <class Point>
std::optional<std::size_t> insert(std::vector<Point>& points, Point point) {
    if (points.size() >= presets::kMostPoints || !std::isfinite(point.value)) return std::nullopt;
    point.value = inRange(point.value);
    const auto after = std::upper_bound(points.begin(), points.end(), point.value,
                                        [](double value, const Point& other) { return value < other.value; });
    if (after != points.begin()) {
        const Point straight;
        Point& before = *std::prev(after);
        before.midpoint = straight.midpoint;
        before.sharpness = straight.sharpness;
    }
    const auto index = std::size_t(after - points.begin());
    points.insert(after, std::move(point));
    return index;
}

template <class Point>
void erase(std::vector<Point>& points, std::size_t index) {
    MACULA_CHECK(index < points.size());
    if (points.size() > 1) points.erase(points.begin() + std::ptrdiff_t(index));
}

void paint(glm::dvec3& target, const glm::dvec3& colour) {
    for (int i = 0; i < 3; ++i) {
        if (std::isfinite(colour[i])) target[i] = std::clamp(colour[i], 0.0, 1.0);
    }
}

// Whether edits move the effective range too. A range that the preset is fitted by stays: otherwise the fit
// would undo each shift.
bool hasRangeOfItsOwn(const TransferFunction& function) {
    return function.effectiveRange && !function.fitToVolume;
}

// The range from the first point of any curve to the last point of any.
ValueRange spanOf(const TransferFunction& function) {
    MACULA_CHECK(!function.opacity.empty() && !function.colour.empty());
    ValueRange span{function.opacity.front().value, function.opacity.back().value};
    const auto hold = [&span](const auto& points) {
        if (points.empty()) return;
        span.low = std::min(span.low, points.front().value);
        span.high = std::max(span.high, points.back().value);
    };
    hold(function.colour);
    hold(function.steep.opacity);
    hold(function.steep.colour);
    return span;
}

// `map` keeps the order of values.
template <class Map>
void mapValues(TransferFunction& function, const Map& map) {
    for (OpacityPoint& point : function.opacity) point.value = inRange(map(point.value));
    for (ColourPoint& point : function.colour) point.value = inRange(map(point.value));
    for (OpacityPoint& point : function.steep.opacity) point.value = inRange(map(point.value));
    for (ColourPoint& point : function.steep.colour) point.value = inRange(map(point.value));
    if (!hasRangeOfItsOwn(function)) return;
    ValueRange& range = *function.effectiveRange;
    range = {inRange(map(range.low)), inRange(map(range.high))};
    // Rounding may make both ends equal; an empty range counts as none.
    if (!(range.low < range.high)) function.effectiveRange.reset();
}

// The spans that must neither vanish nor leave the range of values when stretched.
std::vector<ValueRange> spansOf(const TransferFunction& function) {
    std::vector<ValueRange> spans{spanOf(function)};
    if (hasRangeOfItsOwn(function)) spans.push_back(*function.effectiveRange);
    return spans;
}

double heldFactor(const TransferFunction& function, double factor, double about) {
    double least = 1.0 / kLargestFactor;
    double most = kLargestFactor;
    for (const ValueRange& span : spansOf(function)) {
        if (span.low < span.high)
            least = std::max(least, std::min(1.0, kNarrowestCurve / (span.high - span.low)));
        if (span.high > about) most = std::min(most, (kLargest - about) / (span.high - about));
        if (span.low < about) most = std::min(most, (kLargest + about) / (about - span.low));
    }
    return std::clamp(factor, least, std::max(1.0, most));
}

}  // namespace

TransferFunction movedOpacityPoint(TransferFunction function, std::size_t index, double value,
                                   double opacity) {
    moveTo(function.opacity, index, value);
    if (std::isfinite(opacity)) function.opacity[index].opacity = std::clamp(opacity, 0.0, 1.0);
    return function;
}

TransferFunction movedColourPoint(TransferFunction function, std::size_t index, double value) {
    moveTo(function.colour, index, value);
    return function;
}

TransferFunction recoloured(TransferFunction function, std::size_t index, const glm::dvec3& colour) {
    MACULA_CHECK(index < function.colour.size());
    paint(function.colour[index].colour, colour);
    return function;
}

Added withOpacityPoint(TransferFunction function, double value, double opacity) {
    Added added{.function = std::move(function)};
    if (!std::isfinite(opacity)) return added;
    added.index = insert(added.function.opacity,
                         OpacityPoint{.value = value, .opacity = std::clamp(opacity, 0.0, 1.0)});
    return added;
}

Added withColourPoint(TransferFunction function, double value, const glm::dvec3& colour) {
    Added added{.function = std::move(function)};
    if (!std::isfinite(colour.r) || !std::isfinite(colour.g) || !std::isfinite(colour.b)) return added;
    ColourPoint point{.value = value};
    paint(point.colour, colour);
    added.index = insert(added.function.colour, point);
    return added;
}

TransferFunction withoutOpacityPoint(TransferFunction function, std::size_t index) {
    erase(function.opacity, index);
    return function;
}

TransferFunction withoutColourPoint(TransferFunction function, std::size_t index) {
    erase(function.colour, index);
    return function;
}

TransferFunction withSteepCurves(TransferFunction function) {
    if (usesSteepCurves(function)) return function;
    function.steep.opacity = function.opacity;
    function.steep.colour = function.colour;
    return function;
}

TransferFunction withoutSteepCurves(TransferFunction function) {
    function.steep.opacity.clear();
    function.steep.colour.clear();
    return function;
}

TransferFunction shifted(TransferFunction function, double by) {
    if (!std::isfinite(by)) return function;
    double least = -2.0 * kLargest;
    double most = 2.0 * kLargest;
    for (const ValueRange& span : spansOf(function)) {
        least = std::max(least, -kLargest - span.low);
        most = std::min(most, kLargest - span.high);
    }
    by = std::clamp(by, std::min(0.0, least), std::max(0.0, most));
    if (by != 0.0) mapValues(function, [by](double value) { return value + by; });
    return function;
}

TransferFunction widened(TransferFunction function, double factor, double about) {
    if (!std::isfinite(factor) || !std::isfinite(about) || !(factor > 0.0)) return function;
    about = inRange(about);
    factor = heldFactor(function, factor, about);
    if (factor == 1.0) return function;
    mapValues(function, [=](double value) { return about + factor * (value - about); });
    for (OpacityPoint& point : function.gradientOpacity) point.value = inRange(factor * point.value);
    for (double* gradient : {&function.surface.gradientPerMm, &function.steep.gradientPerMm})
        *gradient = std::clamp(factor * *gradient, kLeastGradientPerMm, kMostGradientPerMm);
    return function;
}

TransferFunction withOpacityScaled(TransferFunction function, double factor) {
    if (!std::isfinite(factor) || !(factor >= 0.0)) return function;
    for (OpacityPoint& point : function.opacity) point.opacity = std::min(1.0, factor * point.opacity);
    for (OpacityPoint& point : function.steep.opacity) point.opacity = std::min(1.0, factor * point.opacity);
    return function;
}

}  // namespace macula::scene
