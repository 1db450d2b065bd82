// The settings and the view of a traced picture.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

#include "base/camera.h"
#include "base/result.h"
#include "base/volume.h"
#include "pipeline/trace/look.h"

namespace macula::trace {

// How a value between voxels is found.
enum class Filter {
    trilinear,   // eight voxels, then the transfer function: the value a radiologist expects at an edge
    stochastic,  // one voxel drawn with the trilinear weights: faster; blends optics instead of values
    smooth,  // a cubic B-spline of 64 voxels: no kinks, which a steep curve shows as rings, and softer edges
    sharp,   // Mitchell and Netravali's spline of 64 voxels: a little sharper than trilinear values, without
             // kinks except where it is clamped to the range of these voxels
};
inline constexpr std::array kFilters{Filter::trilinear, Filter::stochastic, Filter::smooth, Filter::sharp};

// Whether values come from a spline, of 64 voxels.
constexpr bool isSpline(Filter filter) {
    return filter == Filter::smooth || filter == Filter::sharp;
}

// How many voxels beyond the eight around a position the filter reads on each side: BrickGrid::reach.
constexpr int reachOf(Filter filter) {
    return isSpline(filter) ? 1 : 0;
}

// The filter that a look really uses: rays cast through matter sample values deterministically, and
// projections interpolate linearly, so that a maximum is the value of a voxel.
constexpr Filter filterOf(Look look, Filter filter) {
    if (isPathTraced(look)) return filter;
    return look == Look::dvr && isSpline(filter) ? filter : Filter::trilinear;
}

// As in files and reports: "trilinear".
constexpr std::string_view nameOf(Filter filter) {
    switch (filter) {
        case Filter::trilinear:
            return "trilinear";
        case Filter::stochastic:
            return "stochastic";
        case Filter::smooth:
            return "smooth";
        case Filter::sharp:
            break;
    }
    return "sharp";
}

// How strongly displayed and read pictures are denoised (denoiser.h). It never changes what is traced, and
// looks other than path-traced ones have no noise.
enum class Denoising {
    off,
    little,  // one sweep of the filter instead of two: leaves more noise, and blurs less. For training views:
             // over many pictures noise averages out, and blur does not
    on,
};

constexpr std::string_view nameOf(Denoising denoising) {
    return denoising == Denoising::on       ? "denoised"
           : denoising == Denoising::little ? "denoised a little"
                                            : "plain";
}

// How path-traced looks find light that was scattered more than once. It is the larger part of a path's cost
// and of its noise, and varies little in space: a cache filled by paths (indirect_cache.h) can replace
// everything after the first vertex. Lights fixed to the camera change with every view and leave nothing to
// cache: with them all light is traced.
enum class Indirect {
    traced,  // by paths alone: the same picture each time, to the last bit. For pictures that people see
    cached,  // paths end at the cache where a cell has enough samples. One light stands for a whole cell,
             // which is a bias (docs/speed-and-accuracy.md). All light is traced if the phase function is not
             // isotropic
    corrected,  // the cache is a control variate: some paths continue at random and correct it. Unbiased
};

constexpr std::string_view nameOf(Indirect indirect) {
    return indirect == Indirect::traced ? "traced" : indirect == Indirect::cached ? "cached" : "corrected";
}

// The shading of ray casting, which has no lights.
enum class Shading {
    none,       // colours as the preset has them
    headlight,  // times ambient + diffuse |cos| to the gradient, with the preset's coefficients
};

// Raised whenever the same scene and settings give other light, apart from noise, or the denoiser blurs
// differently: models that learnt from pictures of another version are not trained further
// (live/store/model_key_of_drawing.h).
inline constexpr std::uint32_t kTracerVersion = 3;

inline constexpr int kMaxBounces = 1024;
// For pictures, training views and held-out views. Light scatters many times in white bone. 16 bounces have
// no more error in equal time; 8 show the first sample sooner, with most of the light
// (docs/speed-and-accuracy.md).
inline constexpr int kDefaultBounces = 8;
// The tone map: how it compresses light that is brighter than the display can show
// (shaders/lib/picture.glsl).
enum class ToneMap {
    neutral,  // Khronos PBR neutral: more contrast at an exposure of 1, and hues that turn a little
    hue,  // keeps hue and the order of lightness: leaves colours up to a middle lightness as they are, and
          // bleaches brighter ones in their own hue
};
inline constexpr std::array kToneMaps{ToneMap::neutral, ToneMap::hue};

// As in files and reports.
constexpr std::string_view nameOf(ToneMap map) {
    return map == ToneMap::neutral ? "neutral" : "hue";
}

inline constexpr double kMaxGain = 1e6;  // limit of exposure and of lightStrength
inline constexpr int kMaxPictureSide = 16384;

struct Settings {
    int bounces = kDefaultBounces;  // vertices of a path, 1 to kMaxBounces
    std::uint32_t seed = 0;
    Filter filter = Filter::trilinear;
    double exposure = 1.0;  // above 0; multiplies radiance before the tone map; projections undo it
    Denoising denoising = Denoising::off;
    Look look = Look::cinematic;
    // Turns the lights about their own up axis: what was at azimuth 0 is then at this azimuth, positive
    // towards the patient's left or, for lights fixed to the camera, towards the right of the picture.
    double lightRotationDeg = 0.0;
    double lightStrength = 1.0;       // 0 or above; multiplies the light
    Shading shading = Shading::none;  // of Look::dvr
    // traceFor() stops when the estimated standard error of the picture (display-encoded, 0 to 1) is at most
    // this; 0: never.
    double errorThreshold = 0.0;
    Indirect indirect = Indirect::traced;
    // The window of projections; if there is none, the series' first window, or else the full range of its
    // values.
    std::optional<DisplayWindow> window = {};
    ToneMap toneMap = ToneMap::neutral;  // projections undo it, as they do the exposure

