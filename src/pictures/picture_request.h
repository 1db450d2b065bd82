// The scene, camera and settings of a picture to draw.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <optional>

#include "base/camera.h"
#include "base/frames.h"
#include "live/device/scene_on_device.h"
#include "pictures/picture_effects.h"
#include "pipeline/trace/path_tracer.h"
#include "scene/lights/background_colour.h"

namespace macula::pictures {

struct PictureRequest {
    live::StudyScene scene;
    // Patient LPS mm; nothing: fitted to what is visible, from `from`, with `verticalFovDeg`.
    std::optional<Camera> camera;
    std::optional<ViewDirection> from = {};  // nothing: usualView
    double verticalFovDeg = 30.0;
    bool isParallel = false;  // for a camera that is fitted here
    glm::ivec2 sizePx{768};   // each from 1 to trace::kMaxPictureSide
    trace::Settings settings;
    bool metersExposure = false;  // meters settings.exposure (light_meter.h); not for projections
    // The number of samples; with Settings::errorThreshold, about the limit of their mean over all pixels.
    std::uint32_t samplesPerPixel = 64;
    bool keepUnfinished = false;  // with an errorThreshold: stopping keeps the picture as it is then
    bool isLinear = false;        // returns linear radiance and depth instead of display values
    scene::BackgroundColour background = scene::kBlackBackground;  // behind display values
    bool isTransparent = false;  // returns an alpha channel instead of the background
    PictureEffects effects = {};
    trace::MemoryLimits memory;
};

}  // namespace macula::pictures
