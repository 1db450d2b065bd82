#include "pipeline/volume/curve_blend.h"

#include <algorithm>
#include <cmath>

namespace macula {

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