    bool operator==(const Settings&) const = default;
};

// Whether the picture of these settings is denoised.
constexpr bool isDenoised(const Settings& settings) {
    return settings.denoising != Denoising::off && isPathTraced(settings.look);
}

// The vertices of a path: the clear look scatters once.
constexpr int verticesOf(const Settings& settings) {
    return settings.look == Look::clear ? 1 : settings.bounces;
}

// The field of view that the tracer draws for the fovea.
inline constexpr double kFovealFieldDeg = 20.0;

// A picture that is stored larger where the eye looks: see shaders/lib/fovea.glsl.
struct Foveation {
    glm::dvec2 gaze{0.0};               // in the picture: -1 to 1, right and up are positive
    double fieldDeg = kFovealFieldDeg;  // of the magnified part; less near the picture's edge
    double magnification = 2.5;         // 1 to 16: how many times more pixels along each side
};

// A thin lens in the place of the eye: points at the distance of its focus are sharp, all others are blurred
// (Potmesil and Chakravarty 1981, "A lens and aperture camera model for synthetic image generation"). A point
// at distance z becomes a disc whose diameter, measured at the focus, is |z - focus| / z times that of the
// lens; with parallel rays |z - focus| / focus times. For path-traced looks only; guides use the same lens.
struct Lens {
    double diameterMm = 0.0;  // 0: none, all is sharp
    double focusMm = 0.0;     // above 0; from the camera, along its axis

    bool operator==(const Lens&) const = default;
};
inline constexpr double kMostLensMm = 1e4;
inline constexpr double kMostFocusMm = 1e6;

// What one picture shows.
struct View {
    Camera camera;
    int width = 512;  // pixels, 1 to kMaxPictureSide
    int height = 512;
    std::optional<Foveation> foveation = {};
    Lens lens = {};
};

// An unfoveated view of the surroundings of a point in another view's picture, with the same eye and up: a
// square of `pixels` on each side with a field of view of `fieldDeg`. `gaze` is as in Foveation, in the
// picture as displayed. Fails with usage for a parallel view.
Result<View> fovealWindow(const View& view, const glm::dvec2& gaze, double fieldDeg = kFovealFieldDeg,
                          int pixels = 512);

}  // namespace macula::trace
