// From values to optics: which values are seen, how dense they are, and in which colour.
#pragma once

#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <vector>

#include "base/volume.h"
#include "pipeline/volume/colour_space.h"

namespace macula {

// `midpoint` and `sharpness` shape the way from this point to the next, as vtkPiecewiseFunction defines them
// (curve_blend.h); 0.5 and 0 are a straight line.
struct OpacityPoint {
    double value = 0.0;      // in units of the volume; of a gradient opacity, see there
    double opacity = 0.0;    // 0 to 1, of a layer `unitDistanceMm` thick
    double midpoint = 0.5;   // 0 to 1: how far to the next point the half value lies
    double sharpness = 0.0;  // 0 to 1: 0 is a line, 1 a step at the midpoint

    bool operator==(const OpacityPoint&) const = default;
};

struct ColourPoint {
    double value = 0.0;
    glm::dvec3 colour{1.0};  // sRGB-encoded, 0 to 1, as picked on a screen
    double midpoint = 0.5;
    double sharpness = 0.0;

    bool operator==(const ColourPoint&) const = default;
};

// Phong's coefficients, as the tools that presets come from use them.
struct Lighting {
    bool shade = true;
    double ambient = 0.1;
    double diffuse = 0.9;
    double specular = 0.2;
    double specularPower = 10.0;

    bool operator==(const Lighting&) const = default;
};

// How matter scatters light where values change steeply: like a rough, wet surface
// (shaders/lib/material.glsl).
struct Surface {
    double weight = 0.0;           // 0 to 1: the part of what is scattered that the steepest boundary takes
    double gradientPerMm = 100.0;  // above 0, in units of the volume: half of that part
    double roughness = 0.4;        // kLeastRoughness to 1
    double reflectance = 0.04;     // 0 to 1, of light that falls straight; wet tissue 0.03 to 0.05

    bool operator==(const Surface&) const = default;
};
inline constexpr double kLeastRoughness = 0.1;  // highlights below are smaller than any light

// Other curves for matter whose values change steeply, where values alone cannot tell: bone and blood with
// contrast agent have the same, but bone ends within a millimetre (Kniss, Kindlmann and Hansen 2002,
// "Multidimensional transfer functions for interactive volume rendering"; here the second dimension has two
// ends, and a curve of its own between them). At a voxel the part g^2 / (g^2 + gradientPerMm^2) of the matter
// is steep, g the length of the gradient from central differences; between voxels that part is trilinear.
// The extinction there is that mixture of the extinctions by both curves, and each part has its own colour.
struct SteepMatter {
    std::vector<OpacityPoint> opacity = {};  // as TransferFunction's; empty: all has one pair of curves
    std::vector<ColourPoint> colour = {};    // empty when `opacity` is, and only then
    double gradientPerMm = 200.0;            // above 0, in units of the volume: half of the matter is steep

    bool operator==(const SteepMatter&) const = default;
};

enum class Interpolation { nearest, linear, cubic };

// Of the absolute value of Henyey-Greenstein's g: nearer to 1, light goes so straight on that single floats
// do not tell its directions apart.
inline constexpr double kMostScatteringAnisotropy = 0.99;

// Curves over values, constant beyond their first and last point. Colours are interpolated as encoded, in
// `colourSpace`, as the tools do that presets come from, and made linear afterwards. Two points at the same
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
    double anisotropy = 0.0;  // Henyey-Greenstein g, at most kMostScatteringAnisotropy
    Surface surface = {};
    SteepMatter steep = {};
    // When set, the curves are stretched so that this interval of their values falls on an interval of the
    // volume's (volume_fit.h): MR values mean nothing across scanners.
    struct Fit {
        enum class To {
            foreground,  // the 2nd and 98th percentile of what is not background
            valueRange,  // the smallest and largest value
        };
        double low = 0.0;
        double high = 1.0;
        To to = To::foreground;

        bool operator==(const Fit&) const = default;
    };
    std::optional<Fit> fitToVolume = {};
    ColourSpace colourSpace = ColourSpace::rgb;
    // The gradient opacity, over the length of the gradient in units per voxel of mean edge, that is per mm
    // times the mean of the three spacings, as VTK has it; sorted. Multiplies the opacity. Empty: 1
    // everywhere.
    std::vector<OpacityPoint> gradientOpacity = {};
    std::optional<ValueRange> effectiveRange = {};  // the values that matter: where sliders end
    // The tracer does not use these two; other programs that read what toJson writes do.
    Lighting lighting = {};
    Interpolation interpolation = Interpolation::linear;
    std::optional<int> number = {};  // place in a list: 1 to 31 are 3D Slicer's, Macula's own begin at 101
    std::string source = {};         // the program that the numbers come from: "3D Slicer"
    // The JSON file that this was read from; toJson writes into it, so that keys which mean nothing to Macula
    // survive. Empty when there is none.
    std::string document = {};

    bool operator==(const TransferFunction&) const = default;
};

// 0 to 1, at a value. Exact: curved pieces are evaluated, not approximated.
double opacityAt(const TransferFunction& function, double value);
// sRGB-encoded, 0 to 1, at a value.
glm::dvec3 colourAt(const TransferFunction& function, double value);
// 0 to 1, at the length of the gradient, which is 0 or above.
double gradientOpacityAt(const TransferFunction& function, double unitsPerVoxel);

// Whether the gradient opacity is other than 1 anywhere at 0 or above, where gradients are.
bool usesGradientOpacity(const TransferFunction& function);

// Whether steep matter has curves of its own.
bool usesSteepCurves(const TransferFunction& function);
// The part of matter that is steep where the gradient has this length, in units of the volume per mm; 0 to 1.
double steepPartAt(const TransferFunction& function, double gradientPerMm);
// The same with the curves of steep matter in the place of the others, and the others in theirs: what reads
// or edits one pair of curves does so with the other.
TransferFunction withCurvesSwapped(TransferFunction function);

// sigma = -ln(1 - min(opacity, 0.999)) / unitDistanceMm * density, per millimetre. Opacity 1
// would be infinite; with the clamp, density 1 and 1 mm the densest matter has a mean free path of 0.14 mm.
double extinctionPerMm(const TransferFunction& function, double value);

// Fails with inputNotUsable when a curve is empty, not sorted, not finite, or out of its range.
Result<void> validate(const TransferFunction& function);

// The curves mean something on values of this unit: they are over the same unit, or are fitted to whatever
// numbers there are.
bool suits(const TransferFunction& function, Unit unit);

}  // namespace macula
