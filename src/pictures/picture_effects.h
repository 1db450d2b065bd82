// Effects of saved pictures that the window does not show: depth of field and fog.
#pragma once

#include <glm/glm.hpp>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "base/camera.h"
#include "base/result.h"
#include "pipeline/trace/guide_pixel.h"
#include "pipeline/trace/settings.h"

namespace macula::pictures {

struct PictureEffects {
    double lensMm = 0.0;  // diameter of trace::Lens; 0: no lens. Only for path-traced looks
    // Distance of the sharp plane from the camera, along its axis. Nothing: focusOfMiddle.
    std::optional<double> focusMm = {};
    double fogMm = 0.0;  // depth of the fog, see addFog; 0: no fog. Not for projections

    bool operator==(const PictureEffects&) const = default;
};

inline constexpr double kLeastFogMm = 1e-3;
inline constexpr double kMostFogMm = 1e6;

// usage for a number that is out of range.
Result<void> check(const PictureEffects& effects);

// "auto" gives nothing, other text a number in mm. usage for text that is neither.
Result<std::optional<double>> parseFocus(const std::string& typed);

// Focus distance in mm from the camera: the median depth along its axis in a disc at the middle, of radius
// height / 20. usage if the disc shows nothing, or the camera stands in the matter. `guides` has all pixels.
Result<double> focusOfMiddle(std::span<const trace::GuidePixel> guides, glm::ivec2 sizePx,
                             const Camera& camera);

// Distance in mm from the camera to the matter in each pixel: depthMm of the guide, or beforeMm if the matter
// is too thin for a depth; +infinity for an empty pixel. beforeMm belongs to the eye of the previous view, so
// the guides must come from a view without one (PathTracer::forgetViews).
std::vector<float> matterMm(std::span<const trace::GuidePixel> guides);

// Multiplies premultiplied radiance and coverage by exp(-d / fogMm), so that the background shows through; d
// is the distance behind the nearest matter, which stays unchanged (exponential fog, as in OpenGL and
// Akenine-Möller et al. 2018, "Real-Time Rendering", 14.5). Both spans have the same size.
void addFog(std::span<glm::vec4> radiance, std::span<const float> distancesMm, double fogMm);

}  // namespace macula::pictures
