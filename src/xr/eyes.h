// The cameras and pictures for the positions of the eyes. Knows no OpenXR.
#pragma once

#include <array>
#include <glm/glm.hpp>
#include <glm/gtc/quaternion.hpp>
#include <span>
#include <vector>

#include "base/camera.h"
#include "base/result.h"

namespace macula::xr {

// In the stage, the coordinates of the room that the headset knows: metres, +x right, +y up, -z ahead. A pose
// looks along its own -z, with its own +y up.
struct Pose {
    glm::dvec3 positionM{0.0};
    glm::dquat orientation{1.0, 0.0, 0.0, 0.0};
};
glm::dmat4 stageFromPose(const Pose& pose);
// False if a number is not finite, the orientation is not a rotation, or the position is kilometres away:
// runtimes may report such poses.
bool isUsable(const Pose& pose);

struct Eye {
    Pose pose;
    // Tangents of the angles from straight ahead to the sides of its field: left and down are below 0.
    double left = -1.0;
    double right = 1.0;
    double up = 1.0;
    double down = -1.0;
};

// The picture of an eye: a part of a picture with symmetric field, as cameras have it, because headsets see
// farther outwards than towards the nose. Whole pixels, so that the part is exact; `eye` has the sides of the
// part, which may be less than a pixel beyond the eye's field.
struct EyePicture {
    Camera camera;
    glm::ivec2 firstPx{0};  // the part's upper left pixel
    glm::ivec2 partPx{0};   // its size
    Eye eye;
};

// The pictures for both eyes, which have the same size and the same square pixels.
struct EyePictures {
    glm::ivec2 sizePx{0};  // of each whole picture
    std::vector<EyePicture> eyes;
    Camera centre;  // from between the eyes, with the same size and field
};

// `worldFromStage`: patient LPS in mm from the stage in metres, without mirror. No part is larger than
// `mostPx`. usage when a number is not finite, or an eye sees nothing or 170 degrees.
Result<EyePictures> picturesFor(std::span<const Eye> eyes, const glm::dmat4& worldFromStage,
                                const glm::ivec2& mostPx);

// Where the gaze from that pose meets the picture of `camera`, -1 to 1, right and up are positive; clamped to
// its border.
glm::dvec2 gazeIn(const Camera& camera, const glm::ivec2& sizePx, const glm::dmat4& worldFromStage,
                  const Pose& gaze);

}  // namespace macula::xr
