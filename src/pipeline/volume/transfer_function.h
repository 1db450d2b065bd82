// From values to optics: which values are seen, how dense they are, and in which colour.
#pragma once

#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <vector>

#include "base/volume.h"

namespace macula {

struct OpacityPoint {
    double value = 0.0;    // in units of the volume
    double opacity = 0.0;  // 0 to 1, of a layer `unitDistanceMm` thick
};

struct ColourPoint {
    double value = 0.0;
    glm::dvec3 colour{1.0};  // sRGB-encoded, 0 to 1, as picked on a screen
};

// Piecewise-linear curves over values, constant beyond their first and last point. Colours are interpolated
// as encoded, as the tools do that presets come from, and made linear afterwards. Two points at the same
// value are a step: the later one holds from that value on.
struct TransferFunction {
    std::string name;   // key, as in `--preset ct-bone`
    std::string title;  // for people
    std::vector<std::string> modalities;
    Unit unit = Unit::hounsfield;
    std::vector<OpacityPoint> opacity;  // sorted by value
    std::vector<ColourPoint> colour;    // sorted by value
    double unitDistanceMm = 1.0;
    double density = 1.0;     // multiplies extinction
    double albedo = 1.0;      // multiplies the linear colour; 1 loses no light
    double anisotropy = 0.0;  // Henyey-Greenstein g, -1 < g < 1
    // When set, the curves are stretched so that this interval of their values falls on the 2nd and 98th
    // percentile of the volume's foreground: MR values mean nothing across scanners.
    struct Fit {
        double low = 0.0;
        double high = 1.0;
    };
    std::optional<Fit> fitToVolume;
};

// 0 to 1, at a value.
double opacityAt(const TransferFunction& function, double value);
// sRGB-encoded, 0 to 1, at a value.
glm::dvec3 colourAt(const TransferFunction& function, double value);

// sigma = -ln(1 - min(opacity, 0.999)) / unitDistanceMm * density, per millimetre. Opacity 1
// would be infinite; with the clamp, density 1 and 1 mm the densest matter has a mean free path of 0.14 mm.
double extinctionPerMm(const TransferFunction& function, double value);

// Fails with inputNotUsable when a curve is empty, not sorted, not finite, or out of its range.
Result<void> validate(const TransferFunction& function);

// The curves mean something on values of this unit: they are over the same unit, or are fitted to whatever
// numbers there are.
bool suits(const TransferFunction& function, Unit unit);

// The function with its curves stretched to the volume, or itself when it has no fit.
TransferFunction fitted(const TransferFunction& function, const Volume& volume);

}  // namespace macula
