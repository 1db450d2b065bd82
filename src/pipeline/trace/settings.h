// What a traced picture is made with.
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
             // kinks but where it is held to the range of these voxels
};
inline constexpr std::array kFilters{Filter::trilinear, Filter::stochastic, Filter::smooth, Filter::sharp};

// Whether values come from a spline, of 64 voxels.
constexpr bool isSpline(Filter filter) {
    return filter == Filter::smooth || filter == Filter::sharp;
}

// How many voxels beside the eight around its place a value may be taken from: BrickGrid::reach.
constexpr int reachOf(Filter filter) {
    return isSpline(filter) ? 1 : 0;
}

// What of it a look makes use of: rays that are cast through matter take values without chance, and
// projections show those that interpolation gives, so that a maximum is that of a voxel.
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

// How far what is shown and read is filtered, see denoiser.h. It never changes what is traced, and looks
// without chance have no noise to filter.
enum class Denoising {
    off,
    little,  // one sweep of the filter instead of two: what is left of noise stays, and less is blurred. For
             // those who learn from many pictures: noise is another in each of them, blur the same in all
    on,
};

constexpr std::string_view nameOf(Denoising denoising) {
    return denoising == Denoising::on       ? "denoised"
           : denoising == Denoising::little ? "denoised a little"
                                            : "plain";
}

// Where light comes from that has been scattered more than once, in path-traced looks. It is the larger part
// of what a path costs and of its noise, and differs little from place to place: a cache of it, filled by
// paths (indirect_cache.h), can stand for all that follows on the first vertex. Lights that hang on the
// camera leave nothing to be kept: with them all is traced.
enum class Indirect {
    traced,     // from paths alone: the same picture each time, to the last bit. What people see
    cached,     // paths end where the cache knows enough. Matter of one kind has the same light all over a
                // cell, which is a bias (docs/speed-and-accuracy.md). All is
                // traced where the phase function is not isotropic
    corrected,  // the cache is a control variate: paths go on by chance, and tell how wrong it is. Unbiased
};

constexpr std::string_view nameOf(Indirect indirect) {
    return indirect == Indirect::traced ? "traced" : indirect == Indirect::cached ? "cached" : "corrected";
}

// The shading of ray casting, which has no lights.
enum class Shading {
    none,       // colours as the preset has them
    headlight,  // times ambient + diffuse |cos| to the gradient, with the preset's coefficients
};

// Raised whenever the same scene and settings get other light, chance aside, or the filter another blur:
// what was learnt from pictures of another version is not gone on with (live/store/model_key_of_drawing.h).
inline constexpr std::uint32_t kTracerVersion = 3;

inline constexpr int kMaxBounces = 1024;
// Of pictures, of views to learn from, and of what models are compared with. White bone passes light on many
// times. 16 have no more error in equal time; 8 show the first sample sooner, with most of their light
// (docs/speed-and-accuracy.md).
inline constexpr int kDefaultBounces = 8;
// The tone map: how it compresses light that is brighter than the display can show
// (shaders/lib/picture.glsl).
enum class ToneMap {
    neutral,  // Khronos PBR neutral: more contrast at an exposure of 1, and hues that turn a little
    hue,      // keeps hue and the order of lightness: colours as they are up to a middle lightness, and what
              // is brighter bleaches in its own hue
};
inline constexpr std::array kToneMaps{ToneMap::neutral, ToneMap::hue};

// As in files and reports.
constexpr std::string_view nameOf(ToneMap map) {
    return map == ToneMap::neutral ? "neutral" : "hue";
}

inline constexpr double kMaxGain = 1e6;  // of exposure and strength of light
inline constexpr int kMaxPictureSide = 16384;

struct Settings {
    int bounces = kDefaultBounces;  // vertices of a path, 1 to kMaxBounces
    std::uint32_t seed = 0;
    Filter filter = Filter::trilinear;
    double exposure = 1.0;  // above 0; multiplies radiance before the tone map; projections undo it
    Denoising denoising = Denoising::off;
    Look look = Look::cinematic;
    // Turns the lights about their own up axis: what was at azimuth 0 is then at this azimuth, positive
    // towards the patient's left or, for lights that hang on the camera, towards the right of the picture.
    double lightRotationDeg = 0.0;
    double lightStrength = 1.0;       // 0 or above; multiplies the light
    Shading shading = Shading::none;  // of Look::dvr
    // traceFor() stops when the standard error of what is shown (display-encoded, 0 to 1) is estimated to be
    // at most this; 0: never.
    double errorThreshold = 0.0;
    Indirect indirect = Indirect::traced;
    // What projections are seen through; else the series' first window, else all of its values.
    std::optional<DisplayWindow> window = {};
    ToneMap toneMap = ToneMap::neutral;  // projections undo it, as they do the exposure

    bool operator==(const Settings&) const = default;
};

// Whether the picture of these settings is denoised.
constexpr bool isDenoised(const Settings& settings) {
    return settings.denoising != Denoising::off && isPathTraced(settings.look);
}

// Of a path of these settings: the clear look scatters once.
constexpr int verticesOf(const Settings& settings) {
    return settings.look == Look::clear ? 1 : settings.bounces;
}

// The field of view of what the tracer draws for the fovea.
inline constexpr double kFovealFieldDeg = 20.0;

// A picture that is stored larger where the eye looks: see shaders/lib/fovea.glsl.
struct Foveation {
    glm::dvec2 gaze{0.0};               // in the picture: -1 to 1, right and up are positive
    double fieldDeg = kFovealFieldDeg;  // of what is magnified; less where there is no room
    double magnification = 2.5;         // 1 to 16: how many times more pixels along each side
};

// A thin lens in the place of the eye: what lies at the distance of its focus is sharp, all else is blurred
// (Potmesil and Chakravarty 1981, "A lens and aperture camera model for synthetic image generation"). A point
// at distance z is a disc of diameter |z - focus| / z of that of the lens, measured at the focus; under
// parallel rays |z - focus| / focus. Of path-traced looks; the guides see through the same lens.
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

// A plain picture of what lies around a point of another view's picture: `gaze` as in Foveation, `fieldDeg`
// the field of view of a square of `pixels` on each side. Same eye, same up. The point is of the picture as
// seen.
Result<View> fovealWindow(const View& view, const glm::dvec2& gaze, double fieldDeg = kFovealFieldDeg,
                          int pixels = 512);

}  // namespace macula::trace
