// What a peripheral model learns from, and is judged by: a picture and its camera. It has no depth: thin
// matter has no single depth, and training with depths made two of three scenes worse
// (docs/peripheral-model.md).
#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "base/camera.h"

namespace macula::hybrid {

// The default width and height in pixels of training views, and of the pictures that models are compared
// with.
inline constexpr int kTrainingSizePx = 512;
// Their vertical field of view.
inline constexpr double kTrainingFieldDeg = 20.0;

struct TracedView {
    Camera camera;
    glm::ivec2 sizePx{0};         // columns, rows
    std::vector<glm::vec4> rgba;  // linear, premultiplied; row 0 on top
    double samplesPerPixel = 0.0;
    bool isLit = false;  // lit by what several views have found (training_set.h), so without noise of its
    // own
};

}  // namespace macula::hybrid
