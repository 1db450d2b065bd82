// Converts sRGB-encoded colours of transfer functions (0 to 1) to and from QColor.
#pragma once

#include <QColor>
#include <algorithm>
#include <glm/glm.hpp>

namespace macula::viewer {

inline QColor colourOf(const glm::dvec3& encoded) {
    const auto channel = [](double x) { return float(std::clamp(x, 0.0, 1.0)); };
    return QColor::fromRgbF(channel(encoded.r), channel(encoded.g), channel(encoded.b));
}

inline glm::dvec3 encodedFrom(const QColor& colour) {
    return {colour.redF(), colour.greenF(), colour.blueF()};
}

}  // namespace macula::viewer
