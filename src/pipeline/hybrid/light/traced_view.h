// What a peripheral model learns from, and is judged by: a picture, and where it was seen from. Without
// depth: thin matter has no one depth, and what was tried with it made two of three scenes worse
// (docs/peripheral-model.md).
#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "base/camera.h"

namespace macula::hybrid {

// Width and height in pixels of what is learnt from, and of what models are compared with, unless somebody
// says otherwise.
inline constexpr int kTrainingSizePx = 512;
// Their vertical field of view.
inline constexpr double kTrainingFieldDeg = 20.0;

struct TracedView {
    Camera camera;
    glm::ivec2 sizePx{0};         // columns, rows
    std::vector<glm::vec4> rgba;  // linear, premultiplied; row 0 on top
    double samplesPerPixel = 0.0;
    bool isLit = false;  // marched through the light that several views found (training_set.h): it has no
                         // noise of its own
};

}  // namespace macula::hybrid
