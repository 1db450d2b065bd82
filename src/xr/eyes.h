// From where the eyes are to the cameras and pictures for them. Knows no OpenXR.
#pragma once

#include <array>
#include <glm/glm.hpp>
#include <glm/gtc/quaternion.hpp>
#include <span>
#include <vector>

#include "base/camera.h"
#include "base/result.h"

namespace macula::xr {

// In the stage, the room that the headset knows: metres, +x right, +y up, -z ahead. A pose looks along its
// own -z, with its own +y up.
struct Pose {
    glm::dvec3 positionM{0.0};
    glm::dquat orientation{1.0, 0.0, 0.0, 0.0};
};
glm::dmat4 stageFromPose(const Pose& pose);
// Not where a number is not finite, the turn is none, or it is kilometres away: a runtime may say so.
bool isUsable(const Pose& pose);

struct Eye {
    Pose pose;
    // Tangents of the angles from straight ahead to the sides of what it sees: left and down are below 0.
    double left = -1.0;
    double right = 1.0;
    double up = 1.0;
    double down = -1.0;
};

// What an eye is shown: a part of a picture that is the same to both sides, as cameras see it. Headsets see
// farther outwards than towards the nose. Whole pixels, so that what is cut out is exact; `eye` has the sides
// of the part, which may be less than a pixel outside of what the eye sees.
struct EyePicture {
    Camera camera;
    glm::ivec2 firstPx{0};  // of the part, from the top left
    glm::ivec2 partPx{0};   // its size
    Eye eye;
};

// For both eyes, with one size and square pixels of one size.
struct EyePictures {
    glm::ivec2 sizePx{0};  // of the whole pictures
    std::vector<EyePicture> eyes;
    Camera centre;  // from between the eyes, of that size and field
};

// `worldFromStage`: patient LPS in mm from the stage in metres, without mirror. No part is larger than
// `mostPx`. usage when a number is not finite, or an eye sees nothing or 170 degrees.
Result<EyePictures> picturesFor(std::span<const Eye> eyes, const glm::dmat4& worldFromStage,
                                const glm::ivec2& mostPx);

// Where a look from that pose meets the picture of `camera`, -1 to 1, right and up are positive; at its
// border where it passes it.
glm::dvec2 gazeIn(const Camera& camera, const glm::ivec2& sizePx, const glm::dmat4& worldFromStage,
                  const Pose& gaze);

}  // namespace macula::xr
