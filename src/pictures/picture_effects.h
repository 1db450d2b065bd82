// What a picture that is saved may have beside what a window shows: the blur of a lens, and fog.
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

namespace macula::app {

struct PictureEffects {
    double lensMm = 0.0;  // diameter of trace::Lens; 0: none. Of path-traced looks
    // What is sharp, from the camera along its axis. Nothing: what the middle of the picture shows.
    std::optional<double> focusMm = {};
    double fogMm = 0.0;  // see addFog; 0: none. Not of projections

    bool operator==(const PictureEffects&) const = default;
};

inline constexpr double kLeastFogMm = 1e-3;
inline constexpr double kMostFogMm = 1e6;

// usage for a number that is out of range.
Result<void> check(const PictureEffects& effects);

// "auto" is nothing, else mm. usage for other text.
Result<std::optional<double>> parseFocus(const std::string& typed);

// Where the middle of a picture has its matter: the median along the camera's axis over a disc of a twentieth
// of its height, in mm from the camera. usage when nothing is seen there. `guides` are of all of its pixels.
Result<double> focusOfMiddle(std::span<const trace::GuidePixel> guides, glm::ivec2 sizePx,
                             const Camera& camera);

// How far from the camera what each pixel shows is: the depth of its guide, and of what is too thin for one
// the middle of what it adds; +infinity where nothing is seen. The guides must be those of a picture without
// one before it.
std::vector<float> matterMm(std::span<const trace::GuidePixel> guides);

// Fades premultiplied radiance and coverage alike, so that the background shows through: by 1 - exp(-d /
// fogMm) where d is how much farther away matter is than the nearest (exponential fog, as of OpenGL and of
// Akenine- Möller et al. 2018, "Real-Time Rendering", 14.5). What is nearest stays as it is. Both of one
// size.
void addFog(std::span<glm::vec4> radiance, std::span<const float> distancesMm, double fogMm);

}  // namespace macula::app
