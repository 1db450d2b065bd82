#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "slices/measurement.h"
#include "slices/overloaded.h"

namespace macula::slices {

namespace {

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

std::string textOfArea(double area, const std::optional<AreaValues>& values, const Volume& volume) {
    const std::string areaText = sizeText(area, decimalsFor(area), " mm²", volume);
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

std::string textOfAxes(const Axes& axes, const Volume& volume) {
    if (!std::isfinite(axes.longMm)) return kNotDefined;
    return sizeText(axes.longMm, 1, " × ", volume) + numberText(axes.shortMm, 1, " mm");
}

}  // namespace

std::string textOf(const Measurement& measurement, const Volume& volume) {
    return std::visit(
        Overloaded{[&](const Distance& d) { return sizeText(lengthMm(d), 1, " mm", volume); },
                   [](const Angle& a) { return numberText(angleDeg(a), 1, "°"); },
                   [&](const Ellipse& e) { return textOfArea(areaMm2(e), valuesIn(e, volume), volume); },
                   [&](const Bidirectional& b) { return textOfAxes(axesOf(b), volume); },
                   [](const CobbAngle& c) { return numberText(angleDeg(c), 1, "°"); },
                   [](const Arrow&) { return std::string(); },
                   [&](const Outline& o) {
                       return textOfArea(areaMm2(o), valuesIn(o, measurement.normal, volume), volume);
                   },
                   [&](const OpenLine& l) { return sizeText(lengthMm(l), 1, " mm", volume); }},
        measurement.shape);
}

}  // namespace macula::slices
