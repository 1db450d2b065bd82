// What a picture is drawn of, and with what.
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

namespace macula::app {

struct PictureRequest {
    StudyScene scene;
    // Patient LPS mm; nothing: one from `from`, of `verticalFovDeg`, that what can be seen fills.
    std::optional<Camera> camera;
    std::optional<ViewDirection> from = {};  // nothing: usualView
    double verticalFovDeg = 30.0;
    bool isParallel = false;  // of a camera that is made here
    glm::ivec2 sizePx{768};   // each from 1 to trace::kMaxPictureSide
    trace::Settings settings;
    bool metersExposure =
        false;  // settings.exposure is found for the picture (light_meter.h); not of projections
    // The number of samples; with Settings::errorThreshold about the most that are spent on noise.
    std::uint32_t samplesPerPixel = 64;
    bool keepUnfinished = false;  // with an errorThreshold: who stops it wants the picture as it is then
    bool isLinear = false;        // light and depth are wanted instead of what is displayed
    BackgroundColour background = kBlackBackground;  // of what is displayed
    bool isTransparent = false;                      // it has an alpha channel instead
    PictureEffects effects = {};
    trace::MemoryLimits memory;
};

}  // namespace macula::app
