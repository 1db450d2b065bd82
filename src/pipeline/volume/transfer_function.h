// From values to optics: which values are visible, how dense they are, and in which colour.
#pragma once

#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <vector>

#include "base/volume.h"
#include "pipeline/volume/colour_space.h"

namespace macula {

// `midpoint` and `sharpness` shape the curve from this point to the next, as vtkPiecewiseFunction defines
// them (blendedFraction); 0.5 and 0 give a straight line.
struct OpacityPoint {
    double value = 0.0;      // in units of the volume, or of TransferFunction::gradientOpacity
    double opacity = 0.0;    // 0 to 1, of a layer of thickness `unitDistanceMm`
    double midpoint = 0.5;   // 0 to 1: position of the half value on the way to the next point
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

// Phong's coefficients, as used by the programs that presets come from.
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
    double weight = 0.0;  // 0 to 1: the part of scattering that the steepest boundary does as a surface
    double gradientPerMm = 100.0;  // above 0, in units of the volume: gives half of that part
    double roughness = 0.4;        // kLeastRoughness to 1
    double reflectance = 0.04;     // 0 to 1, at normal incidence; wet tissue 0.03 to 0.05

    bool operator==(const Surface&) const = default;
};
inline constexpr double kLeastRoughness = 0.1;  // below, highlights are smaller than any light

// Other curves for matter whose values change steeply, where values alone are ambiguous: bone and blood with
// contrast agent share values, but bone ends within a millimetre (Kniss, Kindlmann and Hansen 2002,
// "Multidimensional transfer functions for interactive volume rendering"; here the second dimension has only
// two sets of curves, and a blend between them). At a voxel the part g^2 / (g^2 + gradientPerMm^2) of the
// matter is steep, with g the length of the gradient by central differences; between voxels this part is
// trilinear. Extinctions of both curves are mixed by it, and each part has its own colour.
struct SteepMatter {
    std::vector<OpacityPoint> opacity = {};  // as TransferFunction's; empty: one pair of curves for all
    std::vector<ColourPoint> colour = {};    // empty if and only if `opacity` is
    double gradientPerMm = 200.0;  // above 0, in units of the volume: here half of the matter is steep

    bool operator==(const SteepMatter&) const = default;
};

enum class Interpolation { nearest, linear, cubic };

// The limit of |g| of Henyey-Greenstein: nearer to 1, light is deflected by less than single precision can
// resolve.
inline constexpr double kMostScatteringAnisotropy = 0.99;

// Curves over values, constant beyond their first and last point. Encoded colours are interpolated in
// `colourSpace`, as the programs do that presets come from, and made linear afterwards. Two points at the
// same value are a step: the later one holds from that value on.
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
    // If set, curves are stretched so that this interval of their values falls on an interval of the volume's
    // (volume_fit.h), because MR values are not comparable across scanners.
    struct Fit {
        enum class To {
            foreground,  // the 2nd to the 98th percentile of the foreground
            valueRange,  // the smallest to the largest value
        };
        double low = 0.0;
        double high = 1.0;
        To to = To::foreground;

        bool operator==(const Fit&) const = default;
    };
    std::optional<Fit> fitToVolume = {};
    ColourSpace colourSpace = ColourSpace::rgb;
    // A factor of the opacity, over the length of the gradient in units per voxel of mean edge (units per mm
    // times the mean of the three spacings), as in VTK; sorted. Empty: 1 everywhere.
    std::vector<OpacityPoint> gradientOpacity = {};
    std::optional<ValueRange> effectiveRange = {};  // the relevant values: the range of sliders
    // The path tracer does not use these two; other programs that read toJson's text do.
    Lighting lighting = {};
    Interpolation interpolation = Interpolation::linear;
    std::optional<int> number = {};  // order in lists: 3D Slicer's are 1 to 31, Macula's begin at 101
    std::string source = {};         // the program that the curves come from: "3D Slicer"
    // The text of the JSON file that this was read from; toJson writes into it, so that keys unknown to
    // Macula survive. Empty if there is none.
    std::string document = {};

    bool operator==(const TransferFunction&) const = default;
};

// 0 to 1, at a value. Exact: curved pieces are evaluated, not approximated.
double opacityAt(const TransferFunction& function, double value);
// sRGB-encoded, 0 to 1, at a value.
glm::dvec3 colourAt(const TransferFunction& function, double value);
// 0 to 1, at the length of the gradient, which is 0 or above.
double gradientOpacityAt(const TransferFunction& function, double unitsPerVoxel);

// Whether the gradient opacity differs from 1 for any gradient, that is at 0 or above.
bool usesGradientOpacity(const TransferFunction& function);

// Whether steep matter has curves of its own.
bool usesSteepCurves(const TransferFunction& function);
// The part of matter, 0 to 1, that is steep at this length of the gradient, in units of the volume per mm.
double steepPartAt(const TransferFunction& function, double gradientPerMm);
// Swaps the curves of steep matter with the usual ones, so that code for one pair can read or edit the other.
TransferFunction withCurvesSwapped(TransferFunction function);

// sigma = -ln(1 - min(opacity, 0.999)) / unitDistanceMm * density, per millimetre. Opacity 1
// would be infinite; with the clamp, density 1 and 1 mm the densest matter has a mean free path of 0.14 mm.
double extinctionPerMm(const TransferFunction& function, double value);

// Fails with inputNotUsable if a curve is empty, not sorted or not finite, or a number is out of its range.
Result<void> validate(const TransferFunction& function);

// Whether the curves make sense for values of this unit: they have the same unit, are fitted to the whole
// range of values, or are raw and fitted to a foreground that is not in Hounsfield units.
bool suits(const TransferFunction& function, Unit unit);

// How a curve leads from one of its points to the next: the rule of vtkPiecewiseFunction and
// vtkColorTransferFunction, which files of 3D Slicer, ParaView and MITK share. `u` is the position between
// the values of both points, from 0 to 1.
//
// Maps `u` so that the midpoint lies at 0.5, then pushes it away from there by the power 1 + 10 sharpness.
// The result is 0 to 1. Below a sharpness of 0.01 nothing is pushed; above 0.99 the result is 0 or 1.
double warpedFraction(double u, double midpoint, double sharpness);

// The position between the heights of both points: a cubic Hermite curve over warpedFraction whose tangents
// flatten as the sharpness grows, and a line below a sharpness of 0.01. 0 to 1, and 0.5 at the midpoint.
double blendedFraction(double u, double midpoint, double sharpness);

}  // namespace macula
